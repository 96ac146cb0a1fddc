"""Rows that are folded away in the code: they are not drawn, the cursor steps over them, and any edit unfolds them."""

from collections.abc import Iterable, Sequence

from textual.document._document import EditResult, Location
from textual.document._document_navigator import DocumentNavigator
from textual.document._edit import Edit
from textual.geometry import Size

from c2s_tui.code.document import UnwrappedText
from c2s_tui.in_order import OrderedArea


class FoldedNavigator(DocumentNavigator):
    """Up and down go over rows that are folded away."""

    _wrapped_document: UnwrappedText

    def get_location_above(self, location: Location) -> Location:
        row, column = super().get_location_above(location)
        return self._shown(range(row, -1, -1), column, location)

    def get_location_below(self, location: Location) -> Location:
        row, column = super().get_location_below(location)
        return self._shown(range(row, self._document.line_count), column, location)

    def _shown(self, rows: Iterable[int], column: int, here: Location) -> Location:
        row = next((r for r in rows if r not in self._wrapped_document.hidden), None)
        return here if row is None else (row, min(column, len(self._document.get_line(row))))


class Folding(OrderedArea):
    """A text area that can fold rows."""

    wrapped_document: UnwrappedText

    @property
    def hidden(self) -> frozenset[int]:
        """The rows (from 0) that are folded away."""
        return getattr(self.wrapped_document, "hidden", frozenset())  # Textual makes a plain one first

    @property
    def shown(self) -> list[int] | None:
        """The rows that are drawn, in their order; None where all are."""
        return [row for row, _ in self.wrapped_document._offset_to_line_info] if self.hidden else None

    def fold(self, rows: Iterable[int]) -> None:
        """Fold these rows away, and no others."""
        hidden = frozenset(rows)
        if hidden == self.hidden:
            return
        self.wrapped_document.hide(hidden)
        self._line_cache.clear()
        self._refresh_size()
        self.refresh()

    def _rewrap_and_refresh_virtual_size(self) -> None:
        hidden = self.hidden
        super()._rewrap_and_refresh_virtual_size()
        self.fold(hidden)

    def _refresh_size(self) -> None:
        super()._refresh_size()
        if self.hidden:
            self.virtual_size = Size(self.virtual_size.width, self.wrapped_document.height)

    def edit(self, edit: Edit) -> EditResult:
        self.fold(())
        return super().edit(edit)

    def _undo_batch(self, edits: Sequence[Edit]) -> None:
        self.fold(())
        super()._undo_batch(edits)

    def _redo_batch(self, edits: Sequence[Edit]) -> None:
        self.fold(())
        super()._redo_batch(edits)

    def refresh_lines(self, y_start: int, line_count: int = 1) -> None:
        if self.hidden:  # rows of the text are not rows of the screen
            self._line_cache.clear()
            self.refresh()
        else:
            super().refresh_lines(y_start, line_count)
