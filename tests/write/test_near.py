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
from c2s_engine.write.typed.usual import default_gap

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


@pytest.mark.parametrize(
    ("speed", "trigger", "gap"),
    [(11.1, 25.0, 25 + 2.5 * 2.8),  # ego comes nearer: it drives a while before that
     (13.9, 15.0, 14.5),  # no faster: as near from the start
     (16.0, 15.0, 14.5)],
)  # fmt: skip
def test_who_acts_at_a_distance_starts_so_that_it_comes_to_be(speed, trigger, gap):
    phase = CUTS_IN.model_copy(update={"trigger": Trigger(kind="distance", value=trigger)})
    van = ObjectSpec(name="van", type="van", placement=Placement(position="left_lane"), speed=speed, phases=(phase,))
    assert default_gap(van, 13.9, PlaceSpec(kind="road")) == pytest.approx(gap)
