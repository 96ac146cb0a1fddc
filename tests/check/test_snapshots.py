"""Snapshots after `model`: which programs share one, that each sees its own params, and what is copied ahead."""

import contextlib
import ctypes
import mmap
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from c2s_engine import paths
from c2s_engine.check import prefault
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.protocol import CheckRequest

FOLDER = str(paths.shipped("maps"))
linux = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")


def program(settings: str, said: str) -> str:
    """A program that fails unless the params are those that are said."""
    return (
        f"param map = localPath('town.xodr')\nparam carla_map = None\n{settings}model scenic.simulators.carla.model\n"
        f"assert {said}, list(globalParameters.items())\nego = new Car on Uniform(*network.lanes).centerline\n"
    )


def check(server: SyncCheckClient, text: str, **more) -> bool:
    return server.check(CheckRequest(program=text, folder=FOLDER, upto="compile", **more)).ok


def processes(pid: int) -> set[int]:
    found = {pid}
    with contextlib.suppress(OSError):  # it has ended
        for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split():
            found |= processes(int(child))
    return found


def settled(pid: int) -> int:
    """How many processes there are once those that are forked ahead for the next check are there."""
    counts: list[int] = []
    while len(counts) < 10 or len(set(counts[-10:])) > 1:
        time.sleep(0.1)
        counts.append(len(processes(pid)))
        assert len(counts) < 300, counts
    return counts[-1]


def test_each_program_has_its_own_params(server: SyncCheckClient) -> None:
    for weather in ("'WetNoon'", "'ClearNoon'", "{'cloudiness': 30}", "'WetNoon'"):
        assert check(server, program(f"param weather = {weather}\n", f"globalParameters.weather == {weather}"))
    assert check(server, program("param weather = 'WetNoon'\n", "list(globalParameters)[2] == 'weather'"))
    assert check(server, program("param timestep = 0.2\n", "globalParameters.timestep == 0.2"))
    assert check(server, program("param timestep = 0.1\n", "globalParameters.timestep == 0.1"))
    assert check(server, program("", "'speed' not in globalParameters"))
    assert check(server, program("param speed = 3, gap = 4\nparam gap = 5\n", "globalParameters.gap == 5"))
    assert check(server, program("param speed = 4, gap = 4\nparam gap = 4\n", "globalParameters.gap == 4"))
    assert not check(server, program("param render = 2\n", "True"))
    assert check(server, program("param render = 0\n", "globalParameters.render == 0"))


def test_params_of_the_request_stay_above_the_programs(server: SyncCheckClient) -> None:
    text = program("param weather = 'WetNoon'\n", "globalParameters.weather == 'ClearNoon'")
    assert check(server, text, params={"weather": "ClearNoon"})
    assert not check(server, text)


@linux
def test_other_weather_starts_from_the_same_snapshot(server: SyncCheckClient) -> None:
    def weather(i: int) -> str:
        return program(f"param weather = {{'cloudiness': {i}}}\n", f"globalParameters.weather['cloudiness'] == {i}")

    for i in range(2):
        assert check(server, weather(i))
    before = settled(server.pid)
    for i in range(2, 6):
        assert check(server, weather(i))
    assert settled(server.pid) <= before


@linux
def test_the_pages_that_a_rehearsal_writes_on_are_learnt(monkeypatch: pytest.MonkeyPatch) -> None:
    area = mmap.mmap(-1, 64 * mmap.PAGESIZE, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
    area.write(b"x" * len(area))
    start = ctypes.addressof(ctypes.c_char.from_buffer(area))

    def rehearse(halfway: Callable[[], None]) -> None:
        area[5 * mmap.PAGESIZE] = 1
        halfway()
        area[5 * mmap.PAGESIZE] = area[6 * mmap.PAGESIZE] = 2

    def numbers(ranges: prefault.Ranges) -> set[int]:
        found = {(a + i - start) // mmap.PAGESIZE for a, n in ranges for i in range(0, n, mmap.PAGESIZE)}
        return found & set(range(64))

    monkeypatch.setattr(prefault, "pages", [])
    monkeypatch.setattr(prefault, "later", [])
    prefault.learn(rehearse)
    assert numbers(prefault.pages) == {5, 6}
    assert numbers(prefault.later) == {6}
    prefault.populate([(start, 2 * mmap.PAGESIZE), (0, mmap.PAGESIZE)])
    assert area[0] == ord("x")
