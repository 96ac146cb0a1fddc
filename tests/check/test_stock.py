"""What is compiled piece by piece in a forked process is what Scenic compiles, and the same scenes come of it."""

from pathlib import Path

import pytest
from tests_of_stock import stock

from c2s_engine import paths
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.protocol import CheckRequest

HERE = Path(__file__).parent
PROGRAMS = sorted((HERE / "programs").glob("*.scenic"))


def compare(server: SyncCheckClient, folder: Path, programs: list[Path]) -> None:
    expected = stock(folder, programs)
    for path in programs:
        program = path.read_text(encoding="utf-8")
        report = server.check(CheckRequest(program=program, folder=str(paths.shipped("maps")), seed=3))
        want = expected[path.stem]
        assert report.ast_hash == want["hash"], path.stem
        assert report.ok == ("scene" in want), path.stem
        if report.ok:
            assert list(report.iterations) == [want["iterations"]], path.stem
            drawn = [tuple(v) for v in report.scenes[0].values()]
            assert drawn == [tuple(v) for v in want["scene"]], path.stem


@pytest.mark.nightly
def test_the_same_hashes_and_scenes(server: SyncCheckClient, tmp_path: Path) -> None:
    compare(server, tmp_path, PROGRAMS[::2])


@pytest.mark.nightly
def test_edited_pieces_compile_as_the_whole(server: SyncCheckClient, tmp_path: Path) -> None:
    """The pieces that are kept from other programs are moved to other lines, and requirements are renumbered."""
    made = []
    for path in PROGRAMS[1:8:2]:
        text = path.read_text(encoding="utf-8").replace("\n\n", "\n\n# another line\n\nrequire 1 < 2\n", 1)
        made.append(tmp_path / f"moved_{path.stem}.scenic")
        made[-1].write_text(text)
    target = tmp_path / "stock"
    target.mkdir()
    compare(server, target, made)
