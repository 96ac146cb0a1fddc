"""The server as its users see it: stages, facts, cancelling, several at a time, restarting, limits, places."""

import asyncio
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from c2s_engine import paths
from c2s_engine.check.client import CheckClient, CheckError, SyncCheckClient
from c2s_engine.check.protocol import CheckRequest, Limits, PlacesRequest
from c2s_engine.structure.program import FragmentSpan

HERE = Path(__file__).parent
MAPS = paths.shipped("maps")
GOOD = (HERE / "programs" / "works.scenic").read_text(encoding="utf-8")
ENDLESS = GOOD + "while True:\n    pass\n"


def request(program: str = GOOD, **more) -> CheckRequest:
    return CheckRequest(program=program, folder=str(MAPS), **more)


def test_stages_in_their_order(server: SyncCheckClient) -> None:
    report = server.check(request(upto="run", runs=2, trajectories=True))
    assert [s.name for s in report.stages] == ["parse", "safety", "compile", "sample", "run"]
    assert report.ok
    assert len(report.facts) == len(report.scenes) == len(report.trajectories) == len(report.iterations) == 2
    assert [f.seed for f in report.facts] == [0, 1]
    assert len(report.ast_hash) == 8
    assert "CPU time" in report.isolation


@pytest.mark.parametrize("upto", ["parse", "safety", "compile", "sample"])
def test_no_further_than_asked(server: SyncCheckClient, upto: str) -> None:
    assert server.check(request(upto=upto)).stages[-1].name == upto


def test_names_and_components(server: SyncCheckClient) -> None:
    lines = GOOD.split("\n")
    cones = next(i for i, line in enumerate(lines, 1) if line.startswith("cones"))
    ego = next(i for i, line in enumerate(lines, 1) if line.startswith("ego"))
    spans = (FragmentSpan(component="E", first=ego, last=ego), FragmentSpan(component="O1", first=cones, last=cones))
    facts = server.check(request(upto="run", spans=spans)).facts[0]
    assert {o.name: o.component for o in facts.objects} == {
        "ego": "E", "cones[0]": "O1", "cones[1]": "O1", "cones[2]": "O1", "cones[3]": "O1", "barrier": None,
    }  # fmt: skip


def test_names_in_a_list_that_a_behavior_reads(server: SyncCheckClient) -> None:
    head = "".join(line + "\n" for line in GOOD.split("\n")[:4])
    row = "behavior B():\n    take SetBrakeAction(len(row) / 2)\n" \
        "spot = Uniform(*network.lanes)\nego = new Car on spot\n" \
        "row = [new Car at spot.centerline.pointAlongBy(9 * i + 9), with behavior B() for i in range(2)]\n"
    report = server.check(request(head + row, upto="run"))
    assert report.ok, report.stages
    assert [o.name for o in report.facts[0].objects] == ["ego", "row[0]", "row[1]"]


def test_seeds_decide_scenes(server: SyncCheckClient) -> None:
    one, again, other = (server.check(request(seed=s)).scenes for s in (5, 5, 6))
    assert one == again != other


def test_parameters_override_the_program(server: SyncCheckClient) -> None:
    report = server.check(request(params={"map": str(MAPS / "nowhere.xodr")}))
    assert [d.code for s in report.stages for d in s.diagnostics] == ["map_missing"]


def test_wall_time_is_limited(server: SyncCheckClient) -> None:
    report = server.check(request(ENDLESS, limits=Limits(wall=1)))
    assert [d.code for s in report.stages for d in s.diagnostics] == ["limit_wall"]


@pytest.mark.full
def test_cpu_time_is_limited(server: SyncCheckClient) -> None:
    report = server.check(request(ENDLESS, limits=Limits(cpu=1, wall=60)))
    assert [d.code for s in report.stages for d in s.diagnostics] == ["limit_cpu"]


def test_output_is_limited(server: SyncCheckClient) -> None:
    report = server.check(request(GOOD + "print('x' * 2000)\n", limits=Limits(output=1000)))
    assert [d.code for s in report.stages for d in s.diagnostics] == ["output_limit"]
    assert server.check(request(GOOD + "print('{\"id\": 1}')\n")).ok


def test_trust_skips_the_allow_list(server: SyncCheckClient) -> None:
    program = GOOD + "import string\n"
    assert not server.check(request(program)).ok
    report = server.check(request(program, trust=True))
    assert report.ok
    assert "trusted" in report.isolation
    assert server.check(request(program, allow=(("string", "*"),))).ok


def test_places(server: SyncCheckClient) -> None:
    expressions = {
        "lanes": "network.lanes",
        "turns": "[m for i in network.intersections for m in i.maneuvers if m.type is ManeuverType.LEFT_TURN]",
        "wrong": "network.lines",
        "none": "filter(lambda l: l.uid == 'nowhere', network.lanes)",
        "Scenic's own": "[a for a in (-90 deg, 90 deg) if a < 0]",
    }
    report = server.places(PlacesRequest(map=str(MAPS / "town.xodr"), expressions=expressions))
    assert report.counts["lanes"] > 10
    assert report.counts["turns"] > 0
    assert report.counts["none"] == 0
    assert report.counts["Scenic's own"] == 1
    assert list(report.errors) == ["wrong"]
    assert len(report.at["lanes"]) == min(50, report.counts["lanes"])


def test_places_without_a_map(server: SyncCheckClient) -> None:
    with pytest.raises(CheckError, match="no map file"):
        server.places(PlacesRequest(map="/nowhere.xodr", expressions={"a": "network.lanes"}))


async def test_cancelling_kills_and_others_go_on() -> None:
    async with CheckClient() as client:
        endless = asyncio.create_task(client.check(request(ENDLESS)))
        reports = await asyncio.gather(*(client.check(request(seed=s)) for s in range(3)))
        assert all(r.ok for r in reports)
        endless.cancel()
        with pytest.raises(asyncio.CancelledError):
            await endless
        assert (await client.check(request())).ok
        assert await _settled(client) == 0


async def _settled(client: CheckClient) -> int:
    """How many processes of the server still spin, once it has taken in the cancellation."""
    spinning = -1
    for _ in range(50):
        await client.check(request(upto="parse"))
        spinning = _spinning(client)
        if spinning == 0:
            break
    return spinning


def _spinning(client: CheckClient) -> int:
    listing = subprocess.run(["ps", "-eo", "pid,ppid,stat"], capture_output=True, text=True).stdout
    assert client._process is not None
    family = {str(client._process.pid)}
    rows = [line.split() for line in listing.splitlines()[1:]]
    for _ in rows:
        family |= {r[0] for r in rows if r[1] in family}
    return sum(1 for r in rows if r[0] in family and r[2].startswith("R"))


@pytest.mark.full
async def test_a_dead_server_is_started_again_and_says_so() -> None:
    async with CheckClient() as client:
        await client.ready()
        endless = asyncio.create_task(client.check(request(ENDLESS)))
        await client.check(request(upto="parse"))
        assert client._process is not None
        os.kill(client._process.pid, signal.SIGKILL)
        with pytest.raises(CheckError, match="stopped"):
            await endless
        assert (await client.check(request())).ok


@pytest.mark.full
async def test_any_process_of_the_server_may_die() -> None:
    """What was being checked is reported or checked all the same; the next check is as good as ever."""
    async with CheckClient() as client:
        assert (await client.check(request())).ok
        for number in range(1, len(_family(client.pid))):
            endless = asyncio.create_task(client.check(request(ENDLESS, limits=Limits(wall=5))))
            await client.check(request())
            os.kill(_family(client.pid)[number], signal.SIGKILL)
            try:
                assert not (await endless).ok
            except CheckError as error:
                assert "ended" in str(error)
            assert (await client.check(request())).ok


def _family(pid: int) -> list[int]:
    """The server's process and, in the order of their making, those under it."""
    found = [pid]
    for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split():
        found += _family(int(child))
    return sorted(found)


def test_the_front_imports_no_scenic() -> None:
    code = "import sys, c2s_engine.check.client; print([m for m in sys.modules if m.startswith(('scenic', 'torch'))])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "[]\n"


@pytest.mark.parametrize("text", ["garbage", "<OpenDRIVE></OpenDRIVE>"])
def test_broken_maps(server: SyncCheckClient, tmp_path: Path, text: str) -> None:
    (tmp_path / "broken.xodr").write_text(text)
    program = "param map = localPath('broken.xodr')\nmodel scenic.simulators.carla.model\nego = new Car\n"
    report = server.check(CheckRequest(program=program, folder=str(tmp_path)))
    assert [d.code for s in report.stages for d in s.diagnostics] == ["map_broken"]
