"""The run as a line of time: where one is, where something happens; a click or a drag goes there."""

from collections.abc import Sequence

from textual.content import Content
from textual.events import MouseDown, MouseMove, MouseUp
from textual.message import Message
from textual.widgets import Static

from c2s_tui.look.kinds import ascii_only


class TimeBar(Static):
    """Posts `Asked` with the share of the run that was pointed at."""

    class Asked(Message):
        """Go to that share of the run (0 to 1)."""

        def __init__(self, share: float):
            self.share = share
            super().__init__()

    def show(self, share: float, moments: Sequence[float], hits: Sequence[float]) -> None:
        """Draw it: where one is, events and contacts, all as shares of the run."""
        self.update(line(share, moments, hits, self.size.width), layout=False)

    def on_mouse_down(self, event: MouseDown) -> None:
        self.capture_mouse()
        self._ask(event.x)

    def on_mouse_move(self, event: MouseMove) -> None:
        if self.app.mouse_captured is self:
            self._ask(event.x)

    def on_mouse_up(self, event: MouseUp) -> None:
        self.release_mouse()

    def _ask(self, x: int) -> None:
        self.post_message(self.Asked(min(1.0, max(0.0, x / max(1, self.size.width - 1)))))


def line(share: float, moments: Sequence[float], hits: Sequence[float], width: int) -> Content:
    """The line as text."""
    if width < 2:
        return Content("")
    rail, dot, hit, here = ("-", "+", "X", "#") if ascii_only() else ("─", "•", "✸", "█")
    cells = [(rail, "$faint")] * width
    for marks, sign, style in ((moments, dot, "$text-accent"), (hits, hit, "bold $text-error")):
        for moment in marks:
            cells[min(width - 1, round(moment * (width - 1)))] = (sign, style)
    cells[min(width - 1, round(share * (width - 1)))] = (here, "$primary")
    return Content.assemble(*cells)
