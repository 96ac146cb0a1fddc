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


@settings(max_examples=15, deadline=None)
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
    assert len(structure["O1"].layout) == 2


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
