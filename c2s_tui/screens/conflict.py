"""Code by hand beside what would be written now; the user says which stands."""

from textual.app import ComposeResult
from textual.binding import Binding
from textual.containers import Horizontal, Vertical, VerticalScroll
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Static

from c2s_tui.code.fragments import changed_lines


class Conflict(ModalScreen[str | None]):
    """Dismisses with `mine`, `theirs`, or None."""

    BINDINGS = [
        Binding("escape", "take('')", "Later", show=False),
        Binding("m", "take('mine')", "Mine", show=False),
        Binding("t", "take('theirs')", "Theirs", show=False),
        Binding("down,j", "scroll(1)", show=False), Binding("up,k", "scroll(-1)", show=False),
    ]  # fmt: skip

    def __init__(self, cid: str, mine: str, theirs: str):
        super().__init__()
        self.cid, self.mine, self.theirs = cid, mine, theirs

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog -wide"):
            yield Static(
                f"{self.cid} was written by hand, and its fields have changed since", classes="title", markup=False
            )
            with Horizontal(id="conflict-sides"):
                sides = ("your code (m keeps it)", self.mine), ("from the fields (t takes it)", self.theirs)
                for title, text in sides:
                    side = VerticalScroll(Static(_marked(text, self.theirs if text is self.mine else self.mine)))
                    side.border_title = title
                    yield side
            yield Static(
                "m keeps your code, t takes the new code, Esc decides later", classes="foot", markup=False
            )

    def action_scroll(self, by: int) -> None:
        for side in self.query(VerticalScroll):
            side.scroll_relative(y=by, animate=False)

    def action_take(self, which: str) -> None:
        self.dismiss(which or None)


def _marked(text: str, other: str) -> Content:
    """A side with the lines marked in which it differs from the other."""
    differs = changed_lines(other, text)
    lines = text.split("\n")
    return Content("\n").join(
        Content.styled(line, "bold $text-warning" if i in differs else "") for i, line in enumerate(lines, 1)
    )
