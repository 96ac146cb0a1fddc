"""The borders between the columns, moved with the mouse (a mixin of the workbench)."""

from typing import Any

from textual.events import MouseDown, MouseMove, MouseUp

from c2s_tui.layout import LEAST, WIDTHS


class Borders:
    """A press on the border between two columns takes hold of it until the button is let go."""

    _held: int | None = None  # the border after that column

    def on_mouse_down(self: Any, event: MouseDown) -> None:
        if event.button == 1 and (held := self._border_at(event.screen_x, event.screen_y)) is not None:
            self._held = held
            self.capture_mouse()
            event.stop()

    def on_mouse_move(self: Any, event: MouseMove) -> None:
        if self._held is not None:
            self._move_border(self._held, event.screen_x)

    def on_mouse_up(self: Any, event: MouseUp) -> None:
        if self._held is not None:
            self._held = None
            self.release_mouse()
            self.app.remember(widths=self.app.prefs.widths)

    def _border_at(self: Any, x: int, y: int) -> int | None:
        """The border at a place on the screen, one cell to either side counts; None where there is none to move."""
        panes = self.query_one("#panes")
        if self.has_class("-narrow") or panes.has_class("-zoom") or not panes.region.y <= y < panes.region.bottom:
            return None
        columns = [self.query_one(name).region for name in WIDTHS]
        return next((i for i, left in enumerate(columns[:-1]) if x in (left.right - 1, left.right)), None)

    def _move_border(self: Any, held: int, x: int) -> None:
        """Give the columns beside a border the room up to there; the shares of all are their widths in cells."""
        columns = [self.query_one(name).region for name in WIDTHS]
        widths = [column.width for column in columns]
        both = widths[held] + widths[held + 1]
        left = min(max(x - columns[held].x, LEAST), both - LEAST)
        widths[held : held + 2] = [left, both - left]
        self.app.prefs.widths = " ".join(map(str, widths))
        self.lay_columns()
