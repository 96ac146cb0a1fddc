"""When the panes are drawn: all at once, or soon and one after the other."""

from typing import TYPE_CHECKING

from c2s_tui.part import Part

if TYPE_CHECKING:
    from textual.timer import Timer

    from c2s_tui.workbench import Workbench

DRAW_SECONDS = 0.06
"""Events of a turn come in bursts; the panes are drawn once for those within this time."""
NEXT_SECONDS = 0.02
"""Between one pane and the next: a key typed meanwhile waits for one pane, not for all."""


class Drawing(Part):
    """What of the desk the panes do not show yet."""

    DRAWN = ("sheet", "code", "picture", "results")

    def __init__(self, bench: "Workbench"):
        super().__init__(bench)
        self._stale: tuple[str, ...] = ()  # to be drawn, the next one first
        self.due: Timer | None = None

    def all_now(self) -> None:
        """Draw the desk everywhere."""
        self._stale = ()
        self._words()
        for name in self.DRAWN:
            self._draw(name)

    def soon(self) -> None:
        """Draw the desk in a moment, once for all that comes until then."""
        self._stale += tuple(name for name in self.DRAWN if name not in self._stale)
        if self.due is None:
            self.due = self.bench.set_timer(DRAW_SECONDS, self._next)

    def _next(self) -> None:
        self.due = None
        if not self._stale:
            return
        name, *rest = self._stale
        self._stale = tuple(rest)
        if name == self.DRAWN[0]:
            self._words()
        self._draw(name)
        if rest:
            self.due = self.bench.set_timer(NEXT_SECONDS, self._next)

    def _draw(self, name: str) -> None:
        getattr(self.bench, name).show(self.desk)

    def _words(self) -> None:
        self.chat.show(self.desk.structure, self.desk.idle, self.bench.here)
        self.bench.show_status()
