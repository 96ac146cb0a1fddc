"""Which passages that a model was shown can be seen in what it wrote: only those are named as a fragment's sources."""

import re
from collections.abc import Iterable

from c2s_engine.structure.components import Component, Link
from c2s_engine.structure.progress import Passage

SHORT = 12
"""Characters of a line below which it says nothing about where it comes from."""
_NAME = re.compile(r"\b(?:[A-Z][a-z0-9]+(?:[A-Z][a-z0-9]*)+|[a-z]+(?:[A-Z][a-z0-9]+)+)\b")


def sources(passages: Iterable[Passage], code: str) -> tuple[Link, ...]:
    """A link for each passage that shows in the code, with its clause."""
    shown = [p for p in passages if shows(p, code)]
    return tuple(Link(kind="snippet" if p.kind == "snippet" else "chunk", label=label(p)) for p in shown)


def label(passage: Passage) -> str:
    """How a passage is named as a source: its title, with the clause where that does not stand in it."""
    return f"{passage.title} ({passage.clause})" if passage.clause not in passage.title else passage.title


def shows(passage: Passage, code: str) -> bool:
    """Whether a snippet has a line in common with the code, but for its numbers; or a text an API name."""
    if passage.kind == "snippet":
        return bool(_lines(passage.text) & _lines(code))
    return bool(set(_NAME.findall(passage.text)) & set(_NAME.findall(code)))


def rests_on(component: Component, found: Iterable[Link]) -> tuple[Link, ...]:
    """The component's links with these as its only retrieved sources."""
    own = tuple(link for link in component.links if link.kind not in ("snippet", "chunk"))
    return (*own, *dict.fromkeys(found))


def _lines(code: str) -> set[str]:
    plain = (re.sub(r"\d+(?:\.\d+)?", "0", re.sub(r"#.*", "", line)).strip(" ,") for line in code.splitlines())
    return {line for line in plain if len(line) >= SHORT}
