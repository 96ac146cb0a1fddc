"""Scenic's own driving and CARLA examples, where C2S_SCENIC_EXAMPLES names a folder with a copy of its repository.

Their maps are looked for in the folder, too, as the repository has them: assets/maps/CARLA/*.xodr.
"""

import os
from pathlib import Path

import pytest

from c2s_bench.perf import run_programs
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.structure.program import assemble

pytestmark = pytest.mark.nightly
SHARE = 50 / 56
"""of the examples that must run."""


@pytest.fixture(scope="module")
def folder() -> Path:
    said = os.environ.get("C2S_SCENIC_EXAMPLES")
    if not said:
        pytest.skip("C2S_SCENIC_EXAMPLES names no copy of Scenic's repository")
    return Path(said)


@pytest.fixture(scope="module")
def programs(folder: Path) -> list[run_programs.Given]:
    groups = [folder / "examples" / name for name in ("driving", "carla")]
    return [given for group in groups for given in run_programs.of_folder(group)]


def test_import_gives_back_each_byte(programs):
    with SyncCheckClient() as client:
        for given in programs:
            structure = client.import_program(given.text, Path(given.name).name).structure
            assert structure is not None and assemble(structure).text == given.text, given.name


def test_they_run(folder, programs):
    maps = sorted((folder / "assets" / "maps" / "CARLA").glob("*.xodr"))
    with SyncCheckClient(runner=run_programs.RUNNER) as client:
        outcomes = [run_programs.run(client, given, 3, maps) for given in programs]
    failed = [o for o in outcomes if o.outcome != "runs"]
    assert len(failed) <= (1 - SHARE) * len(outcomes), failed
    assert all(o.reason for o in failed)
