"""One line of the structure pane as a widget."""

from textual.content import Content
from textual.widgets import Static

from c2s_tui.look.kinds import badge, colour, mark, mentions, state_mark, state_word
from c2s_tui.sheet.rows import ADD, CONFLICT, FIELD, HEAD, HIT, LINK, SENTENCE, UNMET, Row

LABEL = 11
"""Cells of the column of field names."""


class RowView(Static):
    """Draws a Row; the pane moves its cursor over these."""

    def __init__(self, row: Row):
        super().__init__(draw(row), markup=False)
        self.row = row
        self._dress()

    def show(self, row: Row) -> None:
        """Draw another row, or the same with other values."""
        if row != self.row:
            before, self.row = self.row, row
            words, same = draw(row), row.kind == before.kind and _indent(row) == _indent(before)
            room = self.content_size.width
            one_line = all(w.cell_length <= room and "\n" not in w.plain for w in (words, draw(before)))
            self.update(words, layout=not (same and one_line))  # what stays one line moves nothing on the screen
            if not same:
                self._dress()

    def _dress(self) -> None:
        self.set_class(self.row.kind == HEAD, "-head")
        self.styles.padding = (0, 0, 0, _indent(self.row))


def _indent(row: Row) -> int:
    return 0 if row.kind in (HEAD, ADD) or not row.cid else 5 + 2 * row.depth


def draw(row: Row) -> Content:
    """A row as text with styles; nothing in it is read as markup."""
    if row.kind == HEAD:
        sign, style = state_mark(row.state)
        parts: list = [badge(row.cid), " ", (sign, style), " ", (row.text, f"bold {colour(row.cid)}")]
        if row.state != "clean":
            parts.append((f"  {state_word(row.state)}", style))
        if row.reached:
            parts.append((f"  {mark('arrow')} will be rewritten", "$text-warning"))
        return Content.assemble(*parts)
    if row.kind == SENTENCE:
        return mentions(row.text).stylize_before("italic $muted")
    if row.kind == FIELD:
        return _field(row)
    if row.kind == HIT:
        sign, style = ("error", "bold $text-error") if row.state else ("seen", "$muted")
        return Content.styled(f"{mark(sign)} {row.text}", style)
    if row.kind == UNMET:
        return Content.assemble((f"{mark('unmet')} {row.text}", "$text-warning"), (f"  {row.note}", "$muted"))
    if row.kind == CONFLICT:
        return Content.assemble((f"{mark('conflict')} {row.text}", "$text-error"), ("  Enter shows both", "$muted"))
    if row.kind == LINK:
        return Content.assemble((f"{mark('assumed')} {row.text}", "$text"), (f"  {row.note}", "$muted"))
    return Content.assemble(("  + ", f"bold {colour('O')}"), (row.text, "$muted"))


def _field(row: Row) -> Content:
    assert row.field
    label = row.field.label
    if label.isdigit():
        label = f"{row.field.path.split('.')[-2].rstrip('s')} {int(label) + 1}"
    parts: list = [(f"{label.replace('_', ' '):<{LABEL}} ", "$muted")]
    parts.append((row.text, "bold" if row.field.set else "") if row.text else (mark("dash"), "$faint"))
    if row.judged:
        name = "unknown" if row.seen is None else "seen" if row.seen else "unseen"
        style = {"unknown": "$muted", "seen": "$text-success", "unseen": "$text-error"}[name]
        word = {"unknown": "not judged", "seen": "met", "unseen": "not met"}[name]
        same = row.achieved.replace(" ", "") == row.text.replace(" ", "")
        seen = f": {row.achieved}" if row.achieved and not same else ""
        parts.append((f"  {mark(name)} {word}{seen}", style))
    if row.note:
        parts.append((f"  {mark('assumed')} assumed: {row.note}", "$muted"))
    return Content.assemble(*parts)
