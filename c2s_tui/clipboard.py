"""Copying that reaches the terminal on the user's side of SSH, through tmux and screen."""

import base64
import os
from collections.abc import Mapping

LIMIT = 74_000
"""Bytes of text above which terminals are known to drop the sequence."""


def osc52(text: str, environment: Mapping[str, str] | None = None) -> str:
    """The sequence that puts a text on the clipboard, wrapped for the multiplexer that is in between."""
    env = os.environ if environment is None else environment
    data = base64.b64encode(text.encode()).decode()
    sequence = f"\x1b]52;c;{data}\x07"
    if env.get("TMUX"):
        return "\x1bPtmux;" + sequence.replace("\x1b", "\x1b\x1b") + "\x1b\\"
    if env.get("TERM", "").startswith("screen"):
        pieces = [sequence[i : i + 240] for i in range(0, len(sequence), 240)]
        return "".join(f"\x1bP{piece}\x1b\\" for piece in pieces)
    return sequence
