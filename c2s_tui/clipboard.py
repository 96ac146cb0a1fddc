"""Copying that reaches the terminal on the user's side of SSH, through tmux and screen."""

import base64
import os
import subprocess
from collections.abc import Callable, Mapping

TMUX_SECONDS = 2.0


def copy(text: str, write: Callable[[str], None], environment: Mapping[str, str] | None = None) -> None:
    """Put a text on the clipboard: by tmux itself where it runs, since as it is set up by default it lets no program's
    sequence through; else by the sequence.
    """
    env = os.environ if environment is None else environment
    if not (env.get("TMUX") and _by_tmux(text)):
        write(osc52(text, env))


def osc52(text: str, environment: Mapping[str, str] | None = None) -> str:
    """The sequence that puts a text on the clipboard, wrapped for the multiplexer that is in between."""
    env = os.environ if environment is None else environment
    data = base64.b64encode(text.encode()).decode()
    sequence = f"\x1b]52;c;{data}\x07"
    if env.get("TMUX"):
        return "\x1bPtmux;" + sequence.replace("\x1b", "\x1b\x1b") + "\x1b\\" + sequence
    if env.get("TERM", "").startswith("screen"):
        pieces = [sequence[i : i + 240] for i in range(0, len(sequence), 240)]
        return "".join(f"\x1bP{piece}\x1b\\" for piece in pieces)
    return sequence


def _by_tmux(text: str) -> bool:
    """Give the text to tmux's own buffer and to the terminals attached to it (tmux 3.2 and later)."""
    try:
        done = subprocess.run(
            ["tmux", "load-buffer", "-w", "-"], input=text.encode(), capture_output=True, timeout=TMUX_SECONDS
        )
    except (OSError, subprocess.TimeoutExpired):
        return False
    return done.returncode == 0
