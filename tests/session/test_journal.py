"""What is on the disk before it is in a checkpoint: the turn that is worked on, and drafts; also through kill -9."""

import json
import os
import random
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from session_fake import FakeEngine

from c2s_engine.session import journal as session_journal
from c2s_engine.session.journal import Drafts, Journal
from c2s_engine.session.sessions import SessionError, Sessions
from c2s_engine.structure.edits import SetField

HERE = Path(__file__).parent


def test_a_turn_without_its_end_is_pending(tmp_path):
    journal = Journal(tmp_path / "j")
    done = journal.begin("say", "first")
    journal.end(done)
    edit = SetField(component="O1", path="count", value=3)
    journal.begin("apply", "second", (edit,), options={"seed": 4})
    again = Journal(tmp_path / "j").pending
    assert again and (again.kind, again.text, again.edits, again.options) == ("apply", "second", (edit,), {"seed": 4})
    third = Journal(tmp_path / "j").begin("say", "third")
    assert third.number == 3 and Journal(tmp_path / "j").pending == third


@pytest.mark.parametrize("cut", [1, 5, 40])
def test_a_torn_line_loses_itself_only(tmp_path, cut):
    journal = Journal(tmp_path / "j")
    first = journal.begin("say", "kept, käpt")
    whole = (tmp_path / "j").read_bytes()
    journal.begin("say", "torn")
    line = (tmp_path / "j").read_bytes()[len(whole) :]
    (tmp_path / "j").write_bytes(whole + line[:-cut])
    again = Journal(tmp_path / "j")
    assert again.pending == first
    new = again.begin("say", "new")
    assert Journal(tmp_path / "j").pending == new


def test_the_journal_is_bounded(tmp_path, monkeypatch):
    monkeypatch.setattr(session_journal, "COMPACT_AT", 2000)
    journal = Journal(tmp_path / "j")
    for _ in range(40):
        journal.end(journal.begin("say", "x" * 300))
    assert (tmp_path / "j").stat().st_size < 3000
    assert Journal(tmp_path / "j").begin("say", "next").number == 41


def test_drafts(tmp_path):
    drafts = Drafts(tmp_path / "d")
    text = "a\r\nb\n\tü"
    drafts.save("chat", text)
    drafts.save("code", "x")
    assert Drafts(tmp_path / "d").load("chat") == text and drafts.panes() == ["chat", "code"]
    drafts.save("chat", "")
    assert drafts.load("chat") == "" and drafts.panes() == ["code"]
    with pytest.raises(SessionError, match="no name of a pane"):
        drafts.save("../x", "y")


async def test_an_interrupted_turn_is_offered_and_resumed(tmp_path):
    session = Sessions(tmp_path).open("one", FakeEngine())
    session._journal.begin("say", "car")
    session.close()
    session = Sessions(tmp_path).open("one", FakeEngine())
    assert session.pending and session.pending.text == "car"
    _ = [event async for event in session.resume()]
    assert [o.description for o in session.structure.objects] == ["car"] and session.pending is None
    with pytest.raises(SessionError, match="no turn was interrupted"):
        session.resume()


async def test_what_was_sent_is_offered_also_before_its_turn_began(tmp_path):
    session = Sessions(tmp_path).open("one", FakeEngine())
    session.note_sent("car", method="reader")
    session.close()
    session = Sessions(tmp_path).open("one", FakeEngine())
    assert session.pending and (session.pending.text, session.pending.options) == ("car", {"method": "reader"})
    session.note_sent("bus")
    _ = [event async for event in session.say("bus")]
    assert session.pending is None and [o.description for o in session.structure.objects] == ["bus"]
    session.close()
    assert Sessions(tmp_path).open("one", FakeEngine()).pending is None


CHILD = """
import asyncio, sys
from pathlib import Path
from c2s_engine.session.sessions import Sessions
from session_fake import FakeEngine

async def main():
    session = Sessions(Path(sys.argv[1])).open("one", FakeEngine())
    print("open", flush=True)
    for k in range(int(sys.argv[2]), 10**6):
        session.save_draft("chat", f"text {k}")
        print("draft", k, flush=True)
        events = session.say(f"text {k}")
        await anext(events)
        print("asked", k, flush=True)
        async for _ in events:
            pass
        print("done", k, len(session.structure.objects), flush=True)

asyncio.run(main())
"""


def _killed(folder, start, lines):
    """What the child told before it was killed with SIGKILL after that many lines."""
    environment = {**os.environ, "PYTHONPATH": str(HERE)}
    command = [sys.executable, "-c", CHILD, str(folder), str(start)]
    told = []
    with subprocess.Popen(command, stdout=subprocess.PIPE, env=environment, text=True) as child:
        for line in child.stdout:
            told.append(line.split())
            if len(told) >= lines:
                child.send_signal(signal.SIGKILL)
                told += [rest.split() for rest in child.stdout]
                break
    assert child.returncode == -signal.SIGKILL
    return told


@pytest.mark.parametrize("lines", [3, 9, pytest.param(0, marks=pytest.mark.full)])
def test_kill_9_loses_nothing_that_was_told(tmp_path, lines):
    drawn = random.Random(7)
    start = 0
    for lines_now in [lines] if lines else [drawn.randint(2, 30) for _ in range(8)]:
        told = _killed(tmp_path, start, lines_now)
        last = {word: [int(x) for x in numbers] for word, *numbers in told}
        session = Sessions(tmp_path).open("one", FakeEngine())
        count = len(session.structure.objects)
        done = last["done"][1] if "done" in last else start
        assert done <= count <= done + 1
        assert [o.description for o in session.structure.objects] == [f"text {k}" for k in range(count)]
        assert len(session.history) == count
        asked = last.get("asked", [-1])[0]
        if asked >= count:
            assert session.pending and session.pending.text == f"text {asked}"
        draft = session.draft("chat")
        assert draft in {f"text {last['draft'][0]}", f"text {last['draft'][0] + 1}"}
        json.loads(session.structure.model_dump_json())
        session.close()
        start = count
