"""The learned reader: its notation, what is made of answers that are wrong, and the model itself."""

import random
import string
from pathlib import Path

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from c2s_engine.interpret import EmbeddedInterpreter
from c2s_engine.interpret.learned import ReaderError, asked, installed, loaded, reading
from c2s_engine.interpret.learned.decoder import base
from c2s_engine.interpret.learned.notation import parse, short
from c2s_engine.interpret.learned.quantities import si
from c2s_engine.interpret.learned.reader import NOT_USED, structure_of
from c2s_engine.structure.progress import Finished
from c2s_engine.structure.specs import EgoSpec, ObjectSpec

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
    assert structure["O2"].links[0].label.startswith("A child")


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
    found = reading(ANSWER, TEXT, EmbeddedInterpreter())
    assert found.structure.settings.spec.weather == ("rain",) and not found.fallbacks
    assert [o.spec.name for o in found.structure.objects] == ["van", "child"]


def test_an_answer_that_is_no_scenario_leaves_the_embedded_reading():
    found = reading("I cannot help with that.", TEXT, EmbeddedInterpreter())
    assert set(found.fallbacks) == set(found.structure.ids) and len(found.structure.objects) == 2
    assert "embedded interpreter" in found.notes[0]


@pytest.mark.full
@needs_model
async def test_the_model_reads_a_text_to_a_program_that_runs(engine):
    events = [event async for event in engine.generate(TEXT, method="reader")]
    done = events[-1]
    assert isinstance(done, Finished) and done.ok and not [e for e in events if "embedded interpreter" in str(e)]
    assert sorted(o.spec.type for o in done.structure.objects) == ["child", "van"]
    assert done.structure.settings.spec.weather == ("rain",) and done.details["tokens"] > 50


@pytest.mark.full
@needs_model
def test_the_model_says_the_same_of_the_same_text():
    first, again = loaded().answer(TEXT), loaded().answer(TEXT)
    assert first == again and set(parse(first.text)) >= {"E", "R", "O1", "O2"}


@needs_model
def test_a_text_too_long_for_it_is_said_to_be():
    with pytest.raises(ReaderError, match="tell one scene"):
        loaded().answer(TEXT * 200)


def test_without_its_packages_it_says_what_to_do(monkeypatch):
    monkeypatch.setattr("c2s_engine.interpret.learned.decoder.find_spec", lambda name: None)
    assert not installed()
    with pytest.raises(ReaderError, match="make run"):
        base()
