"""Programs that import the driving library: the shipped one, or another version that lies beside them."""

from pathlib import Path

import pytest

from c2s_engine import driving, paths
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
    do Drive(way(self.lane), 8)
ego = new Car on lane.centerline, with behavior Onward()
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    save(Program(text=PROGRAM), str(paths.shipped("maps")), tmp_path / "program.scenic")
    return tmp_path


def check(server, folder: Path, program: str = PROGRAM):
    return server.check(CheckRequest(program=program, folder=str(folder)))


def codes(report) -> list[str]:
    return [d.code for s in report.stages for d in s.diagnostics]


def test_it_is_saved_beside_the_program_and_known(server, folder):
    assert (folder / driving.FILE).read_text() == driving.text()
    assert check(server, folder).ok


def test_names_and_arguments_are_looked_up_in_it(server, folder):
    assert codes(check(server, folder, PROGRAM.replace("way(", "wya("))) == ["undefined_name"]
    assert codes(check(server, folder, PROGRAM.replace(", 8)", ", sped=8)"))) == ["wrong_keyword"]


def test_another_version_beside_the_program_is_used(server, folder):
    (folder / driving.FILE).write_text(driving.text() + "\nNEWER = 3\n")
    assert check(server, folder, PROGRAM + "speed = NEWER\n").ok
    assert codes(check(server, folder.parent, PROGRAM + "speed = NEWER\n")) == ["undefined_name"]


@pytest.mark.parametrize("line, code", [("import os", "import os *"), ("def (", "library")])
def test_one_that_may_not_or_cannot_be_run_is_refused(server, folder, line, code):
    (folder / driving.FILE).write_text(driving.text() + f"\n{line}\n")
    assert codes(check(server, folder)) == [code]


def test_inlined_is_one_file_with_what_is_used(server, folder):
    text = driving.inlined(PROGRAM)
    assert driving.MODULE + " import" not in text and "behavior Walk" not in text and "def _way" in text
    (folder / driving.FILE).unlink()
    assert check(server, folder, text).ok
