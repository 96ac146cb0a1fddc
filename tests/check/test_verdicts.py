"""The verdict of a check is Scenic's own, in an environment that has only `scenic` and `carla` from the registry."""

import shutil
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest

from c2s_bench.perf import verdicts
from c2s_engine import paths

pytestmark = pytest.mark.nightly


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The bin folder of such an environment."""
    folder = tmp_path_factory.mktemp("plain")
    subprocess.run([sys.executable, "-m", "venv", str(folder)], check=True)
    command = [folder / "bin" / "pip", "install", "-q", f"scenic=={version('scenic')}", "carla"]
    if subprocess.run(command, capture_output=True).returncode:
        pytest.skip("the registry cannot be reached")
    return folder / "bin"


def test_verdicts_are_scenics_and_the_writers_programs_pass(plain: Path) -> None:
    rows = verdicts.table(str(plain / "python"), verdicts.programs(of_the_writer=True))
    assert len(rows) > 100
    assert [r for r in rows if r["relation"] == "different"] == []
    written = [r for r in rows if r["program"].startswith("written_")]
    assert len(written) > 35
    assert [r for r in written if r["scenic"] != "passes" or r["c2s"] != "passes"] == []


def test_the_plain_command_samples_an_example(plain: Path, tmp_path: Path) -> None:
    example = sorted(paths.shipped("examples", "programs").glob("*.scenic"))[0]
    shutil.copy(example, tmp_path)
    shutil.copy(paths.shipped("maps", "town.xodr"), tmp_path)
    command = [plain / "scenic", "--2d", "--gather-stats", "1", example.name]
    assert subprocess.run(command, cwd=tmp_path, capture_output=True).returncode == 0
