"""`python -m c2s_bench.ui.demo docs/demo.cast`: records the first two minutes of the README as they are now.

The app runs in a pseudo-terminal; each step of STEPS types something and waits until the app shows what it is to show.
The recording is of asciinema's format (version 2): `asciinema play docs/demo.cast`.
"""

import argparse
import json
import os
import re
import sys
import tempfile
import time
from pathlib import Path

from c2s_bench.ui.terminal import read, running

SIZE = (30, 110)  # rows, columns
IDLE = 1.2
"""s to which a player shortens what lasts longer without anything on the screen."""
KEY_SECONDS = 0.03
PATIENCE = 180.0
ESCAPES = re.compile(r"\x1b(?:\[[0-9;?<>=]*[a-zA-Z]|[\]P_][^\x07\x1b]*(?:\x07|\x1b\\)|[()][A-Z0-9]|.)")
F2, F6, F9, ESC, ENTER, UP = "\x1bOQ", "\x1b[17~", "\x1b[20~", "\x1b", "\r", "\x1b[A"

TEXT = (
    "At dusk ego drives at 50 km/h on a road with two lanes. A cyclist rides out from the right in front of ego, "
    "and ego brakes."
)
STEPS: tuple[tuple[str, str], ...] = (  # what is typed, what the screen must show then
    ("", "Describe, ask, change"),
    (TEXT, ""),
    (ENTER, "requirements met"),
    (F6, "Events"),
    (F9, "north"),
    *((UP, f"{second}.0 of") for second in range(1, 6)),
    (ESC, "Outcome"),
    (F2, "requirements met"),
    ("make the cyclist 20 km/h", ""),
    (ENTER, "O1 written"),
    ("how close did they come?", ""),
    (ENTER, "apart"),
)


class Recorder:
    """What a terminal is sent, with the times, and what of it is words."""

    def __init__(self, end: int, started: float):
        self.end, self.started = end, started
        self.events: list[tuple[float, str, str]] = []
        self._rest = b""

    def step(self, keys: str, wanted: str) -> None:
        """Type, key by key where it is a text, and wait until the screen shows what is wanted; raises TimeoutError."""
        shown = ""
        for key in [keys] if keys.startswith("\x1b") or len(keys) < 2 else keys:
            os.write(self.end, key.encode())
            shown += self._take(KEY_SECONDS)
        deadline = time.monotonic() + PATIENCE
        while wanted not in shown and wanted.replace(" ", "") not in shown.replace(" ", ""):
            if time.monotonic() > deadline:
                raise TimeoutError(f"after {keys!r} the app never showed {wanted!r}, but {shown[-400:]!r}")
            shown += self._take(0.2)
        self._take(2 * IDLE)

    def _take(self, seconds: float) -> str:
        """Record what comes within some time; its words."""
        words, deadline = "", time.monotonic() + seconds
        while (left := deadline - time.monotonic()) > 0:
            data = self._rest + read(self.end, left)
            text = data.decode("utf-8", "ignore")
            self._rest = data[len(text.encode()) :] if len(data) - len(text.encode()) < 4 else b""
            if text:
                self.events.append((round(time.perf_counter() - self.started, 4), "o", text))
                words += ESCAPES.sub("", text)
        return words


def record(target: Path) -> None:
    """Record the steps and write the file."""
    with tempfile.TemporaryDirectory() as folder:
        caches = os.environ.get("XDG_CACHE_HOME", str(Path.home() / ".cache"))
        app = running(folder, "demo", SIZE, COLORTERM="", XDG_CACHE_HOME=caches, TMUX="")  # 256 colours: a small file
        with app as (_pid, end, started):
            recorder = Recorder(end, started)
            for keys, wanted in STEPS:
                recorder.step(keys, wanted)
    header = {
        "version": 2, "width": SIZE[1], "height": SIZE[0], "idle_time_limit": IDLE,
        "title": "c2s: the first two minutes", "timestamp": int(time.time()),
        "env": {"TERM": "xterm-256color", "SHELL": "/bin/sh"},
    }  # fmt: skip
    lines = [json.dumps(header), *(json.dumps(event, ensure_ascii=False) for event in recorder.events)]
    target.write_text("\n".join(lines) + "\n", encoding="utf-8")


def main() -> None:
    """Write the recording to the file that is named."""
    parser = argparse.ArgumentParser(prog="python -m c2s_bench.ui.demo", description=__doc__)
    parser.add_argument("file", type=Path, nargs="?", default=Path("docs/demo.cast"))
    target = parser.parse_args().file
    try:
        record(target)
    except TimeoutError as error:
        sys.exit(f"{error}. Nothing was written.")
    print(f"{target}: {target.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main()
