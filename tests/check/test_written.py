"""What the typed writer wrote is read back exactly, or stays code: written again from what was read it is the same."""

import random
import re
from typing import Any

import pytest

from c2s_engine.check import importer
from c2s_engine.check.protocol import ImportRequest
from c2s_engine.maps.library import MapLibrary
from c2s_engine.session.places import map_choice
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import (
    EgoSpec,
    ObjectSpec,
    Phase,
    Placement,
    PlaceSpec,
    RestrictionsSpec,
    SettingsSpec,
    Trigger,
)
from c2s_engine.write.typed import TypedWriter

FIELDS = ("speed", "phases", "reaction", "hard")
ACTIONS = ("brake", "stop", "accelerate", "wait", "start", "keep_lane", "stationary", "lane_change", "swerve", "follow",
           "go_straight", "turn_left", "cut_in", "overtake", "yield", "reverse")  # fmt: skip
READ = ("brake", "stop", "accelerate", "wait", "stationary")


@pytest.fixture(scope="module")
def writer() -> TypedWriter:
    library = MapLibrary()
    return TypedWriter(map_choice(library, library.find("town")))


def structure(ego: EgoSpec, other: ObjectSpec, place: str = "road") -> Structure:
    return Structure(
        settings=Component(id="G", spec=SettingsSpec()),
        place=Component(id="R", spec=PlaceSpec(kind=place)),  # type: ignore[arg-type]
        ego=Component(id="E", spec=ego),
        objects=(Component(id="O1", spec=other),),
        restrictions=Component(id="T", spec=RestrictionsSpec()),
    )


def read_back(writer: TypedWriter, made: Structure) -> dict[str, bool]:
    """Whether the behaviours of E and O1 were read; fails where what was read is written otherwise."""
    text = "".join(writer.write(made, c.id).code for c in made.components)
    read = importer.import_program(ImportRequest(text=text)).structure
    assert read is not None
    found = {}
    for cid in ("E", "O1"):
        behaves = "with behavior" in read[cid].code
        found[cid] = behaves and not any(u.text.startswith("what ") for u in read[cid].unmet)
        if found[cid]:
            update = {name: getattr(read[cid].spec, name) for name in FIELDS if hasattr(read[cid].spec, name)}
            again = made.with_component(made[cid].model_copy(update={"spec": made[cid].spec.model_copy(update=update)}))
            wanted, written = (behaviour(writer.write(one, cid).code) for one in (made, again))
            assert written == wanted, (made[cid].spec, update)
    return found


def behaviour(code: str) -> str:
    """The behaviour of a fragment, without comments (a last wait is read as a stand). Where its object stands is not
    read, and may rest on its phases."""
    whole = code[code.index("\nbehavior ") :].partition("\n\n")[0] if "\nbehavior " in code else ""
    return re.sub(r"  # .*", "", whole)


def drawn(rng: random.Random, actions: tuple[str, ...]) -> tuple[Phase, ...]:
    """Up to three phases."""
    found = []
    for _ in range(rng.randint(0, 3)):
        action: Any = rng.choice(actions)
        kind: Any = rng.choice(["time", "distance", "ttc", "place"])
        place: Any = "intersection" if kind == "place" else None
        trigger = Trigger(kind=kind, value=rng.choice([2, 7.5, 20]), place=place) if rng.random() < 0.4 else None
        speed = rng.choice([None, 2, 9, 16])
        rate = rng.choice([None, None, 3, 4.5])
        found.append(
            Phase(action=action, speed=speed, rate=rate, duration=rng.choice([None, None, 2, 3]), trigger=trigger)
        )
    return tuple(found)


def test_what_is_read_is_written_as_it_was(writer: TypedWriter) -> None:
    rng = random.Random(4)
    done = tried = 0
    for i in range(12):
        actions = READ if i % 2 else ACTIONS
        reaction: Any = rng.choice(["none", "brake", "yield", "follow"])
        ego = EgoSpec(speed=rng.choice([None, 8, (6, 9)]), phases=drawn(rng, actions), reaction=reaction,
                      hard=reaction == "brake" and rng.random() < 0.5)  # fmt: skip
        position: Any = rng.choice(["ahead", "behind", "left_lane", "oncoming_lane"])
        other = ObjectSpec(name="other", type="car", speed=rng.choice([None, 0, 7]), phases=drawn(rng, actions),
                           placement=Placement(position=position))  # fmt: skip
        place = rng.choice(["road", "intersection", "motorway"])
        try:
            made = structure(ego, other, place)
            writer.write(made, "R")
        except Exception:  # what does not go together is not written
            continue
        found = read_back(writer, made)
        tried += 2
        done += sum(found.values())
    assert tried > 8
    assert done > tried // 8


@pytest.mark.parametrize(
    "phases",
    [
        (),
        (Phase(action="brake", trigger=Trigger(kind="time", value=5)),),
        (Phase(action="brake", speed=3, duration=2), Phase(action="accelerate", speed=12)),
        (Phase(action="stop", trigger=Trigger(kind="distance", value=20, of="ego")), Phase(action="wait", duration=4)),
        (Phase(action="accelerate"), Phase(action="stop")),
    ],
    ids=["none", "brake", "brake and accelerate", "stop and wait", "accelerate and stop"],
)
def test_simple_phases_come_back(writer: TypedWriter, phases: tuple[Phase, ...]) -> None:
    other = ObjectSpec(name="other", type="car", speed=8, phases=phases)
    made = structure(EgoSpec(speed=9, reaction="brake", hard=True), other)
    assert read_back(writer, made) == {"E": True, "O1": True}


def test_programs_with_the_library_s_earlier_names_come_back_as_well(writer: TypedWriter) -> None:
    brakes = Phase(action="brake", trigger=Trigger(kind="time", value=5))
    other = ObjectSpec(name="other", type="car", speed=8, phases=(brakes,))
    made = structure(EgoSpec(speed=9, reaction="brake"), other)
    text = "".join(writer.write(made, c.id).code for c in made.components)
    older = text.replace("route(", "way(").replace("braking_needed(", "need(")
    assert older != text
    now, before = (importer.import_program(ImportRequest(text=t)).structure for t in (text, older))
    assert now is not None and before is not None
    for cid in ("E", "O1"):
        assert before[cid].spec == now[cid].spec and before[cid].unmet == now[cid].unmet


def test_an_edited_step_is_read_as_it_is(writer: TypedWriter) -> None:
    made = structure(EgoSpec(speed=9), ObjectSpec(name="other", type="car", speed=8, phases=(Phase(action="stop"),)))
    text = "".join(writer.write(made, c.id).code for c in made.components)
    assert "OTHER_SPEED = 8 " in text
    read = importer.import_program(ImportRequest(text=text.replace("OTHER_SPEED = 8 ", "OTHER_SPEED = 6 "))).structure
    assert read is not None
    assert read["O1"].spec.speed == 6
    other = text.replace("do Drive(line, OTHER_SPEED)", "do Drive(line, OTHER_SPEED, offset=2)")
    read = importer.import_program(ImportRequest(text=other)).structure
    assert read is not None
    assert read["O1"].spec.phases == ()
    assert read["O1"].unmet
