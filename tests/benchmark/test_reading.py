"""The reader's data and measures."""

import random

import pytest

from c2s_bench.reading.agreement import agreement
from c2s_bench.reading.pairs import judged, mirror, other_numbers, pairs, sloppy, variants
from c2s_bench.reading.scenes import scenes
from c2s_bench.reading.through import in_the_terms_of, seen
from c2s_bench.reading.turns import Turn, outcome, turns
from c2s_engine.interpret.learned.notation import parse, short
from c2s_engine.interpret.learned.reader import structure_of
from c2s_engine.interpret.learned.units import with_units
from c2s_engine.structure.edits import RemoveObject, SetField, apply

pytestmark = pytest.mark.full

SAID = "R: road\nE: car speed=50km/h\nO1: van at=left_lane along=ahead gap=12m ; cut_in side=right"
TEXT = "Ego at 50 km/h; a van in the left lane, 12 m ahead, moves over to the right."


@pytest.fixture(scope="module")
def some():
    return random.Random(2).sample(list(scenes()), 120)


def test_the_scenes_are_some_thousand_told_once_or_twice_a_tenth_held_out():
    found = list(scenes())
    assert len({s.id for s in found}) == len(found) > 8000 and {len(s.texts) for s in found} == {1, 2}
    noted = [s for s in found if s.lost is not None]
    assert len(noted) > 3000 and any(phrase for s in noted for phrase in s.lost)
    for scene in noted:
        for text, lost in zip(scene.texts, scene.lost, strict=True):
            assert all(phrase in " ".join(text.split()) for phrase in lost), scene.id
    assert 0.08 < sum(s.held for s in found) / len(found) < 0.12


def test_a_scene_agrees_with_itself_and_with_its_objects_in_another_order(some):
    for scene in some:
        there = scene.structure
        assert agreement(there, there).exact, scene.id
        if len(there.objects) > 1 and len(there.objects) < 6:
            turned = there.model_copy(update={"objects": tuple(reversed(there.objects))})
            assert agreement(turned, there).exact, scene.id


def test_what_is_missing_or_other_is_counted():
    there = structure_of(parse(SAID), TEXT)
    whole = agreement(there, there)
    slower = apply(there, SetField(component="E", path="speed", value=5.0))
    assert (agreement(slower, there).agreed, agreement(slower, there).read) == (whole.agreed - 1, whole.read)
    alone = apply(there, RemoveObject(component="O1"))
    assert not agreement(alone, there).objects and agreement(alone, there).agreed < whole.agreed


def test_mirrored_pairs():
    text, said = mirror(TEXT, SAID)
    assert "right lane" in text and "to the left" in text and "at=right_lane" in said and "side=left" in said
    assert mirror(text, said) == (TEXT, SAID)
    assert mirror("The van has the right of way.", SAID) is None


def test_what_a_scene_leaves_out_stands_in_its_answers_word_for_word():
    text = f"{TEXT} It hoots, on the left."
    for said, line in ((SAID, SAID + "\nX:"), (SAID, SAID + "\nX: hoots"), (SAID, SAID + "\nX: none")):
        lost = {"X:": None, "X: hoots": ("hoots",), "X: none": ()}[line.rsplit("\n", 1)[1]]
        assert next(variants(text, said, random.Random(1), lost)) == (text, line)
    turned, answer = mirror(text, SAID + "\nX: on the left")
    assert "on the right." in turned and answer.endswith("\nX: on the right") and "at=right_lane" in answer


def test_what_is_trained_on_is_complete_or_breaks_off_before_what_nobody_noted():
    from c2s_bench.reading import train

    for writers, ends in ((("golf",), {True}), (("papa",), {False})):
        found = pairs(writers)
        assert len(found) > 1000 and {said.endswith("\nX:") for _, said in found} == ends
    assert train.LEFT_OUT == "X:"


def test_other_numbers_stand_in_text_and_s_alike():
    text, said = other_numbers(TEXT, SAID, random.Random(1))
    speed = parse(said)["E"]["speed"].removesuffix("km/h")
    assert speed != "50" and f"at {speed} km/h" in text


def test_sloppy_texts_keep_their_numbers():
    for seed in range(20):
        found = sloppy(TEXT, random.Random(seed))
        assert "50" in found and "12" in found


def test_quantities_are_those_of_the_text():
    said = dict(judged())
    assert len(said) == 80 and any("mph" in s for s in said.values())
    structure = structure_of(parse("E: car speed=30mph\nO1: van at=ahead gap=20m"), "")
    found = with_units(structure, "At 30 mph, a van 60 ft away.")
    assert found["E"]["speed"] == "30 mph" and found["O1"]["placement"]["gap"] == "20 m"
    assert parse(short(found))["E"]["speed"] == "30mph"


def test_s_by_hand_is_told_in_the_terms_of_what_was_read():
    """What was read in another order and by other names is who it is; one that was not read is nobody there."""
    hand = structure_of({
        "E": {"reaction": "brake", "react_to": "O2"},
        "O1": {"name": "parked", "type": "van", "placement": {"position": "parked", "side": "right"}},
        "O2": {"name": "child", "type": "child", "placement": {"position": "roadside", "hidden_by": "O1"}},
        "O3": {"name": "bus", "type": "bus", "placement": {"position": "behind"}},
    }, "told")  # fmt: skip
    read = structure_of({
        "O1": {"name": "boy", "type": "child", "placement": {"position": "roadside"}},
        "O2": {"name": "transporter", "type": "van", "placement": {"position": "parked", "side": "right"}},
    }, "told")  # fmt: skip
    told = in_the_terms_of(hand, read)
    assert {o.id: o.spec.name for o in told.objects} == {"O2": "transporter", "O1": "boy", "O6": "no_bus"}
    assert told["O1"].spec.placement.hidden_by == "O2" and told.ego.spec.react_to == "O1"


async def test_nobody_who_was_not_read_is_seen(engine):
    bus = {"name": "bus", "type": "bus", "placement": {"position": "behind"}}
    hand = structure_of({"O1": {"name": "lead"}, "O2": bus}, "A car is ahead of ego, a bus behind.")
    read = structure_of({"O1": {"name": "car"}}, hand.text)
    found = {r.requirement: r.holds for r in await seen(engine, "one", read, hand)}
    assert found["O1.there"] is True and found["O4.there"] is False


def test_changes_upon_scenes_are_made_as_they_should_or_counted_as_wrong():
    chosen = [t for t in turns() if t.lines]
    assert len(chosen) > 500 and all(not any(c.unmet for c in t.after.components) for t in chosen[:200])
    scene = next(t.scene for t in chosen if "speed" in t.scene.components["E"])
    faster = Turn(scene, "ego drives at 33 km/h", ("E: speed=33km/h",))
    assert outcome(faster) == "right"
    assert outcome(Turn(scene, "ego drives at 33 km/h", ("E: speed=34km/h",))) == "wrong"
    assert outcome(Turn(scene, "the zeppelin should be greener", ("E: speed=34km/h",))) == "nothing"
