"""The typed way against good and bad models: forms, corrective retry, fallback, budget, cancellation."""

import asyncio
import json
import threading
from types import SimpleNamespace

import pytest

from c2s_engine.interpret.llm import interpret
from c2s_engine.interpret.llm.answers import json_object
from c2s_engine.interpret.llm.schema import accepts
from c2s_engine.interpret.llm.units import annotate
from c2s_engine.models import approximate_tokens, errors
from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import references
from c2s_engine.structure.progress import Say, Usage
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Placement
from tests.models.answers import COMPONENTS, FORMS, TEXT, asked_of, sensible
from tests.models.backends import BAD, BAD_NAMES, random_json, wordy
from tests.models.fake_ollama import Answer, FakeOllama, endless, said


def plain(text: str) -> SimpleNamespace:
    """A reader of two sentences, so that what stands in is known."""
    ped = ObjectSpec(name="walker", type="pedestrian", placement=Placement(position="sidewalk", hidden_by="O2"))
    truck = ObjectSpec(name="lorry", type="truck", placement=Placement(position="parked", side="right"))
    structure = Structure(
        text=text,
        ego=Component(id="E", spec=EgoSpec(speed=10, react_to="O1")),
        objects=(
            Component(id="O1", description="A pedestrian.", spec=ped),
            Component(id="O2", description="A truck.", spec=truck),
        ),
    )
    return SimpleNamespace(structure=structure)


def restore(reading) -> Structure:
    """A structure that went through JSON: nothing in it is of a wrong type."""
    return Structure.model_validate_json(reading.structure.model_dump_json())


async def test_a_good_model_fills_every_form(server, client_of):
    server.respond = sensible
    events = []
    async with client_of(server) as client:
        reading = await interpret(TEXT, client=client, reader=plain, on_event=events.append)
    s = restore(reading)
    assert reading.fallbacks == {} and reading.share == 1 and reading.notes == ()
    assert s.settings.spec.weather == ("heavy_rain",) and s.settings.spec.time == "night"
    assert s.place.spec.lanes == 2 and s.ego.spec.hard and s.ego.spec.react_to == "O1"
    assert [o.spec.type for o in s.objects] == ["van", "truck", "pedestrian"]
    assert s["O3"].spec.placement.hidden_by == "O2"
    assert s["O1"].links[0].label in TEXT and TEXT[slice(*s["O1"].links[0].span)].strip() == s["O1"].links[0].label
    assert {e.purpose for e in events if isinstance(e, Usage)} == {"interpret", "settings", "place", "ego", "object"}


async def test_a_scenario_of_median_length_costs_at_most_8000_tokens(server, client_of):
    """The 123 texts have a median of about 60 words; this one has 70. Four characters count as one token."""
    server.respond = sensible
    async with client_of(server) as client:
        await interpret(TEXT, client=client, reader=plain)
    prompts = sum(approximate_tokens(said(r)) for r in server.requests)
    answers = sum(approximate_tokens(sensible(r)) for r in server.requests)
    assert 1000 < prompts + answers <= 8000, prompts + answers
    assert max(approximate_tokens(said(r)) for r in server.requests) < 8192 - 1536


async def test_the_fault_is_told_once_and_mended(server, client_of):
    wrong = {"R": {"kind": "highway to hell"}, "E": {"speed": 500}}

    def respond(request):
        cid = asked_of(request)
        again = any(m["role"] == "assistant" for m in request["messages"])
        return json.dumps(wrong[cid]) if cid in wrong and not again else sensible(request)

    server.respond = respond
    async with client_of(server) as client:
        reading = await interpret(TEXT, client=client, reader=plain)
    assert not reading.fallbacks
    told = [r["messages"][-1]["content"] for r in server.requests if len(r["messages"]) == 4]
    assert len(told) == 2 and "highway to hell" in told[0] and "speed must lie between 0 and 50" in told[1]
    assert client.ledger.by("purpose")["place again"].calls == 1


async def test_sentences_copied_from_the_instructions_are_refused(server, client_of):
    """Seen with a real model of 135M parameters: it tells the examples of its instructions instead of the text."""
    copied = {
        **COMPONENTS,
        "objects": [
            {
                "type": "car",
                "sentence": "A car comes from the opposite approach, runs the red light and hits ego.",
            }
        ],
    }
    answers = [copied, COMPONENTS]

    def respond(request):
        return sensible(request) if asked_of(request) else json.dumps(answers.pop(0) if answers else copied)

    server.respond = respond
    async with client_of(server) as client:
        reading = await interpret(TEXT, client=client, reader=plain)
        assert not reading.fallbacks and client.ledger.by("purpose")["interpret again"].calls == 1
        assert "the text does not say it" in said(server.requests[1])
        again = await interpret(TEXT, client=client, reader=plain)
    assert set(again.fallbacks) == set(again.structure.ids) and "is of the example" in again.notes[0]


async def test_an_example_that_is_the_text_s_own_stands(server, client_of):
    text = "It is dusk. A car comes from the opposite approach, runs the red light and hits ego, which drives on."
    told = {"settings": "It is dusk.", "ego": "Ego drives on.", "objects": [
        {"type": "car", "sentence": "A car comes from the opposite approach, runs the red light and hits ego."}
    ] * 3}  # fmt: skip
    server.respond = lambda request: "{}" if asked_of(request) else json.dumps(told)
    async with client_of(server) as client:
        reading = await interpret(text, client=client, reader=plain)
    (once,) = reading.structure.objects
    assert once.links[0].label.startswith("A car comes from the opposite approach"), "said thrice, is one"


async def test_what_cannot_be_used_is_the_readers_answer_marked_and_counted(server, client_of):
    server.respond = lambda request: sensible(request) if asked_of(request) not in ("E", "O3") else "no idea"
    events = []
    async with client_of(server) as client:
        reading = await interpret(TEXT, client=client, reader=plain, on_event=events.append)
    s = restore(reading)
    assert set(reading.fallbacks) == {"E", "O3"} and reading.share == pytest.approx(5 / 7)
    assert s["O3"].spec.name == "walker", "the reader pedestrian stands in for the model's"
    assert s["O3"].spec.placement.hidden_by == "O2" and s["O2"].spec.name == "truck", "numbered as the model numbers"
    assert s.ego.spec.speed == 10 and s.ego.spec.react_to == "O3"
    assert any(a.field == "*" for a in s["O3"].assumed) and not s["O1"].assumed
    assert [e.severity for e in events if isinstance(e, Say)] == ["warning"]


@pytest.mark.parametrize("name", BAD_NAMES)
async def test_bad_models_leave_the_readers_reading(server, client_of, name):
    server.respond = BAD[name](0)
    async with client_of(server, answer_tokens=200) as client:
        reading = await interpret(TEXT, client=client, reader=plain)
    assert restore(reading).objects, "there is always something to write"
    assert reading.fallbacks and reading.notes and all("\n" not in n for n in reading.notes)
    assert len(server.requests) <= 30


async def test_a_dead_server_is_asked_once(client_of):
    with FakeOllama() as gone:
        pass
    async with client_of(gone) as client:
        reading = await interpret(TEXT, client=client, reader=plain)
    assert reading.share == 0 and "Ollama does not answer" in reading.notes[0]
    assert [r.outcome for r in client.ledger.rows] == ["ModelUnavailable"]


async def test_a_server_that_dies_between_is_not_waited_for_again(server, client_of):
    server.respond = lambda r: sensible(r) if asked_of(r) != "E" else Answer(status=400, error="gone")
    async with client_of(server) as client:
        reading = await interpret(TEXT, client=client, reader=plain)
    assert set(reading.fallbacks) == {"E", "O1", "O2", "O3"}
    assert len(server.requests) == 4


@pytest.mark.parametrize("seed", [*range(6), *(pytest.param(i, marks=pytest.mark.full) for i in range(6, 30))])
async def test_random_forms_are_all_taken(server, client_of, seed):
    server.respond = (wordy if seed % 5 == 0 else random_json)(seed)
    async with client_of(server) as client:
        reading = await interpret(TEXT, client=client, reader=plain)
    s = restore(reading)
    assert reading.fallbacks == {}
    assert len({o.spec.name for o in s.objects}) == len(s.objects)
    for component in s.components:
        assert references(component) <= set(s.ids)


async def test_cancelling_in_mid_stream_stops_the_model(server, client_of):
    hold = threading.Event()
    server.respond = lambda request: Answer(endless('{"objects": ['), hold=hold)
    async with client_of(server) as client:
        task = asyncio.create_task(interpret(TEXT, client=client, reader=plain))
        assert await asyncio.to_thread(server.streaming.wait, 5)
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
        assert await asyncio.to_thread(server.disconnected.wait, 5)
    assert len(server.requests) == 1


async def test_settings_below_the_confidence_are_defaults_and_said(server, client_of):
    form = {"weather": {"value": ["rain"], "confidence": 0.59}, "time": {"value": "dusk", "confidence": 0.6}}
    server.respond = lambda r: json.dumps(form) if asked_of(r) == "G" else sensible(r)
    async with client_of(server) as client:
        s = (await interpret(TEXT, client=client, reader=plain)).structure
    assert s.settings.spec.weather == () and s.settings.spec.time == "dusk"
    assert [a.field for a in s.settings.assumed] == ["weather"] and "0.59" in s.settings.assumed[0].reason


async def test_forms_offer_only_what_can_be_said(server, client_of):
    server.respond = sensible
    async with client_of(server) as client:
        await interpret(TEXT, client=client, reader=plain)
    forms = {asked_of(r): r["format"] for r in server.requests}
    person = forms["O3"]["properties"]
    assert "cross_road" in person["phases"]["items"]["properties"]["action"]["enum"]
    assert "lane_change" not in person["phases"]["items"]["properties"]["action"]["enum"]
    assert person["placement"]["properties"]["hidden_by"]["enum"] == ["O1", "O2"]
    assert set(person["type"]["enum"]) == {"pedestrian", "child", "animal"}
    assert "model" not in forms["E"]["properties"], "no blueprint stands in the text"
    for cid, form in FORMS.items():
        assert accepts(forms[cid], form) == ""
    assert set(forms["R"]["properties"]["kind"]["enum"]) == set(v.PlaceKind.__args__)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ('{"a": 1}', {"a": 1}),
        ('<think>{"a": 2}</think>\n```json\n{"a": 1}\n```', {"a": 1}),
        ('Sure! {"a": 1} Anything else?', {"a": 1}),
        ('{"a": 1}{"a": 1}{"a": 1}', {"a": 1}),
    ],
)
def test_json_is_found_in_answers(text, value):
    assert json_object(text) == value


@pytest.mark.parametrize("text", ["", "no", "[1, 2]", '{"a": ', "<think>for ever", "{" * 5000])
def test_what_is_no_json_object_is_said(text):
    with pytest.raises(errors.AnswerUnusable):
        json_object(text)


def test_quantities_get_their_si_values():
    assert annotate("from 50 km/h to 30 mph within 100 ft") == (
        "from 50 km/h [= 13.9 m/s] to 30 mph [= 13.4 m/s] within 100 ft [= 30.5 m]"
    )
    assert annotate("60 to 80 km/h, 20 m ahead") == "60 to 80 km/h [= 16.7 to 22.2 m/s], 20 m ahead"
