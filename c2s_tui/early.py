"""The first paint: drawn with nothing but the standard library, before anything of the app is imported.

While the app is being imported the terminal keeps what is typed (unechoed); Textual reads it once it has started.
"""

import os
import sys
import termios

ENTER, LEAVE = "\x1b[?1049h\x1b[?25l\x1b[2J\x1b[H", "\x1b[?1049l\x1b[?25h"
TITLE = " c2s"
WAIT = " starting; what you type is kept"


class Early:
    """The terminal between the start of the process and the app's own first frame."""

    def __init__(self) -> None:
        self._before: list | None = None

    def paint(self) -> None:
        """Draw the frame, and stop the terminal from echoing."""
        width, height = os.get_terminal_size(1)
        bold, faint, off = ("", "", "") if os.environ.get("NO_COLOR") else ("\x1b[1m", "\x1b[2m", "\x1b[0m")
        frame = f"{ENTER}{bold}{TITLE[:width]}{off}\x1b[{height};1H{faint}{WAIT[: width - 1]}{off}"
        os.write(1, frame.encode())
        try:
            self._before = termios.tcgetattr(0)
            silent = termios.tcgetattr(0)
            silent[3] &= ~(termios.ECHO | termios.ICANON)
            termios.tcsetattr(0, termios.TCSANOW, silent)
        except termios.error:
            self._before = None

    def hand_over(self) -> None:
        """Give the terminal to Textual as it was found; what was typed is still to be read."""
        if self._before is not None:
            termios.tcsetattr(0, termios.TCSANOW, self._before)
            self._before = None

    def leave(self) -> None:
        """Show the shell's screen again, where the app could not start."""
        self.hand_over()
        os.write(1, LEAVE.encode())


def asked(arguments: list[str]) -> tuple[str | None, str | None] | None:
    """(session, file) where the app is asked for in its plainest forms and there is a terminal; else None."""
    if arguments[:1] != ["app"] or not (sys.stdin.isatty() and sys.stdout.isatty()):
        return None
    rest = arguments[1:]
    if not rest:
        return None, None
    if len(rest) == 1 and not rest[0].startswith("-"):
        return rest[0], None
    if len(rest) == 2 and rest[0] in ("-f", "--file"):
        return None, rest[1]
    return None
