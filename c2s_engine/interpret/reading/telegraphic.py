"""Notes without verbs and articles become plain sentences, by data/language/telegraphic.yaml: "van 60 left lane 10 m
behind, cuts in" is read as "van drives at 60 km/h in the left lane 10 m behind ego. the van cuts in"."""

import re
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.reading import division, letters, scan
from c2s_engine.interpret.reading.amounts import MILES
from c2s_engine.interpret.reading.motions import third_persons
from c2s_engine.interpret.reading.rewritten import Replacement
from c2s_engine.interpret.reading.scan import Span

JOINED = re.compile(r"\s*(?:and|&|\+|/)\s*$")
SKIPS = re.compile(r"[\s,:=-]*(?:(?:and|then)\s+)?")
LINKS = re.compile(
    r"(?:with|without|ahead of|beside|alongside|next to|towards?|near|behind|in|on|at|by|past|after|before|between"
    r"|under|off|facing)\b"
)
PARTICIPLE = re.compile(r"(?!going\b|coming\b|during\b|following\b|leading\b|oncoming\b|nothing\b)[a-z]{3,}ing\b")


SPEED = re.compile(r"\s+\d{2,3}\b(?! ?(?:m|metres?|meters?|s|secs?|seconds?|ft|feet|years?|cars|%))")


@dataclass
class Note:
    """What the pieces after a road user say."""

    places: list[str] = field(default_factory=list)
    acts: list[str] = field(default_factory=list)
    speed: str = ""
    bare: bool = False
    state: bool = False
    rest: str = ""


@dataclass(frozen=True)
class Subject:
    """A road user that heads a note."""

    text: str
    name: str
    ego: bool
    plural: bool
    label: bool
    walks: bool


def spelt_out(text: str) -> list[Replacement]:
    """The notes of a text with the sentences that they stand for."""
    plain = scan.normalised(text)
    unit = "mph" if MILES.search(plain) else "km/h"
    names = [s for s in scan.names(plain, letters.cased(text, plain)) if s.kind in ("ego", "actor", "label")]
    found: list[Replacement] = []
    for start, end in division.sentences(text):
        found += _sentence(text, plain, start, end, names, unit)
    return found


def _sentence(text: str, plain: str, start: int, end: int, names: list[Span], unit: str) -> list[Replacement]:
    found: list[Replacement] = []
    subjects: list[Subject] = []
    neighbour = "ego"
    last = start
    parts = _parts(plain, start, end, names)
    for number, (first, stop) in enumerate(parts):
        headed = _headed(text, plain, first, stop, names)
        said = None
        if headed is not None:
            heads, at = headed
            note = _read(_unbracketed(plain[at:stop]), all(h.ego for h in heads), unit)
            bare = note is not None and (note.bare or note.state and not any(h.label for h in heads))
            said = " ".join(_say(h.text, h, note) for h in heads) if note is not None and bare else None
            said = said.replace("{neighbour}", neighbour) if said is not None else None
            subjects = heads if said is not None else []
            neighbour = "ego" if heads[-1].ego else heads[-1].name
        elif subjects:
            note = _read(_unbracketed(plain[first:stop]), all(h.ego for h in subjects), unit)
            again = note is not None and (note.places or note.acts or note.speed)
            said = " ".join(_say(h.name, h, note) for h in subjects) if note is not None and again else None
            said = said.replace("{neighbour}", "ego") if said is not None else None
        if said is not None:
            before = ". " if first > start and text[last:first].strip(" \t") in (",", "-", "and", "&", "+") else None
            at = last if before else first
            close = "." if re.search(r"[.;!]$", plain[first:stop].rstrip()) else ""
            found.append((at, stop, (before or "") + said.rstrip(". ") + close))
        last = stop
        if said is not None and stop < end and plain[stop] == ",":
            following = next((p for p in parts[number + 1 :] if p[0] >= stop), None)
            if following is not None and _is_left(plain, following, names, subjects, unit, text):
                found.append((stop, stop + 1, "."))
                last = stop + 1
    return found


def _is_left(
    plain: str, part: tuple[int, int], names: list[Span], subjects: list[Subject], unit: str, text: str
) -> bool:
    """Whether the part after a note stays as it is."""
    first, stop = part
    headed = _headed(text, plain, first, stop, names)
    ego = all(h.ego for h in (headed[0] if headed else subjects))
    note = _read(_unbracketed(plain[headed[1] if headed else first : stop]), ego, unit)
    if note is None:
        return True
    return not note.bare if headed else not (note.places or note.acts or note.speed)


def _parts(plain: str, start: int, end: int, names: list[Span]) -> list[tuple[int, int]]:
    """The stretches between commas, and before "and" or "+" where a road user follows."""
    cuts = [m.span() for m in re.finditer(r",(?!\d)\s*|\s-\s+|(?<=[a-z]):\s+(?=[a-z])", plain[start:end])]
    spans = [(start + a, start + b) for a, b in cuts if plain[: start + a].count("(") == plain[: start + a].count(")")]
    for name in names:
        near = max(start, name.start - 40)
        joined = JOINED.search(plain[near : name.start]) if start < name.start < end else None
        if joined is not None and re.search(r"\d(?: ?[a-z/]+)?$", plain[near : near + joined.start()]):
            spans.append((near + joined.start(), name.start))
    found, at = [], start
    for first, stop in sorted(spans):
        if first > at:
            found.append((at, first))
            at = stop
    found.append((at, end))
    return found


def _headed(text: str, plain: str, first: int, stop: int, names: list[Span]) -> tuple[list[Subject], int] | None:
    """(the road users without an article that a part begins with, where their note begins)."""
    inside = [n for n in names if first <= n.start and n.end <= stop]
    if not inside:
        return None
    words = "|".join(language.table("telegraphic")["before"])
    name = inside[0]
    article = r"(?:an?\s+)?" if SPEED.match(plain[name.end : stop]) else ""  # "a van 90 km/h"
    if not re.fullmatch(rf"{article}(?:(?:\d{{1,2}}|{words})\s+){{0,2}}", plain[first : name.start]):
        return None
    heads = [_subject(text, plain, first, name)]
    at = _bracket(plain, name.end)
    inside = [n for n in inside if n.start >= at]
    if inside and re.fullmatch(r"\s*(?:and|&|\+|/)\s*", plain[at : inside[0].start]):
        both = re.match(r"\s+(?:both |each )?(?:at )?\d", plain[inside[0].end : stop])
        if not both:
            return None
        heads.append(_subject(text, plain, inside[0].start, inside[0]))
        at = inside[0].end
    return heads, at


def _unbracketed(rest: str) -> str:
    """What a note says in a bracket right after the road user without the bracket: "car (right, 90, +30)"."""
    rest = rest.rstrip(" .;!")
    inside = re.match(r"\s*[(\[](?P<note>[^()\[\]]*\d[^()\[\]]*)[)\]](?P<more>.*)$", rest, re.DOTALL)
    if inside is None:
        return rest
    note = re.sub(r"^\s*(left|right|middle|cent(?:er|re))(?=\s*,)", r"\1 lane", inside["note"])
    return f"{note}, {inside['more'].strip()}".rstrip(" ,")


def _bracket(plain: str, at: int) -> int:
    match = re.match(r"\s?\([^()\d]{1,16}\)", plain[at:])
    return at + match.end() if match else at


def _subject(text: str, plain: str, first: int, name: Span) -> Subject:
    ego, label = name.kind == "ego", name.kind == "label"
    data = name.data
    full = text[first : _bracket(plain, name.end)]
    plural = bool(data.get("plural"))
    walks = data.get("type") in ("pedestrian", "child", "animal")
    again = text[name.start : name.end] if ego or label else "the " + text[name.start : name.end]
    return Subject(full, again, ego, plural, label, walks)


@cache
def _pieces() -> list[tuple[re.Pattern[str], dict[str, Any]]]:
    table = language.table("telegraphic")
    words: dict[str, str] = table["words"]
    return [(re.compile(language.filled(entry["find"], words)), entry) for entry in table["pieces"]]


def _read(rest: str, ego: bool, unit: str) -> Note | None:
    """The pieces of a note; None where something in it is no piece."""
    note = Note()
    skipped = SKIPS.match(rest)
    rest = rest[skipped.end() if skipped and not re.match(r"\s*-\s?\d", rest) else 0 :].strip()
    while rest:
        for pattern, entry in _pieces():
            match = pattern.match(rest)
            if match and not (ego and entry.get("other")) and not (entry["kind"] == "speed" and note.speed):
                _add(note, entry, match, unit)
                rest = rest[match.end() :]
                skipped = SKIPS.match(rest)
                rest = rest[skipped.end() if skipped and not re.match(r"\s*-\s?\d", rest) else 0 :].strip()
                break
        else:
            break
    if rest and not _goes_on(note, rest):
        return None
    return note


def _goes_on(note: Note, rest: str) -> bool:
    """Whether what is left of a note is a verb's, or more words on the place; it is added then."""
    adverbs = "|".join(set(language.table("telegraphic")["adverbs"]))
    verb = re.match(rf"(?:(?:{adverbs})\s+)*(?P<verb>[a-z'-]+)", rest)
    if verb and (verb["verb"] in third_persons() or re.match(r"(?:does|is|has)(?:n't| not)\b", verb["verb"])):
        note.acts.append(re.sub(r"^(?:and|but)\s+", "", rest))
        return True
    if PARTICIPLE.match(rest):
        note.acts.append(f"is {rest}")
        return True
    if LINKS.match(rest) and (note.places or note.speed or note.acts):
        if note.acts and not note.places:
            note.acts[-1] += f" {rest}"
        else:
            note.places.append(rest)
        return True
    return False


def _add(note: Note, entry: dict[str, Any], match: re.Match[str], unit: str) -> None:
    note.bare = note.bare or bool(entry.get("bare"))
    note.state = note.state or bool(entry.get("noun"))
    said = str(entry["say"])
    if entry["kind"] == "speed":
        told = re.search(r"km/?h|kph|kmph|mph|m/s", match[0])
        note.speed = said.replace("{speed}", f"{match[1]} {told[0] if told else unit}" if "{speed}" in said else "")
        return
    for number in range(1, (match.re.groups or 0) + 1):
        said = said.replace(f"{{{number}}}", match[number] or "")
    (note.places if entry["kind"] == "place" else note.acts).append(said)


def _say(name: str, who: Subject, note: Note) -> str:
    """The sentences of a note about one road user."""
    said: list[str] = []
    lane = [p for p in note.places if "lane" in p]
    places = " ".join([*lane, *(p for p in note.places if p not in lane)])
    if note.speed or note.places:
        verb = ("moves" if who.walks else "drives") if note.speed else "is"
        said.append(f"{verb} {note.speed} {places}")
    said += note.acts
    verbs = (s if who.plural else s for s in said)
    parts = [" ".join(f"{name if n == 0 else who.name} {s}".split()) for n, s in enumerate(verbs)]
    return ". ".join(p[:1].upper() + p[1:] if n else p for n, p in enumerate(parts)) + "."
