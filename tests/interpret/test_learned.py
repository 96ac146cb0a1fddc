"""The learned reader: its notation, what is made of answers that are wrong, and the model itself."""

import math
import random
import re
import string
from pathlib import Path

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from c2s_engine.interpret import InterpretError
from c2s_engine.interpret.learned import Answer, ReaderError, asked, installed, learned, loaded, reading
from c2s_engine.interpret.learned.decoder import base
from c2s_engine.interpret.learned.notation import left_out, parse, short, with_left_out
from c2s_engine.interpret.learned.quantities import si
from c2s_engine.interpret.learned.reader import BEYOND, CHECK, MOST_WORDS, NAMED, NO_SCENARIO, NOT_USED, structure_of
from c2s_engine.interpret.learned.units import quantities, rooms_in_seconds
from c2s_engine.structure.account import UNSAID, account
from c2s_engine.structure.progress import Finished
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, SettingsSpec

TEXT = "Ego drives at 50 km/h in the rain. A child runs out from behind a parked van on the right 20 m ahead."
ANSWER = """G: time=night
R: road oncoming=yes
E: car hard speed=50km/h reaction=brake react_to=O2
O1: van at=parked side=right speed=0 ; stationary
O2: child at=roadside side=right hidden_by=O1 pace=run ; cross_road @distance of=ego value=20m"""
needs_model = pytest.mark.skipif(not installed(), reason="the learned reader's packages are missing")
CASES = yaml.safe_load((Path(__file__).parent / "answers.yaml").read_text(encoding="utf-8"))


@pytest.mark.parametrize(("said", "value"), [
    ("50km/h", 13.889), ("30 mph", 13.411), ("80ft", 24.384), ("0.4g", 3.924), ("30-40km/h", [8.333, 11.111]),
    ("-0.5s", -0.5), ("4m/s2", 4.0), ("ahead", "ahead"), ("5parsec", "5parsec"), (0, 0),
])  # fmt: skip
def test_quantities(said, value):
    assert si(said) == value


@pytest.mark.parametrize(("text", "found"), [
    ("After five seconds a car 20 m ahead brakes.", {"five seconds": 5, "20 m": 20}),
    ("Twenty-five metres, one hundred metres", {"Twenty-five metres": 25, "one hundred metres": 100}),
    ("a 20-metre gap", {"20-metre": 20}),
    ("30mph, forty miles per hour, 60 kmh", {"30mph": 13.411, "forty miles per hour": 17.882, "60 kmh": 16.667}),
    ("The second car brakes at 3 m/s2; one more second, two trucks.", {"3 m/s2": 3}),
])  # fmt: skip
def test_quantities_of_a_text_in_digits_and_in_words(text, found):
    assert {text[a:b]: value for (a, b), value, _ in quantities(text)} == found


@pytest.mark.parametrize(("text", "gap"), [
    ("Ego follows at 72 km/h with a headway of 1.5 s.", "1.5s"), ("A 1.5-second gap at 72 km/h.", "1.5s"),
    ("1.5 s later it stops 1.5 m short.", "1.5m"), ("It follows 1.5 metres behind.", "1.5m"), ("It is near.", "1.5m"),
])  # fmt: skip
def test_a_room_has_the_unit_that_its_number_has_in_the_text(text, gap):
    answer = "O1: car at=ahead gap={} ; stop clearance=4m @distance of=ego value=20m"
    assert rooms_in_seconds(answer.format("1.5m"), text) == answer.format(gap)


def test_a_headway_that_was_read_as_metres_is_a_headway():
    text = "The test vehicle follows a car at 72 km/h with a headway of 1.5 s."
    found = reading("R: road\nE: car speed=72km/h ; follow target=O1\nO1: car at=ahead gap=1.5m", text)
    assert found is not None and found["O1"].spec.placement.gap == 30.0


def test_the_notation_is_read_as_it_is_written():
    data = parse(ANSWER)
    assert short(data) == ANSWER
    assert data["O2"]["phases"] == [
        {"action": "cross_road", "trigger": {"kind": "distance", "of": "ego", "value": "20m"}}
    ]


@pytest.mark.full
def test_every_scene_of_the_training_data_is_written_and_read_back():
    from c2s_bench.reading.scenes import scenes

    chosen = random.Random(1).sample(list(scenes()), 300)
    for scene in chosen:
        written = short(scene.components)
        assert short(parse(written)) == written, scene.id
        structure = structure_of(parse(written), scene.texts[0])
        assert not [u for c in structure.components for u in c.unmet], scene.id


def test_an_answer_becomes_s():
    structure = structure_of(parse(ANSWER), TEXT)
    ego, child = structure.ego.spec, structure["O2"].spec
    assert isinstance(ego, EgoSpec) and ego.hard and ego.speed == pytest.approx(13.889) and ego.react_to == "O2"
    assert isinstance(child, ObjectSpec) and child.placement.hidden_by == "O1" and child.phases[0].trigger.value == 20


@pytest.mark.parametrize("case", CASES, ids=[c["name"] for c in CASES])
def test_what_fits_no_field_is_left_out_and_noted(case):
    structure = structure_of(parse(case["answer"]), TEXT)
    assert [c.id for c in structure.objects] == case["objects"]
    lost = [u for c in structure.components for u in c.unmet]
    assert all(u.reason == NOT_USED for u in lost) and [u.text for u in lost] == case["lost"]


@given(st.text(alphabet=string.ascii_letters + string.digits + " :;@^=_./,-\n", max_size=400))
def test_whatever_is_answered_is_some_s(answer):
    structure = structure_of(parse(f"{ANSWER}\n{answer}"), TEXT)
    assert structure.text == TEXT and len(structure.objects) >= 2


def test_a_text_is_asked_on_one_line_and_its_weather_is_read_by_rule():
    assert asked("Ego drives\n  at 50 km/h.") == "Ego drives at 50 km/h."
    found = reading(ANSWER, TEXT)
    assert found is not None and found.settings.spec.weather == ("rain",)
    assert [o.spec.name for o in found.objects] == ["van", "child"]


def test_what_is_found_by_table_and_what_the_model_says():
    text = "At dusk in the rain ego drives up to a red light. The light turns green after 4 s. A van ahead brakes hard."
    answer = """G: time=night light=red ; to=green @time value=4s
R: intersection control=signal
E: car speed=0
O1: van at=ahead ; brake"""
    found = reading(answer, text)
    changes = ({"to": "green", "when": {"kind": "time", "value": 4}},)
    settings = SettingsSpec(weather=("rain",), time="night", light="red", light_changes=changes)
    assert found is not None and found.settings.spec == settings
    braking = found["O1"].spec.phases[0]
    assert braking.action == "brake" and braking.rate == 6.0, "hard"
    assert [(a.field, a.by) for a in found["O1"].assumed] == [("phases.0.rate", "words")]


def test_night_that_the_model_passes_over_is_found():
    found = reading("R: road\nE: car ; brake", "Last night ego braked gently.")
    assert found is not None and found.settings.spec.time == "night" and found.ego.spec.phases[0].rate == 2.5


@pytest.mark.parametrize(("text", "field", "value"), [
    ("Town05, ClearNoon, ego vehicle.audi.tt: a car ahead brakes.", "G.map", "Town05"),
    ("Town05, ClearNoon, ego vehicle.audi.tt: a car ahead brakes.", "G.preset", "ClearNoon"),
    ("Town05, ClearNoon, ego vehicle.audi.tt: a car ahead brakes.", "E.model", "vehicle.audi.tt"),
    ("Thick fog. A car ahead brakes.", "G.weather", ("fog",)), ("No rain. A car ahead brakes.", "G.weather", ()),
    ("At 23:10 a car ahead brakes.", "G.time", "night"),
    ("Heavy rain: a car ahead brakes.", "G.weather", ("heavy_rain",)),
])  # fmt: skip
def test_settings_of_a_text(text, field, value):
    found = reading("E: car\nO1: car at=ahead ; brake", text)
    cid, _, path = field.partition(".")
    assert found is not None and getattr(found[cid].spec, path) == value
    assert value == () or any(li.field == path for li in found[cid].links)


ACCOUNTS = yaml.safe_load((Path(__file__).parent / "accounts.yaml").read_text(encoding="utf-8"))


@pytest.mark.parametrize("case", ACCOUNTS, ids=[c["name"] for c in ACCOUNTS])
def test_what_became_of_each_clause(case):
    """Clauses on the user's own text, by what the fields rest on; nothing is lost but what no field holds."""
    structure = reading(case["answer"], case["text"])
    assert structure is not None and structure.text == case["text"]
    told = [[c.text, c.status, *(["; ".join(c.fields)] if c.fields else []), *([c.reason] if c.reason else [])]
            for c in account(structure)]  # fmt: skip
    assert told == case["clauses"]


class Saying:
    """A model that answers all with the same."""

    def __init__(self, said: str | Answer | ReaderError):
        self.said = said

    def answer(self, text: str) -> Answer:
        if isinstance(self.said, ReaderError):
            raise self.said
        return self.said if isinstance(self.said, Answer) else Answer(self.said, 10, 20)


@pytest.mark.parametrize(("text", "said", "why"), [
    (TEXT, "I cannot help with that.", NO_SCENARIO),
    ("I like cheese and my grandmother has a nice garden.", "R: road\nE: car\nO1: plant_pot at=roadside", NO_SCENARIO),
    (TEXT, ReaderError("It could not answer (no memory)"), "It could not answer (no memory)."),
    ("Two plus two is four.", ANSWER, NO_SCENARIO), ("", ANSWER, "The text is empty"),
    ("Ein Auto bremst vor uns, und das Ego weicht aus.", ANSWER, "This text is not English"),
], ids=["no scenario", "nobody does anything", "an error", "none of the road", "nothing", "no English"])  # fmt: skip
def test_a_text_that_cannot_be_read_is_refused_in_a_sentence(monkeypatch, text, said, why):
    monkeypatch.setattr("c2s_engine.interpret.learned.reader.loaded", lambda: Saying(said))
    with pytest.raises(InterpretError, match=re.escape(why)):
        learned(text)


def test_what_is_beyond_the_longest_text_is_said(monkeypatch):
    monkeypatch.setattr("c2s_engine.interpret.learned.reader.loaded", lambda: Saying(ANSWER))
    text = TEXT + " It goes on and on." * MOST_WORDS
    found = learned(text).structure
    assert found.text == text and found.not_understood[-1].reason == BEYOND
    assert len(text[: found.not_understood[-1].span[0]].split()) == MOST_WORDS


@pytest.mark.parametrize(("text", "means"), [
    ("CCRs", "A stationary car stands ahead of ego in the same lane on a straight road; ego must brake hard."),
    ("Road edge departure, at night.", "Ego drives straight on and drifts to the right off the road. At night."),
])  # fmt: skip
def test_of_the_name_of_a_crash_type_its_meaning_is_asked(monkeypatch, text, means):
    asked_so = []

    class Noting(Saying):
        def answer(self, text):
            asked_so.append(text)
            return super().answer(text)

    monkeypatch.setattr("c2s_engine.interpret.learned.reader.loaded", lambda: Noting("R: straight\nE: car ; brake"))
    found = learned(text).structure
    assert asked_so == [means] and found.text == text
    assert all(li.span and li.span[1] <= len(text) for c in found.components for li in c.links)


def tokens_of(answer: str, unsure: str = "", likely: float = 0.4) -> tuple[tuple[str, float], ...]:
    """An answer's tokens as llama.cpp gives them (a space is of the word after it), all certain but one word."""
    found = re.findall(r"\s*[^\s=]+=?", answer)
    return tuple((t, math.log(likely) if t.strip() == unsure else -0.001) for t in found)


GUESSES = yaml.safe_load((Path(__file__).parent / "guesses.yaml").read_text(encoding="utf-8"))


@pytest.mark.parametrize("case", GUESSES, ids=[c["word"] for c in GUESSES])
def test_a_field_that_the_model_guessed_is_assumed_and_said(monkeypatch, case):
    answer = Answer(ANSWER, 10, 20, tokens_of(ANSWER, case["word"]))
    assert "".join(t for t, _ in answer.tokens) == ANSWER
    monkeypatch.setattr("c2s_engine.interpret.learned.reader.loaded", lambda: Saying(answer))
    found = learned(TEXT)
    notes = [[c.id, a.field, a.value] for c in found.structure.components for a in c.assumed if a.by == "reader"]
    assert notes == case["assumed"]
    assert found.note == (CHECK.format(case["said"]) if case["said"] else "")


def test_of_many_guesses_the_first_are_named(monkeypatch):
    unsure = tuple((t, math.log(0.5)) for t, _ in tokens_of(ANSWER))
    monkeypatch.setattr("c2s_engine.interpret.learned.reader.loaded", lambda: Saying(Answer(ANSWER, 10, 20, unsure)))
    found = learned(TEXT)
    guesses = [a for c in found.structure.components for a in c.assumed if a.by == "reader"]
    assert len(guesses) > NAMED and found.note.count("'s ") == NAMED
    assert f" and {len(guesses) - NAMED} more: compare S with the text." in found.note


def test_what_the_model_leaves_out_is_not_understood_at_its_place():
    text = "A child runs out 20 m ahead of ego,  without\n looking. Ego hoots and brakes."
    answer = "E: car reaction=brake react_to=O1\nO1: child at=roadside gap=20m pace=run ; cross_road\nX: {}"
    found = reading(answer.format("Without looking | hoots | a third thing"), text)
    assert found is not None
    left = [(u.text, u.reason) for u in found.not_understood]
    assert left == [("without\n looking", UNSAID), ("hoots", UNSAID)]
    assert all(text[slice(*u.span)] == u.text for u in found.not_understood if u.span)
    nothing = reading(answer.format("none"), text)
    assert nothing is not None and not nothing.not_understood


@given(st.lists(st.text(alphabet=string.ascii_letters + " ,'", min_size=1).map(str.strip).filter(bool), max_size=4))
def test_phrases_that_are_left_out_are_written_and_read_back(phrases):
    if phrases != ["none"]:
        assert left_out(with_left_out(ANSWER, phrases)) == tuple(phrases)
    assert parse(with_left_out(ANSWER, phrases)) == parse(ANSWER)


@pytest.mark.full
@pytest.mark.model
@needs_model
async def test_the_model_reads_a_text_to_a_program_that_runs(engine):
    events = [event async for event in engine.generate(TEXT, method="reader")]
    done = events[-1]
    assert isinstance(done, Finished) and done.ok 
    assert sorted(o.spec.type for o in done.structure.objects) == ["child", "van"]
    assert done.structure.settings.spec.weather == ("rain",) and done.details["tokens"] > 50


@pytest.mark.full
@pytest.mark.model
@needs_model
def test_the_model_says_the_same_of_the_same_text():
    first, again = loaded().answer(TEXT), loaded().answer(TEXT)
    assert first == again and set(parse(first.text)) >= {"E", "R", "O1", "O2"}
    assert "".join(t for t, _ in first.tokens) == first.text


@needs_model
def test_a_text_too_long_for_it_is_said_to_be():
    with pytest.raises(ReaderError, match="too long"):
        loaded().answer(TEXT * 200)


def test_without_its_packages_it_says_what_to_do(monkeypatch):
    monkeypatch.setattr("c2s_engine.interpret.learned.decoder.find_spec", lambda name: None)
    assert not installed()
    with pytest.raises(ReaderError, match="make run"):
        base()


@pytest.mark.parametrize(("text", "answer", "rate", "limits"), [
    ("Ego brakes with at least 6 m/s2.", "E: car ; brake\nT: limit deceleration maximum=6m/s2", 6.0, 0),
    ("Ego brakes with no less than 6 m/s2.", "E: car reaction=brake\nT: limit deceleration maximum=6m/s2", 6.0, 0),
    ("Ego brakes with at most 4 m/s2.", "E: car ; brake\nT: limit deceleration maximum=4m/s2", None, 1),
    ("It keeps at least 4 m, brakes at most 4 m/s2.", "E: car ; brake\nT: limit deceleration maximum=4m/s2", None, 1),
    ("Ego brakes with no more than 4 m/s2.", "E: car ; brake\nT: limit deceleration minimum=4m/s2", None, 1),
])  # fmt: skip
def test_at_least_is_no_maximum(text, answer, rate, limits):
    found = reading(answer, text)
    braking = [p for p in found.ego.spec.phases if p.action == "brake"]
    assert [p.rate for p in braking] == ([rate] if braking else [])
    assert [li.minimum for li in found.restrictions.spec.limits] == [None] * limits


def test_words_on_which_no_field_rests_are_named_clause_by_clause():
    found = reading("E: car\nO1: van at=ahead ; cut_in", "A spotless van indicates and cuts in. Ego follows.")
    assert [c.unread for c in account(found)] == [("spotless", "indicates"), ("follows",)]
