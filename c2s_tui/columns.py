"""The columns of the workbench: the share of each, and the borders between them, which the mouse moves."""

from typing import TYPE_CHECKING, cast

from textual.containers import Horizontal
from textual.events import MouseDown, MouseMove, MouseUp

if TYPE_CHECKING:
    from c2s_tui.app import C2SApp

WIDTHS = {"#chat": 36, "#sheet": 46, "#right": 58}
"""Shares of the columns to begin with."""
STEP, LEAST, MOST = 6, 12, 500


class Columns(Horizontal):
    """A press on the border between two columns takes hold of it until the button is let go."""

    _held: int | None = None  # the border after that column

    @property
    def prefs_app(self) -> "C2SApp":
        return cast("C2SApp", self.app)

    @property
    def shares(self) -> dict[str, int]:
        """The share of each column, as the user left it."""
        kept = self.prefs_app.prefs.widths.split()
        if len(kept) == len(WIDTHS) and all(w.isdigit() and LEAST <= int(w) <= MOST for w in kept):
            return dict(zip(WIDTHS, map(int, kept), strict=True))
        return dict(WIDTHS)

    def lay(self) -> None:
        """Give each column its share."""
        for column, share in self.shares.items():
            self.query_one(column).styles.width = f"{share}fr"

    def widen(self, column: str, by: int) -> None:
        """Give a column more room, or less; the others share the rest. Kept for the next start."""
        shares = self.shares
        shares[column] = min(MOST, max(LEAST, shares[column] + by))
        self.prefs_app.remember(widths=" ".join(str(w) for w in shares.values()))
        self.lay()

    def on_mouse_down(self, event: MouseDown) -> None:
        if event.button == 1 and (held := self._border_at(event.screen_x, event.screen_y)) is not None:
            self._held = held
            self.capture_mouse()
            event.stop()

    def on_mouse_move(self, event: MouseMove) -> None:
        if self._held is not None:
            self._move_border(self._held, event.screen_x)

    def on_mouse_up(self, event: MouseUp) -> None:
        if self._held is not None:
            self._held = None
            self.release_mouse()
            self.prefs_app.remember(widths=self.prefs_app.prefs.widths)

    def _border_at(self, x: int, y: int) -> int | None:
        """The border at a place on the screen, one cell to either side counts; None where there is none to move."""
        if self.screen.has_class("-narrow") or self.has_class("-zoom") or not self.region.y <= y < self.region.bottom:
            return None
        columns = [self.query_one(name).region for name in WIDTHS]
        return next((i for i, left in enumerate(columns[:-1]) if x in (left.right - 1, left.right)), None)

    def _move_border(self, held: int, x: int) -> None:
        """Give the columns beside a border the room up to there; the shares of all are their widths in cells."""
        columns = [self.query_one(name).region for name in WIDTHS]
        widths = [column.width for column in columns]
        both = widths[held] + widths[held + 1]
        left = min(max(x - columns[held].x, LEAST), both - LEAST)
        widths[held : held + 2] = [left, both - left]
        self.prefs_app.prefs.widths = " ".join(map(str, widths))
        self.lay()
