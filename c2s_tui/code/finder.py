"""The line below the code in which one types what to find, or the number of a line to go to."""

import re

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding
from textual.containers import Horizontal
from textual.widgets import Input, Static

from c2s_tui.code.area import CodeArea


class Finder(Horizontal):
    """Goes to the next place as one types; Enter to the one after, Up to the one before, Esc back to the code."""

    HELP_NAME = "code"
    BINDINGS = [
        Binding("down", "next(1)", "Next", id="find.next", tooltip="The next place (also Enter)"),
        Binding("up", "next(-1)", "Previous", id="find.previous", tooltip="The place before"),
        Binding("escape", "close", "Back", id="find.close", tooltip="Back to the code"),
    ]

    def compose(self) -> ComposeResult:
        yield Input(placeholder="find a text, or type a line's number", compact=True)
        yield Static("", markup=False)

    @property
    def line(self) -> Input:
        return self.query_one(Input)

    @property
    def _area(self) -> CodeArea:
        return self.screen.query_one(CodeArea)

    def open(self, text: str = "") -> None:
        """Show it, with a text to find; without one, with what is selected in the code."""
        self.add_class("-on")
        self.app.stylesheet.update(self)  # what is still hidden cannot take the focus
        self.line.value = text or self._area.selected_text.split("\n")[0]
        self.screen.set_focus(self.line)
        self.line.action_end()

    @on(Input.Changed)
    def _typed(self, event: Input.Changed) -> None:
        event.stop()
        self._go(0)

    @on(Input.Submitted)
    def _entered(self, event: Input.Submitted) -> None:
        event.stop()
        if self.line.value.strip().isdigit():
            self.action_close()
        else:
            self._go(1)

    def action_next(self, by: int) -> None:
        self._go(by)

    def action_close(self) -> None:
        self.remove_class("-on")
        self._area.focus()

    def _go(self, by: int) -> None:
        """To the place at the cursor or after it (0), the next (1), the one before (-1); round at the ends."""
        wanted, area = self.line.value, self._area
        if wanted.strip().isdigit():
            row = max(0, min(int(wanted), area.document.line_count) - 1)
            area.move_cursor((row, 0), center=True)
            self._say(f"line {row + 1} of {area.document.line_count}")
            return
        places = found(area.text, wanted)
        if not places:
            self._say("not found" if wanted else "")
            return
        here = area.selection.start if by else min(area.selection.start, area.selection.end)
        after = [i for i, p in enumerate(places) if (p > here if by > 0 else p >= here)]
        index = after[0] if after else 0
        if by < 0:
            index = (next((i for i, p in enumerate(places) if p >= here), len(places)) - 1) % len(places)
        row, column = places[index]
        area.move_cursor((row, column))
        area.move_cursor((row, column + len(wanted)), select=True)
        area.scroll_to(y=max(0, row - area.size.height // 2), animate=False)
        self._say(f"{index + 1} of {len(places)}")

    def _say(self, words: str) -> None:
        self.query_one(Static).update(words)


def found(text: str, wanted: str) -> list[tuple[int, int]]:
    """(row, column) of each place of a text; capitals count only where the wanted text has some."""
    if not wanted:
        return []
    flags = 0 if wanted != wanted.lower() else re.IGNORECASE
    pattern = re.compile(re.escape(wanted), flags)
    return [(row, m.start()) for row, line in enumerate(text.split("\n")) for m in pattern.finditer(line)]
