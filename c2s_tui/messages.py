"""What the panes tell the workbench."""

from collections.abc import Sequence

from textual.message import Message

from c2s_engine.structure.edits import Edit


class TextSubmitted(Message):
    """A line was sent from the chat: a turn, or a command where it begins with a slash."""

    def __init__(self, text: str):
        self.text = text
        super().__init__()


class ScrollAsked(Message):
    """The conversation is to be scrolled by pages, below 0 upwards."""

    def __init__(self, by: int):
        self.by = by
        super().__init__()


class Picked(Message):
    """The cursor of a pane came onto a component; the other panes follow."""

    def __init__(self, cid: str, source: str, line: int | None = None):
        self.cid, self.source, self.line = cid, source, line
        super().__init__()


class EditsAsked(Message):
    """Edits of S, made in a pane."""

    def __init__(self, edits: Sequence[Edit]):
        self.edits = tuple(edits)
        super().__init__()


class ReachAsked(Message):
    """A pane wants to know what an edit would make dirty, before it is made."""

    def __init__(self, edit: Edit):
        self.edit = edit
        super().__init__()


class CommandAsked(Message):
    """A command of the app by its name, with what follows it."""

    def __init__(self, name: str, argument: str = ""):
        self.name, self.argument = name, argument
        super().__init__()


class CodeTyped(Message):
    """The program was edited by hand (not yet committed)."""
