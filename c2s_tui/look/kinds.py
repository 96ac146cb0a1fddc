"""Letters, colours and marks of the components, read once from look.toml."""

import os
import re
import sys
import tomllib
from functools import cache
from pathlib import Path
from typing import Any

from textual.content import Content

MENTION = re.compile(r"(?<![\w-])(?:O[1-9][0-9]?|[GRET])(?![\w'’-])")
"""A component's id where a sentence mentions it."""


@cache
def look() -> dict[str, Any]:
    """The whole of look.toml."""
    return tomllib.loads((Path(__file__).parent / "look.toml").read_text("utf-8"))


@cache
def ascii_only() -> bool:
    """Whether the terminal draws no more than ASCII (asked for by C2S_ASCII, or the encoding cannot do more)."""
    if os.environ.get("C2S_ASCII"):
        return True
    encoding = getattr(sys.__stdout__, "encoding", None) or "utf-8"
    return os.environ.get("TERM") == "linux" or "utf" not in encoding.lower()


def mark(name: str) -> str:
    """The one-cell mark of that name."""
    return look()["marks"]["ascii" if ascii_only() else "unicode"][name]


def colour(kind: str) -> str:
    """The theme variable of a kind's colour, as a style."""
    return f"$kind-{kind[0].lower()}"


def kind_name(kind: str) -> str:
    """What a kind is called: settings, place, ego, object, restrictions."""
    return look()["kinds"][kind[0]]["name"]


def badge(cid: str) -> Content:
    """A component's id on its colour."""
    return Content.styled(f" {cid:<2} ", f"bold reverse {colour(cid)}")


def state_mark(state: str) -> tuple[str, str]:
    """The mark of a component's state, and its style."""
    return mark(state), f"${look()['states'][state]['colour']}"


def state_word(state: str) -> str:
    return look()["states"][state]["word"]


def mentions(text: str) -> Content:
    """A sentence in which the ids of components carry their colours; nothing in it is markup."""
    content = Content(text)
    for match in MENTION.finditer(text):
        content = content.stylize(f"bold {colour(match[0])}", match.start(), match.end())
    return content
