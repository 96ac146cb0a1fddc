"""Statements done before their program comes: the same scenes as without, whatever the seed; and when it is done."""

import asyncio
import contextlib
import random
import sys
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import pytest

from c2s_engine import paths
from c2s_engine.check import ahead, draws
from c2s_engine.check.client import CheckClient, SyncCheckClient
from c2s_engine.check.protocol import CheckReport, CheckRequest

FOLDER = str(paths.shipped("maps"))
PROGRAM = """param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
SPEED = 7
sections = filter(lambda s: s.centerline.length > 90, network.laneSections)
start = new OrientedPoint on Uniform(*sections).centerline
behavior Follow(speed):
    do FollowLaneBehavior(target_speed=speed)
ego = new Car at start, with behavior Follow(SPEED)
lead = new Car following roadDirection from ego for Range(15, 30)
require (distance from ego to lead) < 60
"""


def check(server: SyncCheckClient, text: str, seed: int = 0, **more: Any) -> CheckReport:
    return server.check(CheckRequest(program=text, folder=FOLDER, seed=seed, **more))


def test_edits_get_the_scenes_that_they_get_without(server: SyncCheckClient) -> None:
    for i in range(12):
        text = PROGRAM.replace("30)", f"{31 + i // 3})") if i % 4 else PROGRAM.replace("SPEED = 7", f"SPEED = {i + 1}")
        found, plain = check(server, text, seed=i), check(server, text, seed=i, trust=True)
        assert found.ok
        assert (found.scenes, found.iterations, found.ast_hash) == (plain.scenes, plain.iterations, plain.ast_hash)
        assert "seccomp" not in plain.isolation


def test_an_error_is_told_at_its_line(server: SyncCheckClient) -> None:
    for i in range(3):
        assert check(server, PROGRAM.replace("30)", f"{40 + i})")).ok
        report = check(server, PROGRAM.replace("from ego for", "from start.nothing for"))
        found = [d for s in report.stages for d in s.diagnostics]
        assert [(d.stage, d.line) for d in found] == [("compile", 10)]


DRAWN = """param map = localPath('town.xodr')
model scenic.simulators.carla.model
import random
first = random.random()
spot = new OrientedPoint on Uniform(*network.lanes).centerline
ego = new Car at spot
"""


def test_who_draws_numbers_is_executed_with_its_own_seed(server: SyncCheckClient) -> None:
    allow = (("random", "random"), ("random", ""))
    for i in range(4):
        value = random.Random(i).random()
        report = check(server, f"{DRAWN}assert abs(first - {value}) < 1e-9\n", seed=i, allow=allow)
        assert [d.message for s in report.stages for d in s.diagnostics] == []


@pytest.fixture
def region() -> Iterator[tuple[list[float], Any]]:
    """A random region that draws one number, and the numbers that it drew."""
    drawn: list[float] = []

    def sample() -> Any:
        drawn.append(random.random())
        return SimpleNamespace(orientation=None if drawn[-1] < 0.5 else 1)

    state = random.getstate()
    yield drawn, SimpleNamespace(sample=sample)
    random.setstate(state)


def test_the_samples_of_the_compiler_are_drawn_again(region: tuple[list[float], Any]) -> None:
    from scenic.syntax import veneer

    drawn, uncertain = region
    with draws.Draws() as watched:
        answer = veneer.alwaysProvidesOrientation(uncertain)
    assert watched.known
    said = {seed: watched.repeat(seed) for seed in range(20)}
    assert said == {seed: (random.Random(seed).random() >= 0.5) == answer for seed in range(20)}
    assert len(set(drawn)) == 20
    assert watched.repeat(0)
    expected = random.Random(0)
    expected.random()
    assert random.random() == expected.random()


def test_other_draws_are_noticed() -> None:
    with draws.Draws() as watched:
        random.random()
    assert not watched.known


def header(*pieces: str) -> dict[str, Any]:
    return {"pieces": list(pieces), "count": 2, "ego": 4}


def test_what_is_done_ahead() -> None:
    one = ahead.Ahead(None)  # type: ignore[arg-type]
    steps = [("GMPEOT", True, 4), ("GMPEOT", True, 4), ("GMPEoT", False, 4), ("GMPeOT", False, 3), ("GMPEOt", True, 5)]
    for pieces, executed, cut in [*steps, ("GmPEOt", True, 4), ("XmPEOt", False, 0)]:
        one.learn(header(*pieces), executed)
        assert one.cut == cut, pieces


def test_nothing_of_a_trusted_program_is_done_ahead() -> None:
    async def begin() -> Any:
        one = ahead.Ahead(SimpleNamespace(alive=True))  # type: ignore[arg-type]
        one.learn(header(*"GMPEOT"), True)
        one.begin({"trust": True, "filename": "", "params": {}, "limits": {}, "allow": []}, header(*"GMPEOT"), b"")
        return one._task

    assert asyncio.run(begin()) is None


@pytest.mark.full
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")
def test_checks_that_are_cancelled_leave_no_process() -> None:
    from test_snapshots import settled

    async def edit(client: CheckClient, i: int, cancelled_after: float | None) -> None:
        request = CheckRequest(program=PROGRAM.replace("30)", f"{31 + i})"), folder=FOLDER, seed=i)
        task = asyncio.create_task(client.check(request))
        if cancelled_after is not None:
            await asyncio.sleep(cancelled_after)
            task.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await task

    async def work() -> tuple[int, int]:
        async with CheckClient() as client:
            for i in range(4):
                await edit(client, i, None)
            before = await asyncio.to_thread(settled, client.pid)
            for i in range(12):
                await edit(client, i, i * 0.004)
                await asyncio.sleep(0.1)
            await edit(client, 1, None)
            return before, await asyncio.to_thread(settled, client.pid)

    before, after = asyncio.run(work())
    assert after <= before
