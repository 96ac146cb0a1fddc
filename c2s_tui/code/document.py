"""Textual's document classes, quick enough for a key in a program of thousands of lines."""

from rich.cells import cell_len
from textual.document._document import Document, EditResult, Location
from textual.document._wrapped_document import WrappedDocument
from textual.geometry import Offset, Size


class ProgramText(Document):
    """A document that joins its lines once an edit, not once a drawn line, and measures no line twice."""

    def __init__(self, text: str):
        super().__init__(text)
        self._whole: str | None = None
        self._widths: dict[str, int] = {}

    @property
    def text(self) -> str:
        if self._whole is None:
            self._whole = super().text
        return self._whole

    def replace_range(self, start: Location, end: Location, text: str) -> EditResult:
        self._whole = None
        return super().replace_range(start, end, text)

    def get_size(self, tab_width: int) -> Size:
        known, before = {}, self._widths
        for line in self.lines:
            if line not in known:
                width = before.get(line)
                known[line] = cell_len(line.expandtabs(tab_width)) if width is None else width
        self._widths = known
        return Size(max(known.values(), default=0), len(self.lines))


class UnwrappedText(WrappedDocument):
    """A document that is not wrapped: as high as it has lines, without counting them each time it is asked. Rows can be
    hidden."""

    hidden: frozenset[int] = frozenset()

    def hide(self, rows: frozenset[int]) -> None:
        """Hide these rows, and no others; a hidden row is taken to be where the shown one above it is."""
        self.hidden = frozenset()
        self.wrap(self._width)
        if rows:
            self.hidden = rows
            self._offset_to_line_info = [(r, 0) for r, _ in self._offset_to_line_info if r not in rows]
            at = -1
            for row in range(len(self._line_index_to_offsets)):
                at += row not in rows
                self._line_index_to_offsets[row] = [max(0, at)]

    def offset_to_location(self, offset: Offset) -> Location:
        if not self.hidden:
            return super().offset_to_location(offset)
        row = self._offset_to_line_info[min(max(0, offset.y), len(self._offset_to_line_info) - 1)][0]
        return row, self.get_target_document_column(row, max(0, offset.x), 0)

    @property
    def height(self) -> int:
        return len(self._offset_to_line_info)
