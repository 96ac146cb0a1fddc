"""The keys of the focused pane in one row, and as lists for the help."""

from typing import Any

from textual.binding import Binding
from textual.content import Content
from textual.widget import Widget
from textual.widgets import Static

from c2s_tui.commands import commands

ALWAYS = ("help", "results", "picture", "zoom", "quit")
"""Commands whose keys stand in the row wherever one is, with the words below."""
IN_CODE = ("run", "finding", "fix", "find")
"""Commands whose keys stand there, too, while one is in the code."""
SHORT = {"help": "help", "results": "results", "picture": "picture", "zoom": "zoom", "quit": "quit",
         "run": "apply and run", "fix": "apply the fix", "finding": "next finding", "find": "find"}  # fmt: skip


def own(widget: Widget | None, keymap: dict[str, str]) -> list[tuple[str, Binding]]:
    """The bindings of a widget and of the pane around it that have an id and a tooltip, each with its key."""
    found = []
    for node in widget.ancestors_with_self if widget is not None else ():
        kept = [b for b in type(node).__dict__.get("BINDINGS", ()) if getattr(b, "id", None) and b.tooltip]
        found += [(keymap.get(b.id, b.key), b) for b in kept if not b.id.startswith("app.")]
        if getattr(node, "KEYS_END", False):
            break
    return found


def named(keys: str) -> str:
    """The first of some keys as people write it: Ctrl+T, Enter, [."""
    return written(keys.split(",")[0])


def written(keys: str) -> str:
    """Keys as people write them."""
    names = {"left_square_bracket": "[", "right_square_bracket": "]", "question_mark": "?", "plus": "+", "minus": "-",
             "equals_sign": "=", "escape": "Esc"}  # fmt: skip
    each = []
    for key in keys.split(","):
        parts = [names.get(p, p if len(p) == 1 and p == key else p.capitalize()) for p in key.split("+")]
        each.append("+".join(parts))
    return ", ".join(each)


class KeyBar(Static):
    """What can be pressed now; what has no room is in the help."""

    def __init__(self, **options: Any):
        super().__init__("", markup=False, **options)
        self._shown: Content | None = None

    def show(self, widget: Widget | None, keymap: dict[str, str], width: int) -> None:
        words = row(widget, keymap, width)
        if words != self._shown:
            self._shown = words
            self.update(words, layout=False)


def row(widget: Widget | None, keymap: dict[str, str], width: int) -> Content:
    """The focused pane's keys, then those that hold everywhere, as far as there is room."""
    pane = [(named(key), b.description.lower()) for key, b in own(widget, keymap) if b.show and b.description]
    everywhere = [(named(keymap.get(c.id, c.key)), SHORT[c.name]) for c in commands().values() if c.name in ALWAYS]
    here = {getattr(node, "HELP_NAME", "") for node in widget.ancestors_with_self} if widget is not None else set()
    if "code" in here:
        pane += [(named(keymap.get(c.id, c.key)), SHORT[c.name]) for c in commands().values() if c.name in IN_CODE]
    parts: list = []
    room = width - 2
    for key, words in (everywhere[0], *pane, *everywhere[1:], ("Ctrl+P", "all commands")):
        needed = len(key) + len(words) + 3
        if needed > room:
            break
        room -= needed
        parts += [(key, "bold $text-accent"), (f" {words}  ", "$muted")]
    return Content.assemble(*parts)
