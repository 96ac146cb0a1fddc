"""Programs of others, opened, edited and saved: byte for byte theirs plus the intended change."""

import random
import re
from difflib import SequenceMatcher
from pathlib import Path

import pytest

from c2s_engine.structure.edits import SetField, SetProgram, apply
from c2s_engine.structure.leaves import value_at
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Finished

HERE = Path(__file__).parent
OURS = sorted((HERE / "programs").glob("*.scenic"))
PROGRAMS = [*OURS, *sorted((HERE.parent / "check" / "programs").glob("*.scenic"))]
TURNS = {
    "bypassing": [("E", "speed", 12, {"EGO_SPEED = 10": "EGO_SPEED = 12"}),
                  ("O1", "speed", 6, {"SLOW_SPEED = 4": "SLOW_SPEED = 6"}),
                  ("O1", "type", "truck", {"slow = new Car": "slow = new Truck",
                                           "DIST),\n\twith blueprint MODEL": "DIST)"})],
    "parked_car": [("E", "speed", 6, {"target_speed=8)": "target_speed=6)"}),
                   ("T", "duration", 25, {"after 20": "after 25"})],
    "two_walkers": [("O3", "type", "truck", {"new Van": "new Truck"}),
                    ("E", "speed", 6, {"param EGO_SPEED = 8": "param EGO_SPEED = 6"}),
                    ("T", "duration", 10, {"after 15": "after 10"})],
    "ego_alone": [("T", "duration", 10, {"after 12": "after 10"})],
    "names_of_its_own": [("O1", "speed", 7, {"target_speed=8": "target_speed=7"})],
}  # fmt: skip


async def last(events):
    found = [event async for event in events]
    assert isinstance(found[-1], Finished)
    return found[-1]


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda p: p.stem)
async def test_what_is_opened_and_edited_is_there_byte_for_byte(engine, path):
    text = path.read_text()
    structure = await engine.import_program(text)
    assert assemble(structure).text == text
    assert apply(structure, SetProgram(text=text)) == structure
    draws = random.Random(path.stem)
    for _ in range(20):
        lines = assemble(structure).text.split("\n")
        at = draws.randrange(len(lines) + 1)
        lines[at : at + draws.choice([0, 0, 1])] = [draws.choice(["# mine", "", "    # in it", "NEW = 3"])]
        structure = apply(structure, SetProgram(text="\n".join(lines)))
        assert assemble(structure).text == "\n".join(lines)


@pytest.mark.parametrize("path", OURS, ids=lambda p: p.stem)
async def test_a_turn_changes_its_span_and_nothing_else(engine, path):
    text = "# Mine.\n" + path.read_text()
    structure = await engine.import_program(text)
    for cid, field, value, changed in TURNS[path.stem]:
        before = assemble(structure).text
        done = await last(engine.apply(structure, [SetField(component=cid, path=field, value=value)], run=False))
        wanted = before
        for old, new in changed.items():
            assert old in before
            wanted = wanted.replace(old, new)
        assert done.program.text == wanted, _differs(wanted, done.program.text)
        structure = done.structure


async def test_a_constant_by_hand_is_read_back_and_later_turns_go_on_from_there(engine):
    text = OURS[0].read_text()
    structure = await engine.import_program(text)
    typed = text.replace("SLOW_SPEED = 4", "SLOW_SPEED = 5.5")
    done = await last(engine.apply(structure, [SetProgram(text=typed)], run=False))
    assert done.program.text == typed and done.structure["O1"].spec.speed == 5.5
    done = await last(engine.say(done.structure, "make the car 2 m/s faster", run=False))
    assert done.program.text == typed.replace("SLOW_SPEED = 5.5", "SLOW_SPEED = 7.5")
    assert not any(c.conflict for c in done.structure.components)


@pytest.mark.parametrize(("old", "new", "path", "value", "follows"), [
    ("BUS_SPEED = 11.11", "BUS_SPEED = 9.5", "speed", 9.5, [("away, at 40 km/h", "away, at 34.2 km/h")]),
    ("BUS_GAP = 30", "BUS_GAP = 24", "placement.gap", 24, [("30 m away", "24 m away"), ("length=88", "length=82")]),
])  # fmt: skip
async def test_a_constant_of_ours_edited_by_hand_is_an_edit_of_its_field(engine, old, new, path, value, follows):
    text = "Ego drives at 50 km/h on a straight road. A bus drives 30 m ahead of ego at 40 km/h and brakes hard."
    done = await last(engine.generate(text, run=False))
    typed = "# Ours.\n" + done.program.text.replace(old, new)
    assert new in typed
    done = await last(engine.apply(done.structure, [SetProgram(text=typed)], run=False))
    for one in follows:  # its sentence, and the road that it needs
        typed = typed.replace(*one)
    assert done.program.text == typed
    assert value_at(done.structure["O1"].spec, path) == value and done.structure["O1"].origin == "rendered"
    done = await last(engine.say(done.structure, "make the bus a truck", run=False))
    assert done.program.text.startswith("# Ours.\n## G") and "new Truck" in done.program.text
    assert not any(c.conflict for c in done.structure.components)


async def test_what_was_assumed_is_where_hand_edits_and_relative_changes_begin(engine):
    text = "Ego drives at 50 km/h on a straight road. A bus ahead of ego brakes."
    done = await last(engine.generate(text, run=False))
    bus = done.structure["O1"]
    gap, speed = bus.amount("placement.gap"), bus.amount("speed")
    assert bus.spec.placement.gap is None and gap and speed
    done = await last(engine.say(done.structure, "make the bus 5 m closer", run=False))
    assert done.structure["O1"].spec.placement.gap == pytest.approx(gap - 5, abs=0.11)
    done = await last(engine.say(done.structure, "the bus drives 10 km/h slower", run=False))
    assert done.structure["O1"].spec.speed == pytest.approx(speed - 10 / 3.6, abs=0.06)


async def test_an_assumed_constant_of_ours_edited_by_hand_is_an_edit_of_its_field(engine):
    text = "Ego drives at 60 km/h. A truck comes from the right at the intersection and goes straight on."
    done = await last(engine.generate(text, run=False))
    assert done.structure["O1"].spec.speed is None
    typed = re.sub(r"(TRUCK_SPEED = )[\d.]+", r"\g<1>5.5", done.program.text)
    assert typed != done.program.text
    done = await last(engine.apply(done.structure, [SetProgram(text=typed)], run=False))
    truck = done.structure["O1"]
    assert "TRUCK_SPEED = 5.5" in done.program.text and truck.spec.speed == 5.5
    assert truck.origin == "rendered" and "at 19.8 km/h" in truck.description and truck.description in done.program.text
    assert not any(a.field == "speed" for a in truck.assumed)


def _differs(one: str, other: str) -> list[str]:
    matcher = SequenceMatcher(None, one, other, autojunk=False)
    return [f"{one[a:b]!r} -> {other[c:d]!r}" for tag, a, b, c, d in matcher.get_opcodes() if tag != "equal"]
