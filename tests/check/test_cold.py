"""The first check on a machine: what is compiled and parsed then is kept for later, also for plain Scenic."""

import shutil
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from c2s_engine import paths
from c2s_engine.check import caching
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.protocol import CheckRequest

PROGRAM = (Path(__file__).parent / "programs" / "works.scenic").read_text(encoding="utf-8")
TIMEOUT = 30.0  # s


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    yield tmp_path / "cache" / "c2s"


def check(folder: Path) -> tuple[str, tuple]:
    with SyncCheckClient() as server:
        report = server.check(CheckRequest(program=PROGRAM, folder=str(folder), seed=3))
        assert report.ok, report.stages
        return report.ast_hash, report.scenes


@pytest.mark.full
def test_an_empty_cache_is_filled_and_changes_nothing(cache: Path, tmp_path: Path) -> None:
    from scenic.domains.driving.roads import Network

    shutil.copy(paths.shipped("maps", "town.xodr"), tmp_path)
    first = check(tmp_path)
    until = time.monotonic() + TIMEOUT
    while not (saved := list(cache.glob("maps/*/network.snet"))) and time.monotonic() < until:
        time.sleep(0.1)
    assert len(list(cache.glob("modules/*.bin"))) == 7
    assert len(list(cache.glob("maps/*/*.packed"))) == 1
    assert len(list(cache.glob("modules/*.world"))) == 5  # Scenic's four and the driving library
    assert not [p for p in cache.rglob("tmp*") if p.is_file()]
    assert check(tmp_path) == first

    def parsed(*_: object, **__: object) -> None:
        raise AssertionError("plain Scenic does not take the cached network")

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Network, "fromOpenDrive", parsed)
        shutil.copy(saved[0], tmp_path / "town.snet")
        assert Network.fromFile(tmp_path / "town.xodr", writeCache=False).elements


@pytest.mark.full
def test_a_cache_that_cannot_be_made(cache: Path, tmp_path: Path) -> None:
    shutil.copy(paths.shipped("maps", "town.xodr"), tmp_path)
    cache.parent.mkdir(parents=True)
    cache.write_text("a file where the folder should be", encoding="utf-8")
    assert not caching.writable()
    caching.write(cache / "modules" / "x.bin", b"")
    check(tmp_path)
    assert cache.is_file()


def test_what_is_expected_is_there_when_it_is_asked_for(server: SyncCheckClient, tmp_path: Path) -> None:
    shutil.copy(paths.shipped("maps", "town.xodr"), tmp_path)
    server.expect(tmp_path / "town.xodr")
    server.expect(tmp_path / "nowhere.xodr")
    assert server.check(CheckRequest(program=PROGRAM, folder=str(tmp_path), upto="compile")).ok
