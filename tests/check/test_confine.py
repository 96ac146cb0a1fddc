"""The second wall: what a confined process cannot do, also where the allow-list would have let it through."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from c2s_engine.check import confine, seccomp

pytestmark = pytest.mark.skipif(not confine.supported(), reason="the filter is for x86-64 Linux")

REFUSED = [
    "(folder / 'new').write_text('x')",
    "(folder / 'secret.txt').unlink()",
    "(folder / 'secret.txt').rename(folder / 'other')",
    "(folder / 'new').mkdir()",
    "(folder / 'secret.txt').read_text()",
    "os.listdir(folder)",
    "socket.socket()",
    "socket.socketpair()",
    "os.fork()",
    "subprocess.run(['true'])",
    "os.execv('/bin/true', ['true'])",
    "os.kill(os.getppid(), 0)",
    "os.setsid()",
    "os.symlink('a', folder / 'b')",
]
ALLOWED = [
    "__import__('scenic.core.vectors')",
    "threading.Thread(target=print).start()",
    "open(__import__('json').__file__).read()",
    "open('/dev/null').read()",
    "(folder / 'a.xodr').read_text()",
]
CODE = """
import json, os, socket, subprocess, sys, threading
from pathlib import Path
from c2s_engine.check import confine
folder = Path(sys.argv[1])
job = {"limits": {"memory": 4 << 30, "cpu": 20}, "filename": str(folder / "x.scenic")}
for attempt in json.loads(sys.argv[2]):
    sys.stdout.flush()
    if os.fork():
        os.wait()
        continue
    said = confine.confine(job)
    try:
        eval(attempt)
        result = "done"
    except BaseException as error:
        result = type(error).__name__
    print(json.dumps([attempt, said, result]), flush=True)
    os._exit(0)
"""


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> dict[str, tuple[str, str]]:
    """What becomes of each attempt in a confined process of its own."""
    folder = tmp_path_factory.mktemp("confined")
    (folder / "secret.txt").write_text("x")
    (folder / "a.xodr").write_text("x")
    command = [sys.executable, "-c", CODE, str(folder), json.dumps([*REFUSED, *ALLOWED])]
    out = subprocess.run(command, capture_output=True, text=True, timeout=60).stdout
    assert sorted(p.name for p in folder.iterdir()) == ["a.xodr", "secret.txt"]
    return {attempt: (said, result) for attempt, said, result in map(json.loads, filter(None, out.splitlines()))}


@pytest.mark.parametrize("attempt", REFUSED)
def test_refused(results: dict[str, tuple[str, str]], attempt: str) -> None:
    said, result = results[attempt]
    assert "seccomp" in said
    assert result in ("PermissionError", "OSError")


@pytest.mark.parametrize("attempt", ALLOWED)
def test_allowed(results: dict[str, tuple[str, str]], attempt: str) -> None:
    assert results[attempt][1] == "done"


def test_the_filter_names_each_call_once(tmp_path: Path) -> None:
    assert len(set(seccomp.REFUSED.values())) == len(seccomp.REFUSED)
