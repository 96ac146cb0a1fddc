"""What models met that filled in the forms by hand: reactions beside phases, intersections, sides, the aftermath, the
settings said in passing, what is not told, what it all costs."""

import json
import statistics

import pytest

from c2s_engine.interpret.llm import interpret
from c2s_engine.interpret.llm.components import ObjectSentence, Sentences, instructions
from c2s_engine.interpret.llm.forms import Form, form_of
from c2s_engine.interpret.llm.schema import accepts
from c2s_engine.structure.specs import Trigger
from tests.models.answers import asked_of
from tests.models.measure_tokens import costs
from tests.models.test_llm_typed import plain


def form(cid: str, text: str) -> Form:
    told = tuple(ObjectSentence(type=t, sentence=text) for t in ("van", "car"))
    return form_of(cid, text, Sentences(place=text, ego=text, objects=told))


def examples(asked: Form) -> list[dict]:
    return [json.loads(line) for line in asked.system.splitlines() if line.startswith("{")]


def test_a_reaction_is_no_phase_by_rule_and_by_example():
    ego = form("E", "Ego drives.")
    assert "- reaction: how it reacts to what others do; never also a phase" in ego.system
    assert any(
        e.get("reaction") == "brake" and [p["action"] for p in e["phases"]] == ["lane_change"] for e in examples(ego)
    )


@pytest.mark.parametrize(
    ("cid", "text"), [("R", "Ego turns right at a junction."), ("O2", "A car runs its red light.")]
)
def test_who_comes_to_an_intersection_is_shown_one(cid, text):
    assert "intersection" in "".join(line for line in form(cid, text).system.splitlines() if line.startswith("Example"))
    assert "intersection" in instructions().partition("Example.")[2]


def test_where_ego_turns_sides_are_those_of_the_start():
    assert "- placement: where it starts, sides as ego sees them at first" in form("O1", "Ego turns left.").system


@pytest.mark.parametrize(
    ("cid", "text", "answer"),
    [
        ("R", "Somewhere.", {}),
        ("E", "Ego is there.", {}),
        ("O2", "It cuts in.", {"phases": [{"action": "cut_in"}]}),
        ("O2", "It changes lanes.", {"phases": [{"action": "lane_change"}]}),
        ("O2", "It walks slowly.", {"pace": "slow"}),
        ("O2", "It brakes abruptly.", {"phases": [{"action": "brake", "rate": 7}]}),
        ("O2", "It drifts abruptly over the line.", {"phases": [{"action": "drift", "lateral_speed": 2}]}),
        ("O2", "It stands 5 m behind the van.", {"placement": {"position": "behind", "of": "O1", "gap": 5}}),
        ("O2", "It blocks the junction.",
         {"phases": [{"action": "stop", "trigger": {"kind": "place", "place": "intersection"}}]}),
        ("O2", "It hits the van's rear.",
         {"phases": [{"action": "collide", "target": "O1", "part": "front", "target_part": "rear"}]}),
        ("E", "Ego speeds.", {"pace": "over_limit"}),
    ],
)  # fmt: skip
def test_what_a_text_tells_has_a_field_and_what_it_does_not_is_not_forced(cid, text, answer):
    asked = form(cid, text)
    needed = {"name": "it", "type": "car", "placement": {"position": "ahead"}} if cid == "O2" else {}
    assert accepts(asked.schema, {**needed, **answer}) == ""


def test_the_splitter_is_told_of_the_aftermath():
    assert "Leave out what comes after the events (police, ambulances, damage)" in instructions()


@pytest.mark.parametrize(
    ("text", "weather"), [("A car brakes ahead of ego in the rain.", ("rain",)), ("A car brakes.", ())]
)
async def test_settings_that_the_splitter_missed_are_detected(server, client_of, text, weather):
    split = {"settings": "", "ego": "Ego drives.", "objects": [{"type": "car", "sentence": "A car brakes."}]}
    rain = {"weather": {"value": ["rain"], "confidence": 1}}
    car = {"name": "car", "type": "car", "placement": {"position": "ahead"}}
    forms = {"": split, "G": rain, "E": {}, "O1": car}
    server.respond = lambda request: json.dumps(forms[asked_of(request)])
    async with client_of(server) as client:
        reading = await interpret(text, client=client, reader=plain)
    assert not reading.fallbacks and reading.structure.settings.spec.weather == weather
    assert ("G" in map(asked_of, server.requests)) == bool(weather)


@pytest.mark.parametrize(
    ("text", "change", "when"),
    [
        ("5 s in, red gives way to green.", {"to": "green", "kind": "time", "value": 5}, {"kind": "time", "value": 5}),
        ("30 m short of the line ego sees its signal go to amber.", {"to": "yellow", "kind": "place", "value": 30},
         {"kind": "place", "value": 30, "place": "stop_line"}),
    ],
)  # fmt: skip
async def test_a_light_that_changes_can_be_told_in_any_words(server, client_of, text, change, when):
    certain = {"light": {"value": "red", "confidence": 1}, "light_changes": {"value": [change], "confidence": 1}}
    forms = {"": {"ego": "Ego drives.", "objects": []}, "G": certain, "E": {}}
    server.respond = lambda request: json.dumps(forms[asked_of(request)])
    async with client_of(server) as client:
        reading = await interpret(text, client=client, reader=plain)
    spec = reading.structure.settings.spec
    assert not reading.fallbacks and spec.light == "red"
    assert [(c.to, c.when) for c in spec.light_changes] == [(change["to"], Trigger(**when))]


@pytest.mark.full
async def test_what_a_text_of_median_length_costs():
    by_characters = [characters for characters, _ in await costs()]
    assert len(by_characters) == 24
    assert statistics.median(by_characters) <= 3200 and max(by_characters) <= 5000
