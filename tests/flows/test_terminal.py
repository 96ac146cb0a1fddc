"""The app in a real terminal (tmux), on the real engine: resize, detach, attach, kill -9 and resume, a dropped line."""

import os
import shutil
import signal
import subprocess
import sys
import time
import uuid
from collections.abc import Iterator
from pathlib import Path

import pytest

pytestmark = [pytest.mark.full, pytest.mark.skipif(shutil.which("tmux") is None, reason="tmux is not installed")]

TEXT = "Ego drives at 50 km/h in the right lane of a road with two lanes. A van in the left lane cuts in 15 m ahead."
PATIENCE = 120.0
"""Seconds until a screen must show what is waited for; a busy machine is slow."""


class Terminal:
    """One tmux server with the app in it."""

    def __init__(self, home: Path):
        self.home, self.name = home, f"c2s-{uuid.uuid4().hex[:8]}"
        self.environment = {
            **os.environ, "XDG_CACHE_HOME": str(home / "cache"), "XDG_DATA_HOME": str(home / "data"),
            "XDG_CONFIG_HOME": str(home / "config"), "LC_ALL": "C.UTF-8",
        }  # fmt: skip
        for name in ("TMUX", "NO_COLOR", "C2S_ASCII", "COLUMNS", "LINES"):
            self.environment.pop(name, None)

    def tmux(self, *arguments: str) -> str:
        done = subprocess.run(
            ["tmux", "-L", self.name, "-f", "/dev/null", *arguments],
            capture_output=True,
            text=True,
            env=self.environment,
        )
        return done.stdout

    def start(self, *arguments: str, size: tuple[int, int] = (140, 45), before: str = "") -> None:
        """Run `c2s app` in a new tmux session; its exit status is shown when it ends. `before`: its environment."""
        command = f"{before} {sys.executable} -m c2s_tui.entry app {' '.join(arguments)}; echo exit-$?; exec cat"
        self.tmux("new-session", "-d", "-s", "a", "-x", str(size[0]), "-y", str(size[1]), command)
        self.tmux("set-option", "-g", "exit-empty", "off")  # else a server that is just leaving may be asked next

    @property
    def screen(self) -> str:
        return self.tmux("capture-pane", "-p", "-t", "a")

    def shows(self, text: str) -> str:
        """Wait until the screen shows a text; the screen."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            screen = self.screen
            if text in screen:
                return screen
            time.sleep(0.1)
        raise AssertionError(f"{text!r} was never shown:\n{self.screen}")

    def keys(self, *keys: str) -> None:
        self.tmux("send-keys", "-t", "a", *keys)

    def type(self, text: str) -> None:
        self.tmux("send-keys", "-t", "a", "-l", text)

    def app_pid(self) -> int:
        """The process of the app in the pane."""
        shell = self.tmux("display-message", "-p", "-t", "a", "#{pane_pid}").strip()
        children = subprocess.run(["pgrep", "-P", shell], capture_output=True, text=True).stdout.split()
        return int(children[0])

    def close(self) -> None:
        self.tmux("kill-server")


@pytest.fixture
def terminal(tmp_path: Path) -> Iterator[Terminal]:
    found = Terminal(tmp_path)
    yield found
    found.close()


def draft(terminal: Terminal, name: str) -> str:
    """What lies in the draft files of the only session."""
    files = list((terminal.home / "data").rglob("drafts/*"))
    return "\n".join(f.read_text() for f in files if f.name == f"{name}.swap")


def test_describe_change_and_save_a_program_that_compiles(terminal):
    terminal.start("work")
    terminal.shows("reader")
    terminal.shows(" work ")
    terminal.type(TEXT)
    terminal.keys("Enter")
    screen = terminal.shows("requirements met")
    assert "✓run" in screen and "cut in" in screen
    terminal.tmux("resize-window", "-t", "a", "-x", "80", "-y", "24")
    terminal.shows("F3 S")
    terminal.keys("F3")
    terminal.shows("ego")
    terminal.tmux("resize-window", "-t", "a", "-x", "140", "-y", "45")
    terminal.shows("─ code ")
    terminal.keys("F2")
    terminal.type(f"/save {terminal.home / 'cut.scenic'}")
    terminal.keys("Enter")
    terminal.shows("Saved")
    program = terminal.home / "cut.scenic"
    assert "## O1:" in program.read_text() and (terminal.home / "town.xodr").is_file()
    code = "import sys; sys.path.insert(0, sys.argv[2]); import scenic; " \
           "scenic.scenarioFromFile(sys.argv[1], mode2D=True); print('compiled')"  # fmt: skip
    from c2s_engine.paths import shipped

    done = subprocess.run(
        [sys.executable, "-c", code, str(program), str(shipped("standins"))],
        capture_output=True, text=True, env=terminal.environment,
    )  # fmt: skip
    assert "compiled" in done.stdout, done.stderr[-800:]
    terminal.keys("C-q")
    terminal.shows("exit-0")


def test_kill_nine_loses_no_turn_and_at_most_a_second_of_typing(terminal):
    terminal.start("work")
    terminal.shows(" work ")
    terminal.type(TEXT)
    terminal.keys("Enter")
    terminal.shows("requirements met")
    terminal.type("and then it half")
    end = time.monotonic() + PATIENCE
    while "and then it half" not in draft(terminal, "chat") and time.monotonic() < end:
        time.sleep(0.1)
    os.kill(terminal.app_pid(), signal.SIGKILL)
    terminal.shows("exit-137")
    terminal.tmux("kill-session", "-t", "a")
    terminal.start("work")
    screen = terminal.shows("and then it half")
    assert "cuts in" in screen
    terminal.shows("met")
    terminal.shows("van = new Van at place.left_lane")  # the pane begins at ego: its first lines may be above it


def test_detach_and_attach_and_a_dropped_line_saves(terminal):
    terminal.start("work")
    terminal.shows(" work ")
    terminal.type("a thought that is not sent")
    terminal.shows("not sent")
    other = subprocess.Popen(
        ["script", "-qfc", f"tmux -L {terminal.name} attach -t a", "/dev/null"],
        stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, env={**terminal.environment, "TERM": "xterm-256color"},
    )  # fmt: skip
    end = time.monotonic() + PATIENCE
    while not terminal.tmux("list-clients").strip() and time.monotonic() < end:
        time.sleep(0.1)
    terminal.tmux("detach-client", "-s", "a")
    other.wait(timeout=30)
    terminal.shows("not sent")
    terminal.tmux("kill-session", "-t", "a")  # SIGHUP
    end = time.monotonic() + PATIENCE
    while "not sent" not in draft(terminal, "chat") and time.monotonic() < end:
        time.sleep(0.1)
    terminal.start("work", size=(80, 24))
    terminal.shows("not sent")


def test_a_line_that_drops_without_a_signal_ends_the_app_too(terminal):
    terminal.start("work", before="trap '' HUP; setsid -w")  # no terminal of its own: nobody tells it
    terminal.shows("reader")
    terminal.shows(" work ")
    pid = int(
        subprocess.run(["pgrep", "-f", "c2s_tui.entry app work"], capture_output=True, text=True).stdout.split()[-1]
    )
    terminal.type("typed and not sent")
    terminal.shows("typed and not sent")
    terminal.tmux("kill-server")
    end = time.monotonic() + 30
    while os.path.exists(f"/proc/{pid}") and time.monotonic() < end:
        time.sleep(0.1)
    assert not os.path.exists(f"/proc/{pid}")
    assert "typed and not sent" in draft(terminal, "chat")


def test_an_editor_outside_copying_and_few_colours(terminal):
    editor = terminal.home / "editor"
    editor.write_text('#!/bin/sh\nsed -i "s/^EGO_SPEED.*/& # from outside/" "$1"\nread pressed\n')
    editor.chmod(0o755)
    terminal.start(before=f"env TERM=screen COLORTERM= EDITOR={editor}")  # the first run: the example
    terminal.type("zq")  # while it starts
    terminal.shows("This is an example")
    terminal.shows(" zq")
    coloured = terminal.tmux("capture-pane", "-e", "-p", "-t", "a")
    assert "\x1b[38;2;" not in coloured and "\x1b[34m" in coloured  # the terminal's own colours, not those nearest
    terminal.keys("BSpace", "BSpace")
    terminal.type("/copy O1")
    terminal.keys("Enter")
    terminal.shows("clipboard")
    assert terminal.tmux("show-buffer").startswith("## O1:")
    terminal.type("/editor")
    terminal.keys("Enter")
    end = time.monotonic() + PATIENCE
    while "This is an example" in terminal.screen and time.monotonic() < end:
        time.sleep(0.1)
    terminal.keys("Enter")
    terminal.shows("# from outside")
    terminal.shows("by hand")
    end = time.monotonic() + PATIENCE
    while "Esc cancels" in terminal.screen and time.monotonic() < end:
        time.sleep(0.1)
    terminal.keys("C-q")
    terminal.shows("exit-0")
