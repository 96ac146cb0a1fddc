"""The recording of the demo: how it is made, and that the one in docs is whole."""

import json
import os
import pty
import time
from pathlib import Path

import pytest

from c2s_bench.ui import demo

DOCS = Path(__file__).parents[2] / "docs"


def test_a_step_records_what_comes_and_waits_for_what_is_wanted(monkeypatch):
    monkeypatch.setattr(demo, "IDLE", 0.01)
    monkeypatch.setattr(demo, "PATIENCE", 0.3)
    ours, theirs = pty.openpty()  # its line discipline echoes what is typed
    try:
        recorder = demo.Recorder(ours, time.perf_counter())
        recorder.step("ego brakes", "ego brakes")
        with pytest.raises(TimeoutError, match="never showed 'a van'"):
            recorder.step("!", "a van")
    finally:
        os.close(ours)
        os.close(theirs)
    times = [when for when, _, _ in recorder.events]
    assert "".join(text for _, _, text in recorder.events) == "ego brakes!" and times == sorted(times)


def test_the_recording_in_the_documents_shows_every_step():
    header, *lines = (DOCS / "demo.cast").read_text("utf-8").splitlines()
    events = [json.loads(line) for line in lines]
    assert json.loads(header)["version"] == 2 and json.loads(header)["width"] == demo.SIZE[1]
    assert [e[0] for e in events] == sorted(e[0] for e in events) and {e[1] for e in events} == {"o"}
    words = demo.ESCAPES.sub("", "".join(e[2] for e in events)).replace(" ", "")
    assert all(wanted.replace(" ", "") in words for _, wanted in demo.STEPS)
