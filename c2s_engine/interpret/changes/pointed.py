"""Who is pointed at by a number ("NPC 2", "car 2") or by a look that the text of the scene tells ("the red one")."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.meant import called_by
from c2s_engine.interpret.changes.refer import objects_of
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Structure


def _table(section: str) -> Any:
    return language.table("turns")[section]


def pointed(plain: str, structure: Structure) -> str:
    """The text in which those are called by their nouns or ids whom a number or a look points at."""
    plain = re.sub(_table("numbered")["of_all"], lambda m: _object(m, structure), plain)
    plain = re.sub(_table("numbered")["of_type"], lambda m: _of_type(m, structure), plain)
    if re.search(_table("articles").replace("$", r"(?!the\b|an?\b)"), plain):
        plain = _with_articles(plain, structure)
    looks = _looks(structure)
    if not looks:
        return plain
    for span in reversed([s for s in scan.names(plain) if s.kind == "actor"]):
        there = {c.id for c in objects_of(structure, span.data["type"])}
        plain = _called(plain, span.start, span.end, there, looks, structure)
    for one in reversed(list(re.finditer(_table("looks")["ones"], plain))):
        there = {c.id for c in structure.objects}
        plain = _called(plain, one.start(), one.end(), there, looks, structure)
    return plain


def _with_articles(plain: str, structure: Structure) -> str:
    """The text with the articles that it leaves out before those who are there, amid a sentence: "when car brakes"."""
    before = _table("articles")
    for span in reversed([s for s in scan.names(plain) if s.kind == "actor" and not s.data.get("plural")]):
        if re.search(before, plain[: span.start]):
            plain = f"{plain[: span.start]}the {plain[span.start :]}"
    return plain


def _object(match: re.Match[str], structure: Structure) -> str:
    """The id of who has the number, where there is such a one."""
    return f"o{match['n']}" if f"O{match['n']}" in structure else match[0]


def missing(plain: str, structure: Structure) -> str:
    """The number of somebody, by the sheet or the program, whom there is not; empty where all are there."""
    ids = (f"O{m[1]}" for m in re.finditer(r"\bo([1-9])\b", re.sub(_table("numbered")["of_all"], r"o\g<n>", plain)))
    return next((cid for cid in ids if cid not in structure), "")


def _of_type(match: re.Match[str], structure: Structure) -> str:
    """The so many-th of one type, where so many are there; who is labelled so goes before."""
    kind = next((s.data["type"] for s in scan.names(match["noun"]) if s.kind == "actor"), match["noun"])
    found = objects_of(structure, kind)
    number = int(match["n"])
    return found[number - 1].id.lower() if 1 < len(found) >= number else match[0]


def _called(plain: str, start: int, end: int, there: set[str], looks: dict[str, set[str]], structure: Structure) -> str:
    """The text with a name for the only one whose look stands before the noun at that place."""
    head = re.search(_table("looks")["head"], plain[:start])
    words = head["words"].split()
    told = [w for w in words if w in looks]
    meant = there.intersection(*(looks[w] for w in told)) if told else set()
    if len(meant) != 1:
        return plain
    at = head.start("words") + head["words"].index(told[0])
    begin = head.start() if at == head.start("words") else at
    return f"{plain[:begin]}{called_by(structure[next(iter(meant))], structure)}{plain[end:]}"


def _looks(structure: Structure) -> dict[str, set[str]]:
    """By word, whom the text of the scene calls by it before the noun."""
    found: dict[str, set[str]] = {}
    if not structure.text or len(structure.objects) < 2:
        return found
    return {word: ids for word, ids in found.items() if len(ids) < len(structure.objects)}
