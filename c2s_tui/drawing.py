"""When the panes are drawn: all at once, or soon and one after the other."""

from typing import Any

DRAW_SECONDS = 0.06
"""Events of a turn come in bursts; the panes are drawn once for those within this time."""
NEXT_SECONDS = 0.02
"""Between one pane and the next: a key typed meanwhile waits for one pane, not for all."""


class Drawing:
    """What of the desk the panes do not show yet. Mixed into the workbench, which has the panes and the desk."""

    DRAWN = ("sheet", "code", "picture", "results")
    _stale: tuple[str, ...] = ()  # to be drawn, the next one first
    _due: Any = None

    def show(self: Any) -> None:
        """Draw the desk everywhere, now."""
        self._stale = ()
        self._show_words()
        for name in self.DRAWN:
            getattr(self, name).show(self.desk)

    def show_soon(self: Any) -> None:
        """Draw the desk in a moment, once for all that comes until then."""
        self._stale += tuple(name for name in self.DRAWN if name not in self._stale)
        if self._due is None:
            self._due = self.set_timer(DRAW_SECONDS, self._show_next)

    def _show_next(self: Any) -> None:
        self._due = None
        if not self._stale:
            return
        name, *rest = self._stale
        self._stale = tuple(rest)
        if name == self.DRAWN[0]:
            self._show_words()
        getattr(self, name).show(self.desk)
        if rest:
            self._due = self.set_timer(NEXT_SECONDS, self._show_next)

    def _show_words(self: Any) -> None:
        self.chat.show(self.desk.structure, self.here)
        self.show_status()
