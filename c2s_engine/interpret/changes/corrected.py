"""The last turn corrected: "no, the other car", "I meant 60", "not that one, the truck".

What was typed last is said again of whom, or with the value, side or type, that was meant, on S as it was before.
"""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes import put
from c2s_engine.interpret.changes.chosen import matching_modifiers
from c2s_engine.interpret.changes.meant import called
from c2s_engine.interpret.changes.refer import objects_of, refer, spec_of
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import AddObject, Edit, MoveObject, RemoveObject, SetSpec, apply

_ELLIPTIC = 7  # words at most of a text that leaves out whom it is about


@dataclass(frozen=True)
class PreviousTurn:
    """The turn before: what was typed, and S as it was then."""

    text: str
    before: Structure


@dataclass(frozen=True)
class CorrectedTurn:
    """What is to be read instead, and upon which S; `why`: why it cannot be said of another."""

    text: str = ""
    upon: Structure | None = None
    why: str = ""


def _table() -> dict[str, Any]:
    found: dict[str, Any] = language.table("turns")["corrections"]
    return found


def corrected(plain: str, structure: Structure, last: PreviousTurn) -> CorrectedTurn | None:
    """What was typed last as it was meant; None where the text corrects nothing."""
    table = _table()
    if last.before.text != structure.text:
        return None
    lead = re.match(table["lead"], plain)
    said = plain[lead.end() :] if lead else plain
    besides = bool(re.search(table["besides"], plain))
    if not (lead and re.search(table["meant"], lead[0])) and not besides and not re.match(table["alone"], plain):
        return None
    what = re.sub(table["behind"], "", re.sub(table["put"], "", said))
    before = " ".join(scan.normalised(last.text).rstrip("?!. ").split())
    upon = structure if besides else last.before
    if other := re.fullmatch(table["other"], what):
        return _of_another(before, _others(other["noun"] or "", structure, last), structure, last, upon)
    if besides:
        return None
    for form, said_anew in ((table["value"], _valued), (_opposite(), _turned), (table["type"], _typed)):
        if (match := re.fullmatch(form, what)) and (text := said_anew(match, before)):
            return CorrectedTurn(text, last.before)
    meant = _named(what, last.before) or _matching_modifier(what, structure, last)
    return _of_another(before, [meant], structure, last, upon) if meant is not None else None


def _named(what: str, structure: Structure) -> Component | None:
    """Who is named, where nothing but a name is said."""
    name = called(put.plainly(what, structure), structure)
    spans = [s for s in scan.names(name) if s.kind in ("actor", "ego")]
    whole = re.fullmatch(r"o\d", name) or spans and re.fullmatch(r"(?:the )?", name[: spans[0].start])
    return refer(name, structure, alone=False) if whole and (not spans or spans[0].end == len(name)) else None


def _matching_modifier(what: str, structure: Structure, last: PreviousTurn) -> Component | None:
    """ "The red one": of those of the type of whom the last turn changed, the one whom the text calls so."""
    types = {spec_of(c).type for c in _touched(structure, last) if c.id != "E"}
    alike = [c for c in last.before.objects if spec_of(c).type in types]
    if not re.fullmatch(r"the [\w-]+(?: [\w-]+)? one", what):
        return None
    found = matching_modifiers(what[:-3], alike, last.before.text)
    return found[0] if len(found) == 1 else None


def _touched(structure: Structure, last: PreviousTurn) -> list[Component]:
    """Those whom the last turn changed, as they were before."""
    there = {c.id: c for c in structure.components}
    return [
        c
        for c in last.before.components
        if c.id in ("E", *(o.id for o in last.before.objects)) and (c.id not in there or there[c.id].spec != c.spec)
    ]


def of_the_same(plain: str, structure: Structure, last: PreviousTurn) -> tuple[str, str] | None:
    """Whom a short text that names nobody is about, where the last turn changed or added one alone, and the text with
    its name: "no, 5 m closer" after "add a cyclist"."""
    if last.before.text != structure.text or len(plain.split()) > _ELLIPTIC:
        return None
    lead = re.match(_table()["lead"], plain)
    said = plain[lead.end() :] if lead else plain
    if not re.search(r"\d|\w(?:er|ier)\b|\b(?:more|less)\b", said) or re.search(r"\bo\d\b|[.?!] ", said):
        return None
    if any(s.kind in ("actor", "ego") for s in scan.names(said)):
        return None
    before = {c.id: c.spec for c in last.before.components}
    changed = [c.id for c in structure.components if before.get(c.id) != c.spec]
    if len(changed) != 1 or changed[0] not in ("E", *(o.id for o in structure.objects)):
        return None
    name = "ego" if changed == ["E"] else changed[0].lower()
    return changed[0], f"{name} {said}"


def _others(noun: str, structure: Structure, last: PreviousTurn) -> list[Component]:
    """Who can be the other: of the noun, else of the same type as who was changed, else whoever is there."""
    touched = _touched(structure, last)
    gone = {c.id for c in touched}
    left = [c for c in last.before.objects if c.id not in gone]
    kind = next((s.data["type"] for s in scan.names(noun) if s.kind == "actor"), None)
    if kind is not None:
        alike = {c.id for c in objects_of(last.before, kind)}
        found = [c for c in left if c.id in alike]
    else:
        types = {spec_of(c).type for c in touched if c.id != "E"}
        found = [c for c in left if spec_of(c).type in types] or left
    return found or ([last.before.ego] if "E" not in gone and touched else [])


def _of_another(before: str, found: list[Component], structure: Structure, last: PreviousTurn,
                upon: Structure) -> CorrectedTurn | None:  # fmt: skip
    """The last text with another in the place of whom it changed."""
    touched = {c.id for c in _touched(structure, last)}
    if not touched or not found or len(found) == 1 and found[0].id in touched:
        return None
    if len(found) > 1:
        return CorrectedTurn(why=f"which one is meant? There are {', '.join(c.id for c in found)}")
    name = "ego" if found[0].id == "E" else found[0].id.lower()
    plain = called(put.plainly(before, last.before), last.before)
    said = _renamed(
        plain, name, lambda words: (r := refer(words, last.before, alone=False)) is not None and r.id in touched
    )
    if said == plain:
        said = re.sub(_table()["pronoun"], name, plain, count=1)
    return CorrectedTurn(said if said != plain else f"{name} {plain}", upon)


def _renamed(plain: str, name: str, fits: Callable[[str], bool]) -> str:
    """The text with a name for those whom the test fits."""
    spans = [(s.start, s.end) for s in scan.names(plain) if s.kind in ("actor", "ego") and not s.data.get("plural")]
    spans += [m.span() for m in re.finditer(r"\bo\d\b", plain)]
    for start, end in sorted(spans, reverse=True):
        head = re.search(r"\b(?P<new>an?|another)?(?:\bthe |\bthat |\bthis |\bour )?(?:[\w-]+ )?$", plain[:start])
        article = re.search(r"\b(the|that|this|our) (?:[\w-]+ ){0,2}$", plain[:start])
        if re.search(r"\b(?:an?|another|one|two) (?:[\w-]+ )?$", plain[:start]) or head is None:
            continue
        begin = article.start() if article else start
        if fits(plain[begin:end]):
            plain = f"{plain[:begin]}{name}{plain[end:]}"
    return plain


def _valued(match: re.Match[str], before: str) -> str:
    """The last text with another number, where it has one (of that unit)."""
    unit = (match["unit"] or "").strip()
    olds = [
        old
        for old in re.finditer(_table()["old_value"], before)
        if not unit or not old["unit"] or old["unit"].strip()[0] == unit[0]
    ]
    if len(olds) != 1:
        return ""
    now = f"{match['value']}{match['unit'] or olds[0]['unit'] or ''}"
    return f"{before[: olds[0].start()]}{now}{before[olds[0].end() :]}"


@cache
def _opposite() -> str:
    words = {word for pair in _table()["opposites"] for word in pair}
    return _table()["opposite"].format(words="|".join(sorted(words, key=len, reverse=True)))


def _turned(match: re.Match[str], before: str) -> str:
    """The last text with the opposite of a word in it: the other side, "faster" for "slower"."""
    pairs = _table()["opposites"]
    others = [two for pair in pairs for word, two in (pair, reversed(pair)) if word == match["word"]]
    said = next((w for w in ([match["word"]] if match["how"] else others) if re.search(rf"\b{w}\b", before)), None)
    if said is None:
        said = next((w for w in others if re.search(rf"\b{w}\b", before)), None)
    return re.sub(rf"\b{said}\b", f"{match['how']}{match['word']}", before, count=1) if said else ""


def _typed(match: re.Match[str], before: str) -> str:
    """The last text with another type for the new one that it has."""
    new = [s for s in scan.names(match["type"]) if s.kind == "actor"]
    for span in scan.names(before) if new else ():
        article = re.search(r"\ban? (?:[\w-]+ )?$", before[: span.start])
        if span.kind == "actor" and article:
            return f"{before[: article.start()]}{match['type']}{before[span.end :]}"
    return ""


def after(structure: Structure, edits: Sequence[Edit]) -> Structure:
    """S after the edits."""
    for edit in edits:
        structure = apply(structure, edit)
    return structure


def differences(now: Structure, wanted: Structure) -> list[Edit]:
    """The edits after which S is the wanted one."""
    edits: list[Edit] = []
    for component in wanted.components:
        if component.id in now and now[component.id].spec != component.spec:
            edits.append(_as(component))
        elif component.id not in now:
            edits.append(AddObject(component=component.id, spec=spec_of(component), description=component.description))
    added = [e for e in edits if isinstance(e, AddObject)]
    gone: list[Edit] = [RemoveObject(component=c.id) for c in now.objects if c.id not in wanted]
    edits = [*added, *(e for e in edits if e not in added), *gone]
    ids = [c.id for c in wanted.objects]
    moved = [cid for cid in ids if any(e.component == cid for e in added)]
    return [*edits, *(MoveObject(component=cid, index=ids.index(cid)) for cid in moved)]


def _as(component: Component) -> SetSpec:
    said: dict[str, Any] = {"description": component.description, "assumed": component.assumed}
    return SetSpec(component=component.id, spec=component.spec, **said)
