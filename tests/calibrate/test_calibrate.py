"""`c2s calibrate`: manoeuvres in the dry run and in CARLA, here a stand-in for it behind Scenic's own interface, which
obeys a known number of ticks late (standin/carla)."""

import asyncio
import json
import os
import re
import socket
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from c2s_engine import cli
from c2s_engine.calibrate.driving import Carla
from c2s_engine.calibrate.manoeuvres import manoeuvres
from c2s_engine.calibrate.measures import MEASURES, way_of
from c2s_engine.dryrun import carla
from c2s_engine.structure.facts import Track, Trajectories

HERE = Path(__file__).parent
STANDIN = (HERE / "standin", HERE.parents[1] / "data" / "standins")


def calibrate(*arguments: str) -> tuple[int, dict]:
    """The exit code and the JSON of the command."""
    cli._mount("calibrate")
    result = CliRunner().invoke(cli.app, ["calibrate", "--json", *arguments])
    return result.exit_code, json.loads(result.stdout)


def rows(said: dict) -> dict[tuple[str, str], dict]:
    return {(row["manoeuvre"], row["measure"]): row for row in said["rows"]}


@pytest.fixture
def server(monkeypatch):
    """Something that listens, and the stand-in for the client's package on the path."""
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(map(str, STANDIN)))
    for folder in reversed(STANDIN):
        monkeypatch.syspath_prepend(str(folder))
    with socket.create_server(("127.0.0.1", 0)) as listening:
        yield listening


def address(server: socket.socket) -> str:
    return f"127.0.0.1:{server.getsockname()[1]}"


def test_measures_of_a_known_way():
    """Northwards at 10 m/s for 1 s, then braking at 5 m/s2 to a stand, 2 m to the left; the other stands 30 m ahead."""
    times = [k / 10 for k in range(41)]
    braked = [max(0.0, min(2.0, t - 1)) for t in times]
    speed = tuple(10 - 5 * b for b in braked)
    y = tuple(10 * min(t, 1) + 10 * b - 2.5 * b * b for t, b in zip(times, braked, strict=True))
    x = tuple(-b for b in braked)
    ego = Track(name="ego", x=x, y=y, heading=(0.0,) * 20 + (6.2,) * 21, speed=speed, length=4, width=2)
    still = (0.0,) * 41
    other = Track(name="other", x=still, y=(30.0,) * 41, heading=still, speed=still, length=6, width=2)
    way = way_of(Trajectories(step=0.1, tracks=(ego, other)), 0)
    expected = {
        ("speed", 2): 5, ("reaches", 10): 0, ("reaches", 11): None, ("along", 1): 10, ("along", 9): None,
        ("aside", 2): 1, ("most_aside",): 2, ("turned", 3): -4.766, ("stands",): 3, ("stops_at",): 20,
        ("braking_distance", 8): 6.4, ("gap", 1): 15, ("least_gap",): (10**2 + 2**2) ** 0.5 - 5,
    }  # fmt: skip
    assert {name for name, *_ in expected} == set(MEASURES)
    for (name, *argument), value in expected.items():
        assert MEASURES[name][2](way, *argument) == (value if value is None else pytest.approx(value, abs=0.02)), name


def test_a_dozen_manoeuvres_each_with_measures_of_its_own():
    known = manoeuvres()
    assert len(known) >= 12
    for manoeuvre in known.values():
        told = [m.description for m in manoeuvre.measures]
        assert len(told) == len(set(told)) >= 2, manoeuvre.name


@pytest.mark.full
def test_the_dry_run_alone():
    code, said = calibrate("--dry", "--only", "brake_hard", "--only", "walker_crosses")
    found = rows(said)
    assert code == 0 and said["carla"] is None
    assert found["brake_hard", "way from 19 m/s to a stand"]["dry_run"] == pytest.approx(19**2 / 16, abs=1)
    assert found["walker_crosses", "other: speed at 3 s"]["dry_run"] == pytest.approx(1.4, abs=0.01)


@pytest.mark.full
def test_a_server_that_obeys_a_tick_late_is_seen_to(server):
    """A walker who sets out 0.1 s later and halts 0.1 s later is 0.14 m behind and goes 0.14 m farther."""
    code, said = calibrate("--address", address(server), "--only", "walker_crosses")
    found = {measure: row["difference"] for (_, measure), row in rows(said).items()}
    assert code == 0
    assert found == pytest.approx(
        {"other: speed at 3 s": 0, "other: way ahead at 4 s": -0.14, "other: way to a stand": 0.14}, abs=0.005
    )


@pytest.mark.full
def test_a_server_that_drives_as_the_dry_run_differs_in_nothing(server, monkeypatch):
    monkeypatch.setenv("STANDIN_LAG", "0")
    code, said = calibrate("--address", address(server), *(f"--only={n}" for n in ("turn_left", "follow")))
    assert code == 0
    assert {row["measure"]: row["difference"] for row in said["rows"] if abs(row["difference"]) > 0.02} == {}


@pytest.mark.full
@pytest.mark.skipif(not carla._installed(), reason="needs the real client: the extra [carla]")
def test_the_real_client_and_a_server_on_the_wire():
    """CARLA's own client package against the stand-in as a server (standin/wire.py)."""
    port = 20000 + os.getpid() % 10000
    path = {"PYTHONPATH": os.pathsep.join(map(str, (*STANDIN, HERE.parents[1]))), "STANDIN_LAG": "0"}
    command = [sys.executable, str(HERE / "standin" / "wire.py"), str(port)]
    with subprocess.Popen(command, env=os.environ | path, stdout=subprocess.PIPE, text=True) as wire:
        try:
            assert wire.stdout.readline() == "ready\n"
            code, said = calibrate("--address", f"127.0.0.1:{port}", "--only", "turn_left", "--only", "walker_crosses")
        finally:
            wire.kill()
    assert code == 0
    assert {row["measure"]: row["difference"] for row in said["rows"] if abs(row["difference"]) > 0.02} == {}


@pytest.mark.full
def test_what_a_map_has_no_place_for_is_told(server, monkeypatch, tmp_path):
    text = (HERE.parents[1] / "data" / "maps" / "town.xodr").read_text(encoding="utf-8")
    text = re.sub(r'max="\d+"', 'max="8"', text).replace('type="motorway"', 'type="town"')
    without = tmp_path / "slow.xodr"
    without.write_text(text, encoding="utf-8")
    code, said = calibrate("--dry", "--map", str(without), "--only", "lane_change_left")
    assert code == 1 and "nothing on this map fits" in said["rows"][0]["why"]["dry_run"]


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (("--address", "127.0.0.1:1"), 3, "No CARLA server answers at 127.0.0.1:1"),
        (("--address", "127.0.0.1:many"), 2, "say HOST:PORT"),
        (("--dry", "--only", "fly"), 2, "There is no manoeuvre fly: there are keep_speed,"),
        (("--dry", "--map", "Atlantis"), 2, "There is no map named Atlantis"),
    ],
)
def test_bad_input_gets_a_sentence_and_an_exit_code(server, arguments, code, words):
    found, said = calibrate(*arguments)
    assert found == code and words in said["error"]


def test_without_the_client_s_package_it_is_named(monkeypatch):
    monkeypatch.setattr(carla, "_installed", lambda: False)
    code, said = calibrate()
    assert code == 3 and "pip install 'c2s[carla]'" in said["error"] and "--dry" in said["error"]


@pytest.mark.full
def test_what_listens_but_is_no_carla_is_told(server, monkeypatch):
    monkeypatch.setenv("STANDIN_MUTE", "1")
    code, said = calibrate("--address", address(server), "--only", "keep_speed")
    assert code == 3 and said["error"].endswith("cannot be used: time-out of 10000ms while waiting for the simulator")


async def test_a_cancelled_run_leaves_no_process(server, monkeypatch, tmp_path):
    monkeypatch.setenv("STANDIN_HANGS", "1")
    server.setblocking(False)
    drive = asyncio.create_task(Carla(*server.getsockname())(manoeuvres()["keep_speed"], tmp_path / "program.scenic"))
    came = asyncio.create_task(asyncio.get_running_loop().sock_accept(server))
    await asyncio.wait({drive, came}, return_when=asyncio.FIRST_COMPLETED)
    with came.result()[0] as there:
        there.setblocking(True)
        process = int(there.makefile().read())
    drive.cancel()
    with pytest.raises(asyncio.CancelledError):
        await drive
    with pytest.raises(ProcessLookupError):
        os.kill(process, 0)
