"""A distance means one thing: from bumper to bumper, in the program, when it is read back, and when a run is judged."""

import pytest

from c2s_engine.check import importer
from c2s_engine.check.protocol import ImportRequest
from c2s_engine.maps.library import MapLibrary
from c2s_engine.session.places import map_choice
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import (
    Condition,
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
from tests.write.test_golden import finished

CUTS_IN = Phase(action="cut_in", trigger=Trigger(kind="distance", value=25.0, of="ego"))


def test_the_program_says_gap_and_is_read_back():
    library = MapLibrary()
    writer = TypedWriter(map_choice(library, library.find("town")))
    near = Condition(kind="distance", subject="ego", other="O1", minimum=20.0)
    van = ObjectSpec(
        name="van", type="van", placement=Placement(position="ahead", gap=60.0), speed=10.0,
        phases=(Phase(action="brake", trigger=Trigger(kind="distance", value=25.0, of="ego")),),
    )  # fmt: skip
    made = Structure(
        settings=Component(id="G", spec=SettingsSpec()), place=Component(id="R", spec=PlaceSpec(kind="road")),
        ego=Component(id="E", spec=EgoSpec(speed=13.9)), objects=(Component(id="O1", spec=van),),
        restrictions=Component(id="T", spec=RestrictionsSpec(require=(near,))),
    )  # fmt: skip
    text = "".join(writer.write(made, c.id).code for c in made.components)
    assert "until gap(self, ego) < 25" in text and "require (gap(ego, van) >= 20)" in text
    read = importer.import_program(ImportRequest(text=text)).structure
    assert read is not None
    assert read["O1"].spec.phases[0].trigger == van.phases[0].trigger
    assert read.restrictions.spec.require == (near,)


def test_a_lane_change_near_somebody_waits_for_its_gap(writer):
    """No distance is told, but the gap that it leaves."""
    near = Trigger(kind="distance", of="ego")
    car = ObjectSpec(
        name="car", placement=Placement(position="left_lane", along="behind", gap=30.0), speed=16.0,
        phases=(Phase(action="lane_change", side="right", target="ego", gap=12.0, trigger=near),),
    )  # fmt: skip
    made = Structure(
        place=Component(id="R", spec=PlaceSpec(kind="road", lanes=2)), ego=Component(id="E", spec=EgoSpec(speed=12.0)),
        objects=(Component(id="O1", spec=car),),
    )  # fmt: skip
    assert "until ahead_by(ego, self" in writer.write(made, "O1").code


@pytest.mark.full
async def test_who_stops_with_a_room_that_is_said_stands_no_nearer(engine):
    stop = {"action": "stop", "target": "O1", "clearance": 1}
    case = {
        "R": {"kind": "straight"},
        "E": {"speed": 15, "phases": [stop], "reaction": "brake", "react_to": "O1", "hard": True},
        "O": [{"type": "van", "speed": 0, "placement": {"gap": 80}, "phases": [{"action": "stationary"}]}],
        "T": {"limits": [{"kind": "gap", "subject": "ego", "other": "O1", "minimum": 1}]},
    }  # fmt: skip
    last = await finished(engine, case)
    judged = {r.requirement: r for r in last.results}
    assert judged["T.limits.0"].holds and judged["E.phases.0.clearance"].holds, judged["T.limits.0"].seen
