"""F1: what can be pressed in the focused pane, and what can be typed."""

from textual.content import Content
from textual.widget import Widget

from c2s_tui.commands import commands
from c2s_tui.keys import own, written
from c2s_tui.look.kinds import badge, kind_name, look, mark
from c2s_tui.screens.dialogs import Reading

WIDE = 22


def help_screen(pane: str, widget: Widget | None, keymap: dict[str, str]) -> Reading:
    """The help for a pane: its keys first, then the app's, the commands and the marks."""
    parts: list = []
    for name, bound in (("Here", _own(widget, keymap)), ("Everywhere", _app(keymap))):
        parts += [(f"{name}\n", "bold $text-primary")]
        for keys, about in bound:
            parts += [(f"{keys:<{WIDE}}", "bold"), f" {about}\n"]
        parts.append("\n")
    parts.append(("Typed in the chat\n", "bold $text-primary"))
    for command in commands().values():
        typed = f"/{command.name} {command.argument}".rstrip()
        parts += [(f"{typed:<{WIDE}}", "bold"), f" {command.about}\n"]
    parts += ["\n", ("Marks\n", "bold $text-primary")]
    for kind in look()["kinds"]:
        parts += [badge(kind if kind != "O" else "O1"), f" {kind_name(kind)}   "]
    parts.append("\n")
    for name, words in (
        ("clean", "up to date"), ("dirty", "to be written"), ("writing", "being written"), ("failed", "a check failed"),
        ("by_hand", "written by hand"), ("conflict", "by hand, and its fields changed"),
        ("seen", "required, and the run shows it"), ("unseen", "required, and the run does not show it"),
        ("assumed", "assumed: the text left it open"), ("unmet", "no field can say it, or it was not understood"),
        ("changed", "line changed by the last turn"),
    ):  # fmt: skip
        parts.append(f"{mark(name)}  {words}\n")
    return Reading(f"Help: {pane}", Content.assemble(*parts))


def _own(widget: Widget | None, keymap: dict[str, str]) -> list[tuple[str, str]]:
    return [(written(key), b.tooltip) for key, b in own(widget, keymap)]


def _app(keymap: dict[str, str]) -> list[tuple[str, str]]:
    keys = [(written(keymap.get(c.id, c.key)), c.about) for c in commands().values() if c.key]
    return [*keys, ("Ctrl+P", "Command palette: everything by name"), ("Tab, Shift+Tab", "Next, previous part")]
