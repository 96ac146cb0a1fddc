"""Changes by the learned model: what its lines make of S, and that answers which fit nothing change nothing."""

import math
from pathlib import Path

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from c2s_engine.interpret.learned import Answer, ReaderError, read_change, reading
from c2s_engine.interpret.learned.change import changed_structure, in_words, prompt, stranger
from c2s_engine.interpret.learned.edits import after, differences
from c2s_engine.interpret.learned.notation import parse
from c2s_engine.interpret.learned.reader import structure_of
from c2s_engine.structure.components import Assumption
from c2s_engine.structure.edits import SetDescription, SetField, apply
from c2s_engine.structure.leaves import value_at
from c2s_engine.structure.sentences import sentence

TEXT = "Ego at 50 km/h; a van in the left lane, 12 m ahead, moves over to the right."
SAID = "R: road\nE: car speed=50km/h\nO1: van at=left_lane along=ahead gap=12m ; cut_in side=right"
CASES = yaml.safe_load((Path(__file__).parent / "changes.yaml").read_text(encoding="utf-8"))


LINES = [line for c in CASES for line in c["lines"]]


@pytest.fixture
def scene():
    return structure_of(parse(SAID), TEXT)


@pytest.mark.parametrize("case", CASES, ids=["; ".join(c["lines"]) for c in CASES])
def test_lines_of_a_change(scene, case):
    if "error" in case:
        with pytest.raises(ValueError, match=case["error"]):
            changed_structure(scene, case["lines"])
        return
    after = changed_structure(scene, case["lines"])
    spec = after[case["of"]].spec.model_dump(mode="json", exclude_defaults=True, exclude={"component"})
    assert spec == case["is"] and in_words(scene, after) == case["words"]
    untouched = [c for c in scene.components if not any(line.lstrip("+-").startswith(c.id) for line in case["lines"])]
    assert all(c == after[c.id] for c in untouched if c.id in after)


def test_what_is_asked_leaves_out_what_the_planner_chose(scene):
    chosen = apply(scene, SetField(component="O1", path="phases.0.gap", value=8.0))
    note = Assumption(field="phases.0.gap", value="8 m", reason="left open", by="planner")
    chosen = chosen.with_component(chosen["O1"].model_copy(update={"assumed": (note,)}))
    assert prompt(chosen, "the van\nis a truck") == f"{SAID}\n> the van is a truck"
    later = changed_structure(chosen, ["E: speed=60km/h"])
    assert later["O1"] == chosen["O1"]
    assert changed_structure(chosen, ["O1: ; brake"])["O1"].assumed == ()


@pytest.mark.parametrize(("likely", "sure"), [(0.9, True), (0.5, False), (0.2, None)])
def test_how_likely_an_answer_is_tells_whether_it_is_believed(scene, likely, sure, monkeypatch):
    class Says:
        def answer(self, asked):
            return Answer("O1: speed=20km/h", 1, 1, (("O1:", -0.01), (" speed=20km/h", math.log(likely))))

    monkeypatch.setattr("c2s_engine.interpret.learned.change.loaded", Says)
    found = read_change("slower", scene)
    assert (found is None) == (sure is None)
    if found is not None:
        assert [e.component for e in found.edits] == ["O1"] and ("not sure" not in found.words) == sure


def test_none_is_no_change(scene, monkeypatch):
    class Says:
        def answer(self, asked):
            return Answer("none", 1, 1, (("none", -0.1),))

    monkeypatch.setattr("c2s_engine.interpret.learned.change.loaded", Says)
    assert read_change("hello", scene).edits == ()


@pytest.mark.parametrize("answer", ["", "O4: speed=3km/h", "O1: van at=left_lane", "O1: ; fly", "xyz"])
def test_an_answer_that_fits_nothing_is_no_change(scene, answer, monkeypatch):
    class Says:
        def answer(self, asked):
            return Answer(answer, 1, 1, ((answer, -0.1),))

    monkeypatch.setattr("c2s_engine.interpret.learned.change.loaded", Says)
    assert read_change("whatever", scene) is None


@given(st.lists(st.sampled_from(LINES), min_size=1, max_size=4, unique=True))
def test_differences_lead_from_one_s_to_the_other(lines):
    scene = structure_of(parse(SAID), TEXT)
    try:
        wanted = changed_structure(scene, lines)
    except ValueError:
        return
    found = after(scene, differences(scene, wanted))
    assert [(c.id, c.spec) for c in found.components] == [(c.id, c.spec) for c in wanted.components]


@pytest.mark.parametrize(("text", "who"), [
    ("the moose brakes harder", "moose"), ("make the moose faster", "moose"), ("the van brakes", ""), ("O1 brakes", ""),
    ("it brakes for the moose", ""), ("the vehicle ahead brakes", ""),
])  # fmt: skip
def test_who_is_named_and_not_there_is_not_taken_for_another(scene, text, who):
    edits = differences(scene, changed_structure(scene, ["O1: ; brake"]))
    assert stranger(text, edits, scene) == who


@pytest.mark.parametrize(("text", "who"), [
    ("the motorcycle should brake after 4 s", "motorcycle"), ("the van should brake after 4 s", ""),
    ("the motorcycle makes the van brake", ""), ("it should brake when the motorcycle is near", ""),
])  # fmt: skip
def test_who_is_named_and_there_is_not_taken_for_another(scene, text, who):
    both = changed_structure(scene, ["+O2: motorcycle at=behind"])
    assert stranger(text, differences(both, changed_structure(both, ["O1: ; brake"])), both) == who


@pytest.mark.parametrize(("text", "line", "path", "value"), [
    ("put the van 5 m closer", "O1: gap=17m", "placement.gap", 7.0),
    ("5 m further away", "O1: gap=5m", "placement.gap", 17.0),
    ("ego drives 10 km/h slower", "E: speed=10km/h", "speed", 11.111),
    ("reduce its gap by 2 m", "O1: gap=2m", "placement.gap", 10.0),
    ("ego slower, 36 km/h", "E: speed=36km/h", "speed", 10.0),
    ("the gap is 5 m", "O1: gap=5m", "placement.gap", 5.0), ("12 m closer", "O1: gap=24m", "placement.gap", None),
])  # fmt: skip
def test_by_how_much_is_counted_from_what_it_was(scene, text, line, path, value, monkeypatch):
    class Says:
        def answer(self, asked):
            return Answer(line, 1, 1, ((line, -0.1),))

    monkeypatch.setattr("c2s_engine.interpret.learned.change.loaded", Says)
    if value is None:
        with pytest.raises(ReaderError, match="O1's gap is 12 m, which cannot become so much less"):
            read_change(text, scene)
        return
    changed = after(scene, read_change(text, scene).edits)[line[: line.index(":")]]
    assert value_at(changed.spec, path) == pytest.approx(value, abs=0.01)
    assert changed.description == sentence(changed, scene)


@pytest.mark.parametrize(("line", "speeds"), [
    ("E: speed=10km/h\nO1: speed=99km/h", (40, 50)), ("E: speed=10km/h\nO1: gap=3m", None), ("O1: speed=20km/h", None),
])  # fmt: skip
def test_two_amounts_are_counted_for_those_who_are_named_before_them(scene, line, speeds, monkeypatch):
    class Says:
        def answer(self, asked):
            return Answer(line, 1, 1, ((line, -0.1),))

    monkeypatch.setattr("c2s_engine.interpret.learned.change.loaded", Says)
    known = after(scene, [SetField(component="O1", path="speed", value=30 / 3.6)])
    text = "the van drives 20 km/h faster and ego 10 km/h slower"
    if speeds is None:
        with pytest.raises(ReaderError, match="name one field at a time"):
            read_change(text, known)
        return
    found = after(known, read_change(text, known).edits)
    assert [round(found[cid].spec.speed * 3.6) for cid in ("E", "O1")] == list(speeds)


def test_nothing_is_counted_from_what_is_left_open(scene, monkeypatch):
    class Says:
        def answer(self, asked):
            return Answer("O1: speed=20km/h", 1, 1, (("O1: speed=20km/h", -0.1),))

    monkeypatch.setattr("c2s_engine.interpret.learned.change.loaded", Says)
    with pytest.raises(ReaderError, match="O1's speed is left open"):
        read_change("the van drives 20 km/h faster", scene)


def test_a_sentence_follows_its_fields_however_it_came_to_them():
    scene = reading("E: car\nO1: car at=ahead gap=40m ; brake", "A car 40 m ahead of ego brakes hard.")
    changed = changed_structure(scene, ["O1: gap=25m"])
    assert "25 m" in changed["O1"].description and "brakes hard" in changed["O1"].description
    own = apply(scene, SetDescription(component="O1", description="Somebody ahead, 40 m off, in a hurry."))
    assert changed_structure(own, ["O1: gap=25m"])["O1"].description == own["O1"].description


@pytest.mark.parametrize(("before", "line", "kept"), [
    ("cut_in gap=12m @distance of=ego value=25m", "cut_in gap=18m", "cut_in gap=18m @distance of=ego value=25m"),
    ("brake rate=3m/s2 speed=20km/h", "brake pace=slow", "brake pace=slow rate=3m/s2"),
    ("overtake target=ego abandoned @passed subject=ego", "overtake target=ego", "overtake target=ego"),
    ("brake rate=3m/s2 ; stop", "stop", "stop"), ("brake rate=3m/s2", "brake ; brake", "brake ; brake"),
])  # fmt: skip
def test_a_phase_keeps_what_a_change_of_it_does_not_name(before, line, kept):
    said = "R: road\nE: car\nO1: van at=ahead ; {}"
    one, other = (structure_of(parse(said.format(phases)), TEXT) for phases in (before, kept))
    assert changed_structure(one, [f"O1: ; {line}"])["O1"].spec == other["O1"].spec


@pytest.mark.parametrize(("text", "whom"), [
    ("it turns left instead", ("O1", "ego")), ("once ego has passed the van", ("ego", "O1")),
])  # fmt: skip
def test_what_a_phase_waits_for_is_about_the_same_ones_unless_the_change_names_somebody(scene, text, whom, monkeypatch):
    before = changed_structure(scene, ["E: ; stop ; turn_right @passed subject=O1 of=ego"])
    line = "E: ; stop ; turn_left @passed subject=ego of=O1"

    class Says:
        def answer(self, asked):
            return Answer(line, 1, 1, ((line, -0.1),))

    monkeypatch.setattr("c2s_engine.interpret.learned.change.loaded", Says)
    trigger = after(before, read_change(text, before).edits).ego.spec.phases[1].trigger
    assert (trigger.subject, trigger.of) == whom
