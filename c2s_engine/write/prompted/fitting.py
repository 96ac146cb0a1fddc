"""Retrieved code in the names of the code so far: what is not defined there is renamed, or the passage left out."""

import re
from collections.abc import Iterable
from functools import cache

from c2s_engine import paths
from c2s_engine.structure import names
from c2s_engine.structure.progress import Passage

_EGO_SPOTS = ("egoSpot", "start")
"""What the collection and the examples call the point that ego starts at: the only point of the code so far is it."""
_POINT = re.compile(r"^(\w+)\s*=\s*new OrientedPoint\b", re.M)


@cache
def shared() -> frozenset[str]:
    """The names that fragments of the collection define for those after them."""
    return frozenset(n for code in _collection() for n in (*names.defines(code), *_several(code)))


@cache
def _collection() -> tuple[str, ...]:
    return tuple(f.read_text(encoding="utf-8") for f in paths.shipped("snippets").glob("*/*.scenic"))


def fitted(found: Iterable[Passage], before: str) -> list[Passage]:
    """The passages whose names the code so far defines, after a certain renaming; the others are left out."""
    there = frozenset(names.defines(before)) | frozenset(_several(before))
    spots = _POINT.findall(before)
    return [p for p in (_fitted(passage, there, spots) for passage in found) if p]


def _fitted(passage: Passage, there: frozenset[str], spots: list[str]) -> Passage | None:
    text = passage.text
    own = names.defines(text).keys() | _several(text) | _inner(text)
    for name in sorted((names.uses(text) & shared()) - own - there):
        meant = _meant(name, there) or (spots[0] if len(spots) == 1 and name in _EGO_SPOTS else None)
        if meant is None:
            return None
        text = re.sub(rf"(?<![\w.'\"]){name}\b(?!\s*=[^=])", meant, text)
    return passage.model_copy(update={"text": text})


def _several(code: str) -> set[str]:
    """The names of assignments to several of them."""
    rows = re.findall(r"^(\w+(?:\s*,\s*\w+)+)\s*=(?!=)", code, re.M)
    return {name for row in rows for name in re.findall(r"\w+", row)}


def _inner(code: str) -> set[str]:
    """The names that are a fragment's own further in: parameters, keywords, variables of behaviours, lambdas, loops."""
    rows = re.findall(r"^(?:behavior|monitor|def)\s+\w+\(([^)]*)\)", code, re.M)
    rows += re.findall(r"\blambda\s+([\w\s,]+):", code) + re.findall(r"\bfor\s+([\w\s,]+?)\s+in\b", code)
    return {n for row in rows for n in re.findall(r"\w+", row)} | set(re.findall(r"(?<![.\w])(\w+)\s*=(?!=)", code))


def _meant(name: str, there: frozenset[str]) -> str | None:
    """The one name of the code so far that means the same of ego: `section` for `egoSection`."""
    near = [n for n in there if _of_ego(n) == _of_ego(name)]
    return near[0] if len(near) == 1 else None


def _of_ego(name: str) -> str:
    return name.lower().removeprefix("ego").strip("_") or "ego"
