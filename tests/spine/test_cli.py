"""The command line as a user meets it: the main job, its JSON, and one clear sentence for each bad input."""

import ctypes
import json
import os
import shlex
import stat
import subprocess
import sys
from importlib.metadata import version

import pytest

from c2s_engine import paths

TEXT = "The ego follows a truck at 40 km/h on a straight road. The truck brakes hard and the ego brakes."

LEAD = """\
param map = localPath('Town05.xodr')
model scenic.simulators.carla.model
spot = new OrientedPoint on Uniform(*network.lanes).centerline
ego = new Car at spot
lead = new Car following roadDirection from spot for 20
terminate after 5 seconds
"""


def c2s(*arguments, stdin=None, before=None, **environment):
    return subprocess.run(
        [sys.executable, "-m", "c2s_engine.cli", *arguments],
        input=stdin,
        capture_output=True,
        timeout=280,
        preexec_fn=before,
        env=os.environ | {"OLLAMA_HOST": "http://127.0.0.1:9"} | environment,
    )


def test_generate_gives_a_program_that_runs(tmp_path):
    out = tmp_path / "scenario.scenic"
    done = c2s("generate", TEXT, "-o", str(out), "--json")
    assert done.returncode == 0, done.stderr
    result = json.loads(done.stdout)
    assert {"structure", "program", "source_map", "stages", "events", "seconds"} <= result.keys()
    assert [s["name"] for s in result["stages"] if not s["ok"]] == []
    assert [s["name"] for s in result["stages"]][-1] == "run"
    assert {"description", "spec", "assumed", "unmet"} <= result["structure"][0].keys()
    assert any(e["event"] == "brake" for e in result["events"])
    assert out.read_text() == result["program"]
    assert (tmp_path / "town.xodr").exists(), "the map lies beside the program"
    again = c2s("check", str(out))
    assert again.returncode == 0, again.stdout


@pytest.mark.full
def test_files_of_a_series_are_of_its_first_seed(tmp_path):
    program, table, drawing = tmp_path / "lead.scenic", tmp_path / "ways.csv", tmp_path / "lead.svg"
    program.write_text(LEAD)
    asked = ["--map", "town", "--seeds", "3-4", "--seconds", "1", "--csv", str(table), "--svg", str(drawing)]
    done = c2s("run", str(program), *asked)
    assert f"{drawing}, {table}: of the run with seed 3" in done.stderr.decode().replace("\n", " "), done.stderr
    assert table.read_text().startswith("run,time_s,object") and "<svg" in drawing.read_text()


@pytest.mark.nightly
def test_fixes_are_counted_in_words(tmp_path):
    program = tmp_path / "lead.scenic"
    program.write_text(LEAD.replace("new Car at", "Car at"))
    assert b"1 fix written to" in c2s("check", str(program), "--fix", "--map", "town").stderr
    assert "new Car at spot" in program.read_text()
    assert b"There was nothing to fix." in c2s("check", str(program), "--fix", "--map", "town").stderr


@pytest.mark.full
def test_the_program_alone_is_on_stdout_and_plain_scenic_takes_it(tmp_path):
    done = c2s("generate", TEXT, "-o", "-", "--no-run")
    assert done.returncode == 0 and b"assumed" in done.stderr
    program, town = tmp_path / "piped.scenic", tmp_path / "town.xodr"
    program.write_bytes(done.stdout)
    town.write_bytes(paths.shipped("maps", "town.xodr").read_bytes())
    plain = f"import scenic; scenic.scenarioFromFile({str(program)!r}).generate(maxIterations=500)"
    compiled = subprocess.run([sys.executable, "-c", plain], capture_output=True, text=True, timeout=120)
    assert compiled.returncode == 0, compiled.stderr


@pytest.mark.full
def test_a_turn_that_nobody_listens_to_is_done_all_the_same(tmp_path):
    """As `c2s edit ... 2>&1 | head -1` leaves it."""
    env = {**os.environ, "XDG_DATA_HOME": str(tmp_path)}
    command = f"{sys.executable} -m c2s_engine.cli edit one --new --no-run --say {shlex.quote(TEXT)} 2>&1 | head -1"
    subprocess.run(command, shell=True, env=env, timeout=90, check=True, stdout=subprocess.DEVNULL)
    listed = c2s("edit", "one", "--json", XDG_DATA_HOME=str(tmp_path))
    assert json.loads(listed.stdout)["program"]


def test_the_version():
    assert c2s("--version").stdout.decode() == f"c2s {version('c2s')}\n"


def one_sentence(done, code):
    assert done.returncode == code, (done.returncode, done.stderr)
    message = done.stderr.decode()
    assert "Traceback" not in message + done.stdout.decode()
    assert 1 <= len(message.strip().splitlines()) <= 6, message
    return " ".join(message.split())


@pytest.mark.parametrize(
    ("arguments", "stdin", "says"),
    [
        (["generate", ""], None, "description is empty"),
        (["generate"], None, "Give a description"),
        (["generate", "-"], b"\x00\x01\x02\x7fELF", "binary"),
        (["generate", "-"], b"the car stops. " * 70_000, "at most"),
        (["generate", "--file", "/nonexistent/a.txt"], None, "no file"),
        (["generate", "-f", "."], None, "folder"),
        (["generate", TEXT, "-o", "/nonexistent/dir/a.scenic"], None, "no folder"),
        (["generate", TEXT, "--widen", "--no-run"], None, "remove --no-run"),
        (["generate", TEXT, "--contradictions", "--no-run"], None, "remove --no-run"),
        (["check", "/nonexistent.scenic"], None, "no file"),
        (["run", "."], None, "folder"),
    ],
    ids=[
        "empty",
        "nothing",
        "binary",
        "1 MB",
        "no file",
        "a folder",
        "no folder",
        "widen",
        "contradictions",
        "no program",
        "run a folder",
    ],  # fmt: skip
)
def test_bad_input_gets_one_sentence(arguments, stdin, says):
    assert says in one_sentence(c2s(*arguments, stdin=stdin), 2)


@pytest.mark.full
def test_an_unknown_map_names_those_there_are():
    done = c2s("generate", TEXT, "--map", "Atlantis")
    assert done.returncode == 2
    assert "town" in done.stderr.decode()


def test_a_broken_program_says_where(tmp_path):
    file = tmp_path / "broken.scenic"
    file.write_text("param map = localPath('town.xodr')\nmodel scenic.simulators.carla.model\nego = new Car at (\n")
    done = c2s("check", str(file))
    assert done.returncode == 1
    assert "line 3" in done.stdout.decode()


@pytest.mark.full
def test_another_persons_program_on_a_map_of_ours(tmp_path):
    program = tmp_path / "lead.scenic"
    program.write_text(LEAD)
    assert b"--map" in c2s("check", str(program)).stdout, "what to do where its map is not here"
    assert c2s("check", str(program), "--map", "town").returncode == 0
    nowhere = c2s("check", str(program), "--map", "Nowhere")
    assert nowhere.returncode and b"Known maps: town" in nowhere.stderr
    home = {"XDG_DATA_HOME": str(tmp_path)}
    taken = c2s("edit", "lead", "--program", str(program), "--no-run", "--json", **home)
    assert json.loads(taken.stdout)["program"] == LEAD
    assert [c["id"] for c in json.loads(taken.stdout)["structure"]] == ["G", "R", "E", "O1", "T"]


@pytest.mark.full
def test_no_permission(tmp_path):
    tmp_path.chmod(stat.S_IRUSR | stat.S_IXUSR)
    done = c2s("generate", TEXT, "--no-run", "-o", str(tmp_path / "a.scenic"), before=obey_permissions)
    assert "permission" in one_sentence(done, 3)


def obey_permissions():
    """Root, too: gives up the capability to write everywhere (prctl PR_CAPBSET_DROP, CAP_DAC_OVERRIDE)."""
    if os.geteuid() == 0:
        ctypes.CDLL(None).prctl(24, 1, 0, 0, 0)


def test_a_full_disk_loses_nothing():
    if not os.path.exists("/dev/full"):
        pytest.skip("no /dev/full here")
    from pathlib import Path

    from c2s_engine.saving import save
    from c2s_engine.structure.program import Program

    with pytest.raises(OSError):
        save(Program(text="x = 1\n"), [], Path("/dev/full/a.scenic"))


def test_the_front_imports_no_heavy_package():
    code = (
        "import sys, c2s_engine.api, c2s_engine.cli, c2s_engine.session.graph, c2s_engine.session.steps;"
        "heavy = {'torch', 'lancedb', 'scenic', 'sentence_transformers', 'textual'} & set(sys.modules);"
        "assert not heavy, heavy"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)
