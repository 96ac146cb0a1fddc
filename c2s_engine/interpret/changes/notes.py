"""Notes of a hurry spelt out: "lead car 70 not 50", "ego = truck", "dog is useless, del", "a van, no, a pickup".

Names are marked before the patterns of data/language/notes.yaml are tried, so that these tell names from other words.
"""

import re
from collections.abc import Callable, Sequence
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.meant import called
from c2s_engine.interpret.changes.refer import refer
from c2s_engine.interpret.entities import PERSONS
from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.spans import Span
from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import PlaceSpec

New = str | Callable[[re.Match[str]], str]
"""What is read instead of what a pattern finds."""
SPEAKERS = ("i", "we", "me", "us")
"""Words for ego that may mean who types."""
MEETING = ("intersection", "roundabout", "on_ramp", "off_ramp")
"""Places where roads meet."""
MARK = "‹{}{}{}{}›"
"""Its number; p: several, s: one; i: an id, e: ego, t: somebody who is there, n: somebody new; w: a walker."""


def text_of(text: str, structure: Structure) -> str:
    """A whole turn in plain words."""
    return _rewritten(called(scan.normalised(text), structure), "turns", structure)


def demand_of(demand: str, structure: Structure) -> str:
    """A single demand in plain words."""
    demand = _rewritten(called(demand, structure), "demands", structure)
    assert isinstance(structure.place.spec, PlaceSpec)
    kind = structure.place.spec.kind
    section = "junction" if kind == "intersection" else "road" if kind not in MEETING else None
    return _rewritten(demand, section, structure) if section else demand


def _rewritten(plain: str, section: str, structure: Structure) -> str:
    return rewritten(plain, _patterns(section), structure)


def rewritten(plain: str, rows: Sequence[tuple[re.Pattern[str], New]], structure: Structure) -> str:
    """A text in which the patterns have found what they stand for, in their order, names being marked."""
    marked, names = _marked(plain, structure)
    for pattern, new in rows:
        marked = pattern.sub(new, marked)
    for mark, name in names.items():
        marked = marked.replace(mark, name)
    return " ".join(marked.split())


def _marked(plain: str, structure: Structure) -> tuple[str, dict[str, str]]:
    """The text with marks for the names in it, and these by their marks."""
    spans = [s for s in scan.names(plain) if s.kind in ("actor", "ego", "label")]
    spans = [s for s in spans if plain[s.start : s.end] not in SPEAKERS]
    spans += [Span("id", *m.span()) for m in re.finditer(r"\bo[1-9]\b", plain)]
    names: dict[str, str] = {}
    marked, at = "", 0
    for span in sorted(spans, key=lambda s: s.start):
        if span.start < at:
            continue
        name = plain[span.start : span.end]
        there = "t" if refer(f"the {name}", structure, alone=False) else "n"
        sort = {"ego": "e", "id": "i"}.get(span.kind, there)
        walks = "w" if span.data.get("type") in PERSONS else "v"
        mark = MARK.format(len(names), "p" if span.data.get("plural") else "s", sort, walks)
        marked += plain[at : span.start] + mark
        names[mark] = name
        at = span.end
    return marked + plain[at:], names


@cache
def _patterns(section: str) -> list[tuple[re.Pattern[str], str]]:
    return [(compiled(find, {}), new) for find, new in language.table("notes")[section]]


def compiled(pattern: str, more: dict[str, str]) -> re.Pattern[str]:
    """A pattern with its names and words filled in; `more`: words besides those of notes.yaml."""
    table = language.table("notes")
    names = {name: said.replace("{mark", r"‹\d").replace("}", "›") for name, said in table["names"].items()}
    words = {**table["words"], **names, **more}
    return re.compile(language.filled(pattern, words))
