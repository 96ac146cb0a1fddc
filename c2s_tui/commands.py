"""The commands of the app, read from commands.toml: slash commands, palette and keys are made from it."""

import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from textual.binding import Binding

AT_ONCE = ("quit", "chat", "sheet", "code", "results", "picture", "find")
"""Their keys are acted on before the keys that follow: what is typed next is meant for the pane that they go to."""


@dataclass(frozen=True)
class Command:
    name: str
    about: str
    argument: str = ""
    key: str = ""

    @property
    def id(self) -> str:
        return f"app.{self.name}"


@cache
def commands() -> dict[str, Command]:
    """All of them by name, in the order of the file."""
    data = tomllib.loads((Path(__file__).parent / "commands.toml").read_text("utf-8"))
    return {name: Command(name, **entry) for name, entry in data.items()}


def bindings() -> list[Binding]:
    """The keys of the commands, each with an id by which it can be remapped."""
    return [
        Binding(c.key, f"command('{c.name}')", c.name, show=False, id=c.id, tooltip=c.about, priority=c.name in AT_ONCE)
        for c in commands().values()
        if c.key
    ]


@cache
def function_keys() -> frozenset[str]:
    """The function keys of the commands, F1 to F10."""
    keys = (k for c in commands().values() for k in c.key.split(","))
    return frozenset(k for k in keys if k.startswith("f") and k[1:].isdigit())


def completions(typed: str) -> list[str]:
    """The commands that begin with what is typed (which begins with a slash)."""
    return [f"/{name}" for name in commands() if f"/{name}".startswith(typed)]


def split(text: str) -> tuple[str, str] | None:
    """A slash command and what follows it; None where the text is none. An unambiguous beginning will do."""
    if not text.startswith("/"):
        return None
    word, _, rest = text[1:].partition(" ")
    found = [n for n in commands() if n == word] or [n for n in commands() if word and n.startswith(word)]
    return (found[0] if len(found) == 1 else word), rest.strip()
