"""Descriptions that are taken from a passage: `[UN R157, Annex 5, 4.4] Ego drives ...` says what it rests on.

The bracket is kept in S's text, hidden from interpreters, and becomes a link of each component.
"""

import re
from collections.abc import Sequence
from typing import Any

from c2s_engine.structure.components import Link, Structure
from c2s_engine.structure.progress import Passage

_CITED = re.compile(r"\s*\[(?P<source>[^\]\n]{3,160})\]\s*")
_USE = re.compile(
    r"(?:please )?(?:use|take|pick|try)(?: (?:number|no\.?|result|passage|the))? ?(?P<which>\d{1,2}|first|second|third)"
    r"(?: one)?[.!]?",
    re.I,
)
_ORDINALS = {"first": 1, "second": 2, "third": 3}
_SCENARIO = re.compile(r"^Scenario:\s*(?P<said>.+)$", re.M)
_ASIDE = re.compile(r"^In other words:.*$", re.M)


def wanted(text: str) -> int | None:
    """Which result a turn such as "use 2" picks (from 1); None where it is no such turn."""
    match = _USE.fullmatch(" ".join(text.split()))
    if not match:
        return None
    return _ORDINALS.get(match["which"].lower()) or int(match["which"])


def description_of(passage: Passage, siblings: Sequence[Passage] = ()) -> str:
    """The scenario of a passage, or of another chunk of its section, with its source; where none is told, its text."""
    same = [passage, *(s for s in siblings if s.title == passage.title)]
    told = next((m["said"] for p in same if (m := _SCENARIO.search(p.text))), "")
    said = told or _ASIDE.sub("", passage.text)
    return f"[{source_of(passage)}] {' '.join(said.split())}"


def tells_scenario(passage: Passage) -> bool:
    """Whether the passage tells a scenario that can be taken as it is."""
    return passage.kind == "doc" and bool(_SCENARIO.search(passage.text))


def source_of(passage: Passage) -> str:
    """The document and clause of a passage, in short: "UN R157, Annex 5, 4.4"."""
    document = passage.title.split(" › ")[0].split(":")[0].replace("UN Regulation No. ", "UN R")
    section = passage.title.split(" › ")[-1].split(" (")[0]
    return f"{document}, {passage.clause or section}".replace("[", "(").replace("]", ")")


def uncited(text: str) -> tuple[str, str]:
    """A description with its bracket blanked out (offsets stay), and the source that it named."""
    match = _CITED.match(text)
    if not match or not text[match.end() :].strip():
        return text, ""
    return " " * match.end() + text[match.end() :], match["source"]


def resting_on(structure: Structure, source: str, text: str) -> Structure:
    """The structure of a text that was taken from a source, each component linked to it."""
    structure = structure.model_copy(update={"text": text})
    for component in structure.components if source else ():
        link = Link(kind="clause", label=source)
        structure = structure.with_component(component.model_copy(update={"links": (*component.links, link)}))
    return structure


def kept(passages: Sequence[Passage]) -> list[dict[str, Any]]:
    """Passages as a session keeps them."""
    return [p.model_dump(mode="json", exclude={"type", "ranks"}) for p in passages]
