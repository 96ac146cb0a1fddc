"""Import: every byte in exactly one component, whatever the layout; edits keep their place; Scenic 2 is upgraded."""

import random
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c2s_engine import paths
from c2s_engine.check import importer
from c2s_engine.check.client import CheckError, SyncCheckClient
from c2s_engine.check.protocol import CheckRequest, ImportRequest
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import SetCode, apply
from c2s_engine.structure.program import assemble

HERE = Path(__file__).parent
PROGRAMS = sorted((HERE / "programs").glob("*.scenic"))
STATEMENTS = [
    "param map = localPath('town.xodr')\n",
    "model scenic.simulators.carla.model\n",
    '"""words\n\n# no comment\n"""\n',
    "SPEED = 9\n",
    "# a comment\n\n\nGAP = 4  # m\n",
    "lane = Uniform(*network.lanes)\n",
    "spot = new OrientedPoint on lane.centerline\n",
    "behavior Ego(speed):\n    # inside\n\n    do FollowLaneBehavior(speed)\n",
    "behavior Lead():\n\twait\n",
    "ego = new Car at spot,\n    with behavior Ego(SPEED)\n",
    "lead = new Car following roadDirection from ego for GAP, \\\n    with behavior Lead()\n",
    "new Pedestrian right of ego by 3\n",
    "cones = [new Cone at spot offset by 0 @ i for i in range(3)]\n",
    "require (distance from ego to lead) > 3\n",
    "terminate after 20 seconds\n",
    "monitor M():\n    wait\nrequire monitor M()\n",
    "if SPEED > 3: GAP2 = 1\nelse:\n    GAP2 = 2\n",
    "x = 1; y = 2\n",
    "@property\ndef f(a):\n  return a\n",
]


def imported(text: str) -> Structure:
    result = importer.import_program(ImportRequest(text=text))
    assert result.structure is not None, result.diagnostics
    assert result.upgraded is None
    return result.structure


@settings(max_examples=15)
@given(
    order=st.lists(st.sampled_from(STATEMENTS), max_size=14),
    ending=st.sampled_from(["\n", "\r\n"]),
    tail=st.sampled_from(["", "# the end", "\n\n\n", "z = 3", "   # deeper\n"]),
)
def test_any_layout_is_assembled_again(order: list[str], ending: str, tail: str) -> None:
    text = ("".join(order) + tail).replace("\n", ending)
    structure = imported(text)
    assert assemble(structure).text == text
    assert sum(len(c.code) for c in structure.components) == len(text)


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda p: p.stem)
def test_programs(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    structure = imported(text)
    program = assemble(structure)
    assert program.text == text
    assert structure.ego.description.startswith("Ego ")
    assert "town" in structure.settings.description
    assert {program.component_at(n) for n in range(1, text.count("\n") + 1)} <= set(structure.ids)
    for component in structure.components:
        assert program.fragment(component.id) == component.code


def scattered() -> str:
    return "".join(STATEMENTS[i] for i in (0, 1, 3, 7, 8, 5, 6, 9, 4, 10, 11, 13, 14))


def test_components_of_a_scattered_program() -> None:
    structure = imported(scattered())
    assert structure.ego.code == STATEMENTS[7] + STATEMENTS[9] or STATEMENTS[3] in structure.ego.code
    assert "behavior Lead" in structure["O1"].code
    assert "lead = new Car" in structure["O1"].code
    assert structure["O1"].spec.name == "lead"
    assert structure["O2"].spec.type == "pedestrian"
    assert "lane = " in structure.place.code
    assert structure.restrictions.spec.duration == 20
    assert [cid for cid, _ in structure.arrangement].count("O1") == 2


def test_an_edit_by_hand_keeps_the_other_parts_in_place() -> None:
    structure = imported(scattered())
    code = structure["O1"].code.replace("\twait\n", "\twait\n\twait\n\twait\n").replace("GAP,", "GAP + 1,")
    edited = apply(structure, SetCode(component="O1", code=code))
    wanted = scattered().replace("\twait\n", "\twait\n\twait\n\twait\n").replace("GAP,", "GAP + 1,")
    assert assemble(edited).text == wanted


def test_code_written_anew_stands_after_what_it_reads() -> None:
    structure = imported(scattered())
    fresh = structure["O1"].model_copy(update={"code": "lead = new Truck ahead of ego by 9", "origin": "rendered"})
    text = assemble(structure.with_component(fresh)).text
    assert text.index("ego = new Car") < text.index("lead = new Truck") < text.index("require (distance")
    assert "behavior Lead" not in text


def test_edits_at_random_places_lose_no_line() -> None:
    rng = random.Random(1)
    structure = imported(scattered())
    for _ in range(30):
        lines = structure["O1"].code.split("\n")
        lines.insert(rng.randrange(len(lines)), f"# added {rng.random()}")
        edited = apply(structure, SetCode(component="O1", code="\n".join(lines)))
        text = assemble(edited).text
        assert all(line in text for line in lines)
        assert len(text) == len(scattered()) - len(structure["O1"].code) + len("\n".join(lines)) or text.endswith("\n")


OLD = """param map = localPath('town.xodr')
model scenic.simulators.carla.model
behavior Careful(speed=6):
    do FollowLaneBehavior(speed) for 3
spot = OrientedPoint on Uniform(*network.lanes).centerline
ego = Car at spot,
    with behavior Careful(5)
Car following roadDirection from ego for 20   # the lead
monitor M:
    while True:
        wait
require (distance from ego to spot) < 5
"""


def test_scenic_2_is_upgraded(server: SyncCheckClient) -> None:
    result = server.import_program(OLD)
    assert result.upgraded is not None
    assert assemble(result.structure).text == result.upgraded
    assert "-ego = Car at spot," in result.diff
    assert "+ego = new Car at spot," in result.diff
    report = server.check(CheckRequest(program=result.upgraded, folder=str(paths.shipped("maps"))))
    assert report.ok, [d.message for s in report.stages for d in s.diagnostics]


def test_what_cannot_be_parsed_is_refused_with_its_line(server: SyncCheckClient) -> None:
    with pytest.raises(CheckError, match="line 2"):
        server.import_program("x = 1\nbehaviour B(:\n")


def test_an_empty_program_is_an_empty_structure() -> None:
    assert assemble(imported("")).text == ""
    assert assemble(imported("# nothing\n")).text == "# nothing\n"


HEAD = "param map = localPath('town.xodr')\nmodel scenic.simulators.carla.model\n"


def test_what_changes_a_list_belongs_to_the_list() -> None:
    text = HEAD + (
        "wide = []\n"
        "for road in network.roads:\n    if len(road.lanes) > 3:\n        wide.append(road)\n"
        "chosen = Uniform(*wide)\nfirst = chosen.lanes[0]\nlast = chosen.lanes[-1]\n"
        "ego = new Car on first.centerline\nnew Truck on last.centerline\nrequire chosen.length > 50\n"
    )
    structure = imported(text)
    assert structure.place.code == text[text.index("wide") : text.index("first =")]
    assert "road" not in structure.place.description.partition("network: ")[2].split(", ")
    assert "first =" in structure.ego.code
    assert "last =" in structure["O1"].code
    assert structure.settings.code == HEAD


def test_names_inside_expressions_bind_nothing() -> None:
    text = (
        HEAD
        + "m = 3\nego = new Car\nlong = [m for m in network.lanes if m.length > 9]\nx = filter(lambda m: m.id, long)\n"
    )
    units = importer.units(text, "p.scenic")
    assert [sorted(u.defines) for u in units] == [[], [], ["m"], ["ego"], ["long"], ["x"]]
    assert "m" not in units[4].uses | units[5].uses


def test_a_function_that_places_objects_is_theirs() -> None:
    structure = imported(
        HEAD + "ego = new Car\ndef row(n):\n    for i in range(n):\n        new Cone at ego offset by 3 @ i\nrow(4)\n"
    )
    assert structure["O1"].code.startswith("def row")
    assert structure["O1"].code.endswith("row(4)\n")
    assert structure["O1"].description == "O1 is made by a function: Cone."
    assert structure["O1"].unmet


def test_the_ego_of_a_scenario_is_the_one_described() -> None:
    text = HEAD + "scenario Main():\n    setup:\n        van = new Van\n        ego = new Truck ahead of van by 9\n"
    structure = imported(text)
    assert structure.ego.spec.type == "truck"
    assert structure.ego.description == "Ego is a truck ahead of van; the component makes 2 objects."


RECOGNISED = (
    HEAD
    + """
FAR = [30, 40]
param SLOW = Range(3, 4)
spot = new OrientedPoint on Uniform(*network.lanes).centerline

behavior Careful(speed=7):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyObjs(self, 9):
        take SetBrakeAction(0.8)

behavior Late(after):
    while (distance from self to ego) > after:
        wait
    do FollowLaneBehavior(globalParameters.SLOW) for 3 seconds
    take SetBrakeAction(1)

ego = new Car following roadDirection from spot for -20, with behavior Careful(FAR[0] / 3)
walker = new Pedestrian right of spot by 3, with heading 90 deg relative to spot.heading,
    with behavior CrossingBehavior(ego, 1.5, threshold=12)
leadVan = new Van ahead of ego by Range(*FAR), with behavior Late(25)
slow = new Truck ahead of ego by 12
behindIt = new Motorcycle behind slow by 2
facing_us = new Car at spot offset by -3.5 @ 60, facing 180 deg relative to roadDirection
require 10 < (distance from ego to slow) <= 40
require (distance from ego to intersection) > 50
terminate when (distance to walker) > 90
terminate after 2 * 10 seconds
"""
)


def test_what_is_recognised_becomes_typed() -> None:
    structure = imported(RECOGNISED)
    ego, named = structure.ego.spec, {c.spec.name: c for c in structure.objects}
    assert (ego.speed, ego.reaction, ego.phases) == (10, "brake", ())
    assert structure.ego.unmet == ()
    walker = named["walker"].spec
    assert (walker.placement.position, walker.placement.side, walker.placement.gap) == ("roadside", "right", 20)
    assert [(p.action, p.speed, p.trigger.value) for p in walker.phases] == [("cross_road", 1.5, 12)]
    assert [(p.action, p.speed, p.duration) for p in named["lead_van"].spec.phases] == [
        ("wait", None, None), ("keep_lane", (3, 4), 3), ("stop", None, None),
    ]  # fmt: skip
    assert named["lead_van"].spec.phases[1].trigger.value == 25
    assert [u.text for u in named["lead_van"].unmet] == ["its place"]
    assert named["slow"].spec.placement.gap == 12
    assert named["slow"].description == "slow is a truck 12 m ahead of ego."
    assert named["behind_it"].description == "behindIt is a motorcycle 2 m behind slow."
    assert named["behind_it"].spec.placement.of == "O3"
    assert named["facing_us"].spec.placement.position == "oncoming_lane"
    said = structure.restrictions.spec
    assert [(c.subject, c.other, c.minimum, c.maximum) for c in said.require] == [("ego", "O3", 10, 40)]
    assert said.duration == 20
    assert [(c.kind, c.other, c.minimum) for c in said.terminate_when] == [("distance", "O1", 90)]
    assert [u.text for u in structure.restrictions.unmet] == ["(distance from ego to intersection) > 50"]


CROSSING = (
    HEAD
    + """
lit = filter(lambda i: i.is4Way and i.isSignalized, network.intersections)
crossing = Uniform(*lit)
way = Uniform(*filter(lambda m: m.type is ManeuverType.LEFT_TURN, crossing.maneuvers))
back = Uniform(*filter(lambda m: m.type is ManeuverType.STRAIGHT, way.reverseManeuvers))
path = [way.startLane, way.connectingLane, way.endLane]
begin = new OrientedPoint on way.startLane.centerline
ego = new Car at begin, with behavior FollowTrajectoryBehavior(6, path)
other = new Car on back.startLane.centerline, with behavior FollowTrajectoryBehavior(trajectory=[back.startLane])
require 15 <= (distance to crossing) <= 25
terminate when (distance to begin) > 60
"""
)


def test_the_intersection_and_egos_way_are_recognised() -> None:
    structure = imported(CROSSING)
    place = structure.place.spec
    assert (place.kind, place.arms, place.control, place.manoeuvre) == ("intersection", 4, "signal", "left")
    assert place.distance == (15, 25)
    assert structure.place.description.startswith(
        "An intersection of 4 roads with traffic lights, where ego turns left;"
    )
    assert structure["O1"].spec.placement.position == "opposite_approach"
    assert [p.action for p in structure["O1"].spec.phases] == ["go_straight"]
    assert structure.restrictions.spec.terminate_when[0].kind == "travelled"
    assert structure.restrictions.unmet == ()


OLDER = (
    HEAD
    + '''"""
Car on the left, words only
"""
param render = '1'
# Pedestrian at the kerb
spot = OrientedPoint on Uniform(*network.lanes).centerline
kinds = [Car,
    Truck,
    Van]
ego = Car \\
    at spot
Car following roadDirection from spot by -Range(20, 30), with speed 3
require (distance from ego to spot) in Range(0, 5)  # near
'''
)


def test_more_of_scenic_2_is_upgraded() -> None:
    result = importer.import_program(ImportRequest(text=OLDER))
    changed = [line for line in result.diff.splitlines() if line.startswith("+") and not line.startswith("+++")]
    assert changed == [
        "+param render = 1",
        "+spot = new OrientedPoint on Uniform(*network.lanes).centerline",
        "+ego = new Car \\",
        "+new Car following roadDirection from spot for -Range(20, 30), with speed 3",
        "+require 0 <= (distance from ego to spot) <= 5  # near",
    ]
    assert assemble(result.structure).text == result.upgraded


def test_what_is_left_of_an_upgrade_is_said_at_its_own_line() -> None:
    text = OLDER + "monitor M:\n    wait\nx = = 3\n"
    found = importer.import_program(ImportRequest(text=text)).diagnostics[0]
    assert found.line == text.count("\n")
    assert found.text == "x = = 3"
    assert found.edit is None


def test_an_object_of_unknown_place_is_nowhere_in_particular() -> None:
    """What a program requires of its distance is in T, and no placement."""
    text = HEAD + "ego = new Car\nbin = new Trash on visible curb\nrequire 30 < (distance from ego to bin) < 50\n"
    found = imported(text)
    assert found["O1"].spec.placement.gap is None and found["T"].spec.require
    assert [u.text for u in found["O1"].unmet] == ["its place"]
    assert found["O1"].description == "bin is a trash on a place near curb."


def test_the_diff_marks_an_end_without_a_newline() -> None:
    diff = importer.import_program(ImportRequest(text=HEAD + "ego = Car at 3 @ 4")).diff
    mark = "\\ No newline at end of file\n"
    assert diff.endswith(f"-ego = Car at 3 @ 4\n{mark}+ego = new Car at 3 @ 4\n{mark}")
