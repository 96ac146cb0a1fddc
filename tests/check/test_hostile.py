"""Hostile programs: none reaches its goal, each is refused or stopped within the limits, with a diagnostic."""

import json
import re
import socket
from pathlib import Path

import pytest

from c2s_engine import paths
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.protocol import CheckRequest, Limits

CORPUS = sorted((Path(__file__).parent / "hostile").glob("*.scenic"))
SLOW = re.compile(r"loop_|memory_|impossible|huge|power|recursion|threads")
LIMITS = Limits(wall=3, cpu=3, sample_seconds=1)
SECRET = "the words that nobody may read"


def marked(path: Path):
    return pytest.param(path, id=path.stem, marks=[pytest.mark.full] if SLOW.match(path.stem) else [])


def test_the_corpus_is_large() -> None:
    assert len(CORPUS) >= 60


@pytest.mark.parametrize("path", [marked(p) for p in CORPUS])
def test_nothing_is_reached(server: SyncCheckClient, tmp_path: Path, path: Path) -> None:
    mark, secret = tmp_path / "mark", tmp_path / "secret.txt"
    secret.write_text(SECRET)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        listener.setblocking(False)
        port = listener.getsockname()[1]
        text = path.read_text(encoding="utf-8").replace("MARK", str(mark)).replace("SECRET", str(secret))
        text = text.replace("PORT", str(port))
        upto = re.search(r"^# upto: (\w+)$", text, re.M)[1]  # type: ignore[index]
        request = CheckRequest(program=text, folder=str(paths.shipped("maps")), upto=upto, limits=LIMITS)  # type: ignore[arg-type]
        report = server.check(request)
        with pytest.raises(BlockingIOError):
            listener.accept()
    assert not mark.exists()
    assert secret.read_text() == SECRET
    assert SECRET not in json.dumps(report.model_dump(mode="json"))
    found = [d for s in report.stages for d in s.diagnostics if d.severity == "error"]
    assert not report.ok
    assert found
    assert all(d.message for d in found)


@pytest.mark.full
def test_the_server_is_unharmed(server: SyncCheckClient) -> None:
    program = (Path(__file__).parent / "programs" / "follow_lane.scenic").read_text(encoding="utf-8")
    assert server.check(CheckRequest(program=program, folder=str(paths.shipped("maps")))).ok
