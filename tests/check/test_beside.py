"""Programs of several files: what lies beside them is imported as it was read, and held to the same rules."""

from pathlib import Path

import pytest

from c2s_engine import paths
from c2s_engine.check import beside
from c2s_engine.check.protocol import CheckRequest

HELPER = """\
model scenic.simulators.carla.model
SPEED = 7
behavior Onward(speed):
    do FollowLaneBehavior(speed)
class Lead(Car):
    width: 2
"""
GAPS = "import math\nGAP = 20\ndef gap():\n    return math.sqrt(GAP * GAP)\n"
PROGRAM = """\
param map = localPath('town.xodr')
param carla_map = None
from helper import *
import lib.gaps as gaps
ego = new Car on Uniform(*network.lanes).centerline, with behavior Onward(SPEED)
lead = new Lead following roadDirection from ego for gaps.gap()
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "town.xodr").symlink_to(paths.shipped("maps", "town.xodr"))
    (tmp_path / "helper.scenic").write_text(HELPER)
    (tmp_path / "lib").mkdir()
    (tmp_path / "lib" / "gaps.py").write_text(GAPS)
    return tmp_path


def check(server, folder: Path, program: str = PROGRAM, upto: str = "sample", **options):
    report = server.check(CheckRequest(program=program, folder=str(folder), upto=upto, **options))
    return [(d.code, d.message) for s in report.stages for d in s.diagnostics]


def test_scenic_and_python_files_are_imported(server, folder):
    assert check(server, folder) == []


def test_a_changed_file_is_read_again(server, folder):
    assert check(server, folder) == []
    (folder / "helper.scenic").write_text(HELPER.replace("SPEED = 7", "PACE = 7"))
    assert [code for code, _ in check(server, folder)] == ["name_error"]


def test_a_file_that_cannot_be_parsed_is_named_with_its_line(server, folder):
    (folder / "helper.scenic").write_text(HELPER + "ego = new Car at (\n")
    assert [m.partition(":")[0] for _, m in check(server, folder)] == ["helper.scenic, line 7"]


@pytest.mark.parametrize(
    "file, text, line",
    [
        ("lib/gaps.py", "import os\ndef gap():\n    return 20\n", ""),
        ("lib/gaps.py", "def gap():\n    return len(open('/etc/passwd').read())\n", ""),
        ("helper.scenic", HELPER + "import subprocess\n", ""),
        ("helper.scenic", HELPER + "def gap():\n    return pathlib.Path('/')\n", ""),
        ("other.scenic", HELPER, "from other import np"),
        ("other.scenic", HELPER, "import other\nx = other.pathlib.Path('/')"),
        ("other.scenic", HELPER, "import other\ny = other\nx = y.model({}, 'os')"),
        ("other.py", "from math import sqrt\n", "import other\nx = other.__builtins__"),
        ("numpy.py", "x = 1\n", "import numpy\nx = numpy.x"),
        ("os.py", "x = 1\n", "import os\nx = os.x"),
        ("scenic.py", "x = 1\n", "import scenic\nx = scenic.x"),
    ],
)
def test_what_is_not_allowed_in_a_program_is_not_beside_it(server, folder, file, text, line):
    (folder / file).write_text(text)
    found = check(server, folder, PROGRAM + line + "\n", upto="safety")
    assert found and all(message.count("not allowed in a scenario") == 1 for _, message in found)


def test_only_scenic_and_python_files_within_bounds_are_read(tmp_path):
    (tmp_path / "secret.txt").write_text("x = 1\n")
    (tmp_path / "link.py").symlink_to(tmp_path / "secret.txt")
    (tmp_path / "long.py").write_text("x = 1\n" * beside.CHARACTERS)
    (tmp_path / "a.py").write_text("import b, link\n")
    (tmp_path / "b.scenic").write_text("from a import x\n")
    assert set(beside.found("import a\nfrom long import x\n", tmp_path)) == {"a", "b"}


def test_a_module_that_there_is_already_is_never_replaced():
    with pytest.raises(ImportError, match="pytest"):
        beside.take({"pytest": ("pytest.py", "x = 1")})
