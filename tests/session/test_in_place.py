"""Edits of fields upon code by hand: the literal that says the field is changed, and not a byte else; or the offer."""

import re

import pytest

from c2s_engine.session.sessions import Sessions
from c2s_engine.structure.edits import Replace, SetField
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Finished, ProgramChanged, Say
from c2s_engine.write.in_place import same

HEAD = """param map = localPath('town.xodr')
param carla_map = None  # none of CARLA's
model scenic.simulators.carla.model
param VAN_KMH = 36
"""
FOLLOWED = """\"\"\"A program in an order of its own.\"\"\"
param map = localPath('../maps/Town05.xodr'), carla_map = 'Town05'
param weather = 'ClearNoon'  # bright
model scenic.simulators.carla.model
param VAN_KMH = 36
EGO_SPEED = 9

LEAD_SPEED = 10  # m/s
lane = Uniform(*network.lanes)

behavior Drive(speed):
    do FollowLaneBehavior(target_speed=speed)

GAP = 20  # m, from middle to middle

behavior Lead():
    do FollowLaneBehavior(target_speed=LEAD_SPEED)

behavior Walk():
    do CrossingBehavior(ego, 2, 12)

ego = new Car on lane.centerline, with behavior Drive(EGO_SPEED)
van = new Van ahead of ego by Range(30, 40), \\
    with behavior Drive(globalParameters.VAN_KMH / 3.6)
lead = new Car following roadDirection from ego for GAP, with behavior Lead()
last = new Car behind ego by 5, with blueprint 'vehicle.audi.tt', with behavior Drive(7.0)
walker = new Pedestrian right of van by 3, with behavior Walk()
require (distance from ego to last) > 6
terminate after 15 seconds
"""


async def ended(events):
    """The last event, and what was said on the way."""
    found = [event async for event in events]
    rewritten = [event.rewritten for event in found if isinstance(event, ProgramChanged)]
    said = " ".join(event.text for event in found if isinstance(event, Say))
    assert isinstance(found[-1], Finished)
    return found[-1], said, rewritten[-1] if rewritten else ()


def edits(*given):
    return [SetField(component=c, path=path, value=value) for c, path, value in given]


def data(component):
    return component.spec.model_dump(mode="json")


def at(structure, cid, path):
    value = data(structure[cid])
    for key in path.split("."):
        value = value[int(key) if key.isdigit() else key]
    return value


JUNCTION = (
    HEAD
    + """
MODEL = 'vehicle.audi.tt'
APART = [20, 25]
junction = Uniform(*filter(lambda i: i.is4Way, network.intersections))
lane = Uniform(*junction.incomingLanes)
turn = Uniform(*filter(lambda m: m.type is ManeuverType.LEFT_TURN, lane.maneuvers))
way = [lane, turn.connectingLane, turn.endLane]
ego = new Car on lane.centerline,
    with blueprint MODEL, with behavior FollowTrajectoryBehavior(9, way)
last = new Car following roadDirection from ego for Range(-30, -20), with blueprint MODEL
require APART[0] <= (distance from ego to junction) <= APART[1]
"""
)
JUNCTIONS = [
    ([("R", "distance", [15, 30])], "[20, 25]", "[15, 30]"),
    ([("R", "arms", 3)], "is4Way", "is3Way"),
    ([("R", "manoeuvre", "right")], "LEFT_TURN", "RIGHT_TURN"),
    ([("O1", "placement.gap", [20.4, 35.4])], "Range(-30, -20)", "Range(-40, -25)"),
    ([("O1", "placement.gap", 20.4)], "Range(-30, -20)", "-25"),
    ([("O1", "model", "vehicle.seat.leon")], "-20), with blueprint MODEL", "-20), with blueprint 'vehicle.seat.leon'"),
    ([("E", "type", "truck"), ("E", "model", None)], "ego = new Car on lane.centerline,\n    with blueprint MODEL,",
     "ego = new Truck on lane.centerline,"),
]  # fmt: skip
CASES = [
    (("O2", "speed", 12), "LEAD_SPEED = 10", "LEAD_SPEED = 12"),
    (("O2", "speed", [8, 12]), "LEAD_SPEED = 10", "LEAD_SPEED = Range(8, 12)"),
    (("O2", "placement.gap", 25.4), "GAP = 20", "GAP = 30"),
    (("O3", "speed", 8), "Drive(7.0)", "Drive(8.0)"),
    (("O1", "speed", 12), "VAN_KMH = 36", "VAN_KMH = 43.2"),
    (("O1", "placement.gap", [25, 35]), "Range(30, 40)", "Range(25, 35)"),
    (("O1", "placement.gap", 22), "Range(30, 40)", "22"),
    (("O1", "type", "truck"), "new Van", "new Truck"),
    (("O3", "model", "vehicle.mini.cooper_s"), "vehicle.audi.tt", "vehicle.mini.cooper_s"),
    (("O3", "placement.position", "ahead"), "behind ego by 5", "ahead of ego by 5"),
    (("O4", "placement.side", "left"), "Pedestrian right", "Pedestrian left"),
    (("O4", "phases.0.trigger.value", 9), "2, 12)", "2, 9)"),
    (("E", "speed", 6), "EGO_SPEED = 9", "EGO_SPEED = 6"),
    (("E", "type", "truck"), "ego = new Car", "ego = new Truck"),
    (("T", "duration", 20), "after 15", "after 20"),
    (("T", "require.0.minimum", 5), "> 6", "> 5"),
    (("G", "preset", "WetNoon"), "'ClearNoon'", "'WetNoon'"),
    (("G", "time", "dusk"), "'ClearNoon'", "'ClearSunset'"),
    (("G", "map", "town"), "'../maps/Town05.xodr'), carla_map = 'Town05'", "'town.xodr'), carla_map = None"),
]


@pytest.mark.parametrize(("edit", "old", "new"), CASES, ids=[f"{c}.{path}={value}" for (c, path, value), *_ in CASES])
async def test_the_literal_is_changed_and_nothing_else(engine, edit, old, new):
    structure = await engine.import_program(FOLLOWED)
    done, said, rewritten = await ended(engine.apply(structure, edits(edit), run=False))
    assert done.program.text == FOLLOWED.replace(old, new) != FOLLOWED
    after = done.structure
    assert at(after, edit[0], edit[1]) == edit[2]
    assert [c.origin for c in after.components] == ["imported"] * len(after.components)
    assert not any(c.conflict for c in after.components) and "shown beside it" not in said
    assert " -> " in said and (edit[0] in rewritten or new.startswith("VAN_KMH"))
    again = await engine.import_program(done.program.text)
    if edit[0] != "G":
        assert all(same(data(a), data(b)) for a, b in zip(again.components, after.components, strict=True))
        assert [c.description for c in again.components] == [c.description for c in after.components]


@pytest.mark.parametrize(("asked", "old", "new"), JUNCTIONS, ids=[f"{a[0][1]}-{new}" for a, _, new in JUNCTIONS])
async def test_places_ranges_and_models(engine, asked, old, new):
    structure = await engine.import_program(JUNCTION)
    done, said, _ = await ended(engine.apply(structure, edits(*asked), run=False))
    assert done.program.text == JUNCTION.replace(old, new) != JUNCTION, said
    assert all(same(at(done.structure, c, path), value) for c, path, value in asked)
    assert not any(c.conflict for c in done.structure.components)


async def test_an_edit_after_an_edit(engine):
    structure = await engine.import_program(FOLLOWED)
    for value in (12, 14, 10):
        done, said, _ = await ended(engine.apply(structure, edits(("O2", "speed", value)), run=False))
        structure = done.structure
    assert done.program.text == FOLLOWED and "LEAD_SPEED = 14 -> 10" in said


async def test_weather_of_several_values_and_where_none_was_set(engine):
    structure = await engine.import_program(FOLLOWED)
    done, said, _ = await ended(engine.apply(structure, edits(("G", "weather", ["rain"])), run=False))
    assert re.sub(r"\{[^}]*\}", "'ClearNoon'", done.program.text) == FOLLOWED
    assert "'precipitation': 40" in done.program.text
    assert done.structure.settings.spec.preset is None, "what is said last counts"
    plain = HEAD + "ego = new Car\n"
    done, said, _ = await ended(
        engine.apply(await engine.import_program(plain), edits(("G", "time", "dusk")), run=False)
    )
    assert done.program.text == plain.replace("CARLA's\n", "CARLA's\nparam weather = 'ClearSunset'\n")
    assert done.ok and "param weather = 'ClearSunset' added" in said


async def test_a_blueprint_goes_with_the_type(engine):
    structure = await engine.import_program(FOLLOWED)
    done, said, _ = await ended(engine.apply(structure, edits(("O3", "type", "bus"), ("O3", "model", None)), run=False))
    assert "last = new Bus behind ego by 5, with behavior" in done.program.text and "taken out" in said


async def test_gaps_are_measured_anew_where_an_object_becomes_longer(engine):
    structure = await engine.import_program(FOLLOWED)
    done, said, _ = await ended(engine.say(structure, "make the lead a truck", run=False))
    assert done.program.text == FOLLOWED.replace("lead = new Car", "lead = new Truck")
    assert done.structure["O2"].spec.placement.gap == 14.2 and "the gap of O2 is 14.2 m" in said
    assert "Changed in its code: O2." in said


OFFERED = [
    ("behavior Drive(speed):\n    do FollowLaneBehavior()\n", "Drive(3)", "a default says it"),
    ("SHARED = 8\nbehavior Drive(speed):\n    do FollowLaneBehavior(speed)\n", "Drive(SHARED)", "ego says it too"),
    ("behavior Drive(speed):\n    do FollowLaneBehavior(8)\n", "Drive(1)", "its behaviour is ego's too"),
    ("def f(): return 8\nbehavior Drive(speed):\n    do FollowLaneBehavior(f())\n", "Drive(1)", "it is computed"),
]


@pytest.mark.parametrize(("code", "does", "why"), OFFERED, ids=[why for *_, why in OFFERED])
async def test_where_no_literal_says_it_the_code_stays_beside_the_offer(engine, code, does, why):
    text = f"{HEAD}{code}ego = new Car on road, with behavior {does}\n"
    text += f"lead = new Car ahead of ego by 9, with behavior {does}\n"
    structure = await engine.import_program(text)
    done, said, rewritten = await ended(engine.apply(structure, edits(("O1", "speed", 12)), run=False))
    assert done.program.text == text and rewritten == ()
    assert done.structure["O1"].conflict and done.structure["O1"].spec.speed == 12
    assert done.structure.ego == structure.ego.model_copy(update={"key": done.structure.ego.key})
    assert "shown beside it as a conflict" in said


async def test_a_class_that_the_world_model_lacks_is_not_written(engine):
    text = "param map = localPath('town.xodr')\nmodel scenic.simulators.newtonian.driving_model\n"
    text += "ego = new Car on road\nlead = new Car ahead of ego by 9\n"
    structure = await engine.import_program(text)
    done, _, rewritten = await ended(engine.apply(structure, edits(("O1", "type", "truck")), run=False))
    assert done.program.text == text and rewritten == ()
    assert done.structure["O1"].conflict


async def test_what_cannot_be_followed_whole_is_offered_whole(engine):
    structure = await engine.import_program(FOLLOWED)
    asked = edits(("O2", "speed", 12), ("O2", "count", 2))
    done, said, _ = await ended(engine.apply(structure, asked, run=False))
    assert done.program.text == FOLLOWED and done.structure["O2"].conflict
    assert "changed in the code" not in said and "O2: your code is kept" in said
    done, said, _ = await ended(engine.apply(done.structure, edits(("O2", "placement.gap", 10.4)), run=False))
    assert done.program.text == FOLLOWED and done.structure["O2"].conflict, "it is in conflict still"
    assert "changed in the code" not in said


async def test_a_bound_of_a_requirement_is_changed_where_it_stands(engine):
    text = f"{HEAD}ego = new Car on road\nlead = new Car on road\nrequire 20 < (distance from ego to lead) < 40\n"
    structure = await engine.import_program(text)
    done, _, _ = await ended(engine.apply(structure, edits(("T", "require.0.maximum", 30)), run=False))
    assert done.program.text == text.replace("< 40", "< 30") and not done.structure["T"].conflict


async def test_a_map_that_is_not_at_hand_stays_an_offer(engine):
    structure = await engine.import_program(FOLLOWED)
    done, said, _ = await ended(engine.apply(structure, edits(("G", "map", "Town77")), run=False))
    assert done.program.text == FOLLOWED and done.structure.settings.conflict


async def test_windows_line_ends_stay(engine):
    text = FOLLOWED.replace("\n", "\r\n")
    structure = await engine.import_program(text)
    done, _, _ = await ended(engine.apply(structure, edits(("O2", "type", "bus"), ("O2", "speed", 5)), run=False))
    assert done.program.text == text.replace("lead = new Car", "lead = new Bus").replace("D = 10", "D = 5")


async def test_a_removed_object_does_not_lead_astray(engine):
    from c2s_engine.structure.edits import RemoveObject

    structure = await engine.import_program(FOLLOWED)
    structure = (await ended(engine.apply(structure, [RemoveObject(component="O2")], run=False)))[0].structure
    before = assemble(structure).text
    done, _, _ = await ended(engine.apply(structure, edits(("O3", "speed", 4)), run=False))
    assert done.program.text == before.replace("Drive(7.0)", "Drive(4.0)") != before


async def test_undo_restores_byte_for_byte(engine, tmp_path):
    sessions = Sessions(tmp_path)
    session = sessions.open("one", engine)
    await ended(session.apply([Replace(structure=await engine.import_program(FOLLOWED))], run=False))
    before = session.structure.model_dump_json(), session.program.model_dump_json()
    await ended(session.apply(edits(("O2", "speed", 12)), run=False))
    after = session.structure.model_dump_json(), session.program.model_dump_json()
    assert session.program.text == FOLLOWED.replace("LEAD_SPEED = 10", "LEAD_SPEED = 12")
    await ended(session.undo())
    assert (session.structure.model_dump_json(), session.program.model_dump_json()) == before
    assert session.program.text == FOLLOWED
    await ended(session.redo())
    assert (session.structure.model_dump_json(), session.program.model_dump_json()) == after
    session.close()
    sessions.close()
