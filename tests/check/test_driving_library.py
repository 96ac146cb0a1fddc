"""Programs that import the driving library: the shipped one, or another version that lies beside them."""

import subprocess
import sys
from pathlib import Path

import pytest

from c2s_engine import driving, paths
from c2s_engine.check import library
from c2s_engine.check.protocol import CheckRequest
from c2s_engine.saving import save
from c2s_engine.structure.program import Program

PROGRAM = """\
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
from c2s_driving import *
lane = Uniform(*network.lanes)
behavior Onward():
    do Drive(route(self.lane), 8)
ego = new Car on lane.centerline, with behavior Onward()
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    save(Program(text=PROGRAM), [str(paths.shipped("maps"))], tmp_path / "program.scenic")
    return tmp_path


def check(server, folder: Path, program: str = PROGRAM):
    return server.check(CheckRequest(program=program, folder=str(folder)))


def codes(report) -> list[str]:
    return [d.code for s in report.stages for d in s.diagnostics]


def test_it_is_saved_beside_the_program_and_known(server, folder):
    assert (folder / driving.FILE).read_text() == driving.text()
    assert check(server, folder).ok


def test_names_and_arguments_are_looked_up_in_it(server, folder):
    assert codes(check(server, folder, PROGRAM.replace("route(", "rotue("))) == ["undefined_name"]
    assert codes(check(server, folder, PROGRAM.replace(", 8)", ", sped=8)"))) == ["wrong_keyword"]


def test_a_program_with_the_names_of_version_1_still_runs(server, folder):
    older = PROGRAM[: PROGRAM.index("lane = ")] + """\
place = Uniform(*usual(stretches(length=150, least=100), speed=8))
behavior Onward():
    line = way(place.lane)
    try:
        do Drive(line, lambda: pace(self, lead, 8, standing=3)) until into(self, lead, 2) > 5
    interrupt when most_need(self, [lead]) > 3 and need(self, lead) > 3:
        do StopShortOf(line, [lead], 8)
ego = new Car at place.lane.centerline.pointAlongBy(20), with behavior Onward()
lead = new Car at place.lane.centerline.pointAlongBy(60)
terminate after 3 seconds
"""
    report = check(server, folder, older)
    assert report.ok, codes(report)


@pytest.mark.full
def test_another_version_beside_the_program_is_used(server, folder):
    (folder / driving.FILE).write_text(driving.text() + "\nNEWER = 3\n")
    assert check(server, folder, PROGRAM + "speed = NEWER\n").ok
    assert codes(check(server, folder.parent, PROGRAM + "speed = NEWER\n")) == ["undefined_name"]


@pytest.mark.full
@pytest.mark.parametrize("line, code", [("import os", "import os *"), ("def (", "library")])
def test_one_that_may_not_or_cannot_be_run_is_refused(server, folder, line, code):
    (folder / driving.FILE).write_text(driving.text() + f"\n{line}\n")
    assert codes(check(server, folder)) == [code]


def test_inlined_is_one_file_with_what_is_used(server, folder):
    text = driving.inlined(PROGRAM)
    assert driving.MODULE + " import" not in text and "behavior Walk" not in text and "def _route" in text
    (folder / driving.FILE).unlink()
    assert check(server, folder, text).ok


@pytest.mark.full
def test_one_that_is_no_scenic_is_named_with_its_line(server, folder):
    lines = driving.text().split("\n")
    row = next(n for n, line in enumerate(lines, 1) if line.startswith("behavior Drive"))
    for broken, where in (("    x = = 3", row + 1), ("    do (oops", row + 2)):  # the second is seen at a docstring
        (folder / driving.FILE).write_text("\n".join([*lines[:row], broken, *lines[row:]]))
        (found,) = [d for stage in check(server, folder).stages for d in stage.diagnostics]
        assert f"the c2s_driving.scenic beside the program, line {where}: this is not Scenic" in found.message


@pytest.fixture
def installed(tmp_path, monkeypatch):
    """Install another text as the driving library, for this process."""
    def install(text: str) -> None:
        file = tmp_path / driving.FILE
        file.write_text(text)
        monkeypatch.setattr(driving, "path", lambda: file)
        forget()

    def forget() -> None:
        for known in (driving.text, driving.digest, driving.names, driving.constants, driving._parts, library.fault):
            known.cache_clear()

    yield install
    monkeypatch.undo()
    forget()


@pytest.mark.parametrize("old, new, said", [
    ("CARS = ['vehicle.audi.a2',", "CARS = ['vehicle.audi.a2',,", "CARS is no list of names"),
    ("def gap(car, other):", "def gap((car, other):", "a bracket or a string is never closed"),
])
def test_an_installed_one_that_is_broken_says_so(installed, old, new, said):
    installed(driving.text().replace(old, new, 1))
    with pytest.raises(driving.BrokenLibrary, match=f"{driving.FILE}, line [0-9]+: {said}"):
        driving.constants()


@pytest.mark.full
def test_an_installed_one_that_does_not_compile_says_so(installed):
    text = driving.text().replace("def gap(car, other):", "def gap(car other):", 1)
    row = text[: text.index("def gap(car other):")].count("\n") + 1
    installed(text)
    assert f"{driving.FILE}, line {row}: this is not Scenic" in library.fault()


def test_a_copy_in_the_folder_that_c2s_was_started_in_is_not_taken(tmp_path):
    started, folder = tmp_path / "started", tmp_path / "program"
    for made in (started, folder):
        made.mkdir()
    (started / driving.FILE).write_text("raise ValueError\n")
    (folder / "town.xodr").symlink_to(paths.shipped("maps", "town.xodr"))
    (folder / "one.scenic").write_text(
        "param map = localPath('town.xodr')\nparam carla_map = None\nmodel scenic.simulators.carla.model\n"
        f"from {driving.MODULE} import *\nlane = Uniform(*network.lanes)\n"
        "ego = new Car on lane.centerline, with behavior Cruise(route(lane), 5)\n"
    )
    c2s = Path(sys.executable).with_name("c2s")
    done = subprocess.run([c2s, "check", folder / "one.scenic"], cwd=started, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
