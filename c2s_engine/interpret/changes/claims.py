"""What a demand says that what is done for it does not hold: numbers, sides, places, moments, limits, members, parties.

Every reading of a demand is measured by it, whichever form made it: the one that leaves least is taken, and what it
leaves is named.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.refer import refer
from c2s_engine.interpret.changes.unmatched_details import NEAR, vocabulary_words
from c2s_engine.interpret.reading import amounts, scan
from c2s_engine.interpret.spans import Span
from c2s_engine.interpret.surroundings import environment
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.quantity import ends

Value = tuple[str, Any]
"""A field's path and what it holds."""

MOMENT = re.compile(
    r"\b(?:as soon as|when|once|after|before|until|till|unless) "
    r"(?!that\b|which\b|(?:ego|it|him|her|o\d)$|(?:the|an?|his|her|its|our|my|this)\b(?: [\w-]+){0,2}$)[^,.;]+"
)
"""When something happens, by what happens; a noun alone behind the word is a place or a party."""
LATER = re.compile(r"\d ?(?:s|secs?|seconds?) (?:after|before|later|earlier)\b")
DENIES = re.compile(r"\b(?:not|never|without|no|instead|stops?|nobody|ignor\w+|remov\w+|delet\w+)\b|n't\b")
VERB = re.compile(
    r"\b(?:brak(?:es?|ing)|overtak(?:es?|ing)|follow(?:s|ing)?|cuts? in|turns?|swerves?|accelerates?"
    r"|crosses|reverses?)\b(?! (?:lane|in|to be))"
)
"""Verbs that only tell of an act."""
BARE = re.compile(r"\b(?:at|with|to|by|of|doing) (?P<value>\d{2,3})(?= (?:and|when|as|in|on)\b|[,;]|$)")
"""A number that has no unit."""
RELATIVE = re.compile(
    r" ?(?:slower|faster|closer|nearer|further|farther|later|earlier|more|less|quicker|sooner|up|down|towards?)\b"
)
FIELDS = {"speed": r"speed", "distance": r"gap|clearance|spacing|distance|lateral|trigger",
          "time": r"trigger|delay|later|arrives|duration", "acceleration": r"rate|limits"}  # fmt: skip
"""Fields that a number of a dimension can change."""
ALIKE = (
    ("left", "leftmost"),
    ("right", "rightmost"),
    ("beside", "abreast"),
    ("behind", "hidden"),
    ("behind", "hidden_by"),
    ("parked", "stationary"),
)
"""Words that another one of the vocabulary answers."""
MEMBER = re.compile(r"\b(?:middle|second|third|fourth|last|first) (?:one|exit|car|van|truck|bus|lane|arm|street)\b")
MODAL = re.compile(r"\b(?:may|is allowed to|are allowed to|is permitted to)\b(?! not| never)")
REACTS = re.compile(r"\breacts?\b(?: \w+)?(?= to\b)")
BOUNDS = re.compile(
    r"\b(?:(?:limit|restrict)(?= (?:the|its|his|ego)\b)|(?:at (?:least|most)|(?:no|not) (?:more"
    r"|less) than)(?= \d[\d.]* ?(?:m|s|m/s2|metres|meters|seconds)\b(?!/))|(?:fall|drop|go"
    r"|be) (?:below|above|under))"
)
SAME_LANE = re.compile(r"\bin (?:the )?(?:same|ego's|our) lane\b")
SIDES = re.compile(r"\b(?:left|right)\b")
FROM_BEHIND = re.compile(r"\bfrom behind\b")
BETWEEN = re.compile(r"\bbetween (?:them|the|ego|it|both|two|o\d)\b")
UNTOUCHED = re.compile(
    r"\bwithout (?:\w+ )?(?:hitting|touching|colliding|a collision|contact|any contact|crashing)\b[^,.;]*"
)


@dataclass(frozen=True)
class UnaddressedWords:
    """The words of a demand to which nothing answers: those without which it is another demand, and the rest."""

    needed: tuple[str, ...] = ()
    besides: tuple[str, ...] = ()

    def with_more(self, words: Sequence[str]) -> "UnaddressedWords":
        """With words that a reading left out, but for those that are there already or are within them."""
        known = [*self.needed, *self.besides]
        new = (w for w in words if not any(w in k or k in w for k in known))
        return UnaddressedWords(self.needed, (*self.besides, *new))

    def __len__(self) -> int:
        return len(self.needed) * 2 + len(self.besides)


def unaddressed_words(demand: str, before: Structure, after: Structure) -> UnaddressedWords:
    """The words of a demand that nothing in what is changed (or already holds) answers, as they are said."""
    changed = list(_differences(before, after))
    spans = [s for s in scan.names(demand) if s.kind in ("actor", "label", "ego")]
    spans += [Span("id", *m.span()) for m in re.finditer(r"\bo[1-9]\b", demand)]
    edited = {path.partition(".")[0] for path, _ in changed}
    named = _named(demand, spans, after)
    parts = [*(c for c in after.components if c.id in edited), *(c for _, c in named)]
    parts = [*(parts or after.components), after.place, after.settings, after.restrictions]
    values = [*changed, *(v for c in parts for v in _leaves("", c.spec.model_dump()))]
    needed = [*_numbers(demand, changed, values), *_others(demand, changed, _NEEDED)]
    besides = [*_moments(demand, changed), *_others(demand, changed, _BESIDES), *_parties(named, edited)]
    words = [*_words(demand, spans, values), *_sky(demand, spans, values), *_acts(demand, changed, values)]
    if not changed and (only := re.search(r"\b(?:only|just) [\w ]+$", demand)):
        needed.append(only[0])
    if not any(path.split(".")[1:2] == ["phases"] for path, _ in changed):
        needed, besides = [*needed, *_moments(demand, changed)], besides[len(_moments(demand, changed)) :]
    if changed and edited == {"R"}:  # the side of something at the road, which has none in S
        return UnaddressedWords(tuple(needed), (*words, *besides))
    return UnaddressedWords((*needed, *words), tuple(besides))


def _named(demand: str, spans: Sequence[Span], structure: Structure) -> list[tuple[str, Component]]:
    """Whom a demand names, in its order, with the words."""
    said = [demand[s.start : s.end] for s in sorted(spans, key=lambda s: s.start)]
    found = [(words, refer(f"the {words}", structure, alone=False)) for words in said]
    return [(words, one) for words, one in found if one is not None]


def _parties(named: list[tuple[str, Component]], edited: set[str]) -> list[str]:
    """Those whom a demand names after the one it is about, and whom nothing in S refers to with that one."""
    objects = [(words, c, {v for _, v in _leaves("", c.spec.model_dump())}) for words, c in named if c.kind == "O"]
    if not objects:
        return []
    _, first, about = objects[0]
    known = {first.id, *about, *edited}
    return [words for words, one, values in objects[1:] if one.id not in known and first.id not in values]


def _numbers(demand: str, changed: list[Value], values: list[Value]) -> list[str]:
    """Numbers with a unit that no field holds, nor changes by."""
    numbers = [both for _, v in values if (both := ends(v)) is not None]
    found = []
    for said in amounts.quantities(demand):
        low, high, dimension = said.data["low"], said.data["high"], said.data["dimension"]
        held = any(abs(a - low) < NEAR and (abs(b - high) < NEAR or abs(b - low) < NEAR) for a, b in numbers)
        more = RELATIVE.match(demand[said.end :]) or re.search(
            r"\b(?:by|add|take) (?:about |another )?$", demand[: said.start]
        )
        by = more and any(re.search(FIELDS.get(dimension, ""), path) for path, _ in changed)
        by = by or more and not changed  # it is so much more already
        if dimension != "percent" and not held and not by:
            found.append(demand[said.start : said.end].strip())
    known = [(s.start, s.end) for s in (*amounts.quantities(demand), *scan.names(demand))]
    for bare in BARE.finditer(demand):
        value = float(bare["value"])
        told = any(a < bare.end() and bare.start("value") < b for a, b in known)
        if not told and not any(abs(a - v) < NEAR for a, _ in numbers for v in (value, value / 3.6)):
            found.append(bare[0])
    return found


def _words(demand: str, spans: Sequence[Span], values: list[Value]) -> list[str]:
    """Sides, places and parts that no field holds."""
    bare = demand
    for span in spans:
        bare = f"{bare[: span.start]}{' ' * (span.end - span.start)}{bare[span.end :]}"
    held = {w for _, v in values if isinstance(v, str) for w in v.split("_")}
    held |= {w for path, v in values if v is not None for w in path.split(".")}
    held |= {w for w, same in ALIKE if same in held} | {"ahead", "front"}
    bare = re.sub(r"\bmiddle of (?:the|its|ego's) (?:road|street|lane|crossing|crosswalk)\b", " ", bare)
    said = re.findall(r"[a-z]+", bare)
    in_line = any(path.endswith("placement.position") and v in ("ahead", "behind") for path, v in values)
    apart = [m[0] for m in [SAME_LANE.search(demand)] if m and not in_line]
    return apart + [w for w in dict.fromkeys(said) if w in vocabulary_words() and w not in held]


def _sky(demand: str, spans: Sequence[Span], values: list[Value]) -> list[str]:
    """Weather and times of the day that S does not have."""
    if DENIES.search(demand) or re.search(r"\b(?:too|less|replace|swap|change)\b", demand):
        return []
    whole = [(0, len(demand))]
    time = environment.time_of_day(demand, whole)
    found = [*environment.weather(demand, whole), *([time] if time is not None else [])]
    held = {v for _, v in values if isinstance(v, str)}
    return [demand[slice(*f.span)] for f in found if f.value not in held and f.span[0] < f.span[1]]


def _acts(demand: str, changed: list[Value], values: list[Value]) -> list[str]:
    """Verbs of acts that nobody does, nor is waited for, nor is bounded, nor an answer of ego."""
    main = re.sub(language.table("refine")["told"]["meanwhile"], " ", demand)
    if DENIES.search(main) or any(path.startswith(("T.", "G.light_changes")) for path, _ in changed):
        return []
    held = {v for _, v in values if isinstance(v, str)}
    found = []
    for verb in VERB.finditer(main):
        acts = {a for stem, done in language.table("refine")["doers"].items() if re.match(stem, verb[0]) for a in done}
        if (
            acts
            and not (acts | {"evade", "yield", "overtake"}) & held
            and not (verb[0].startswith("brak") and "brake" in held)
        ):
            found.append(verb[0])
    return found


def _moments(demand: str, changed: list[Value]) -> list[str]:
    """Clauses of time where nothing that is changed waits for anything."""
    said = MOMENT.search(demand) or LATER.search(demand)
    waits = any(
        "trigger" in path or "until" in path or "light_changes" in path or path.startswith("T.") for path, _ in changed
    )
    ordered = len([p for p, _ in changed if p.endswith(".action")]) > 1
    return [said[0]] if said and not waits and not ordered else []


_NEEDED = (
    (MODAL, r"T\.limits"),
    (BOUNDS, r"limits|clearance|minimum|maximum|R\.lanes|speed_limit"),
    (FROM_BEHIND, r"part|placement"),
    (REACTS, r"reaction|react_to|trigger"),
)
_BESIDES = ((BETWEEN, r"hidden_by|spacing|gap"), (UNTOUCHED, r"limits"))


def _others(demand: str, changed: list[Value], rows: Sequence[tuple[re.Pattern[str], str]]) -> list[str]:
    """Permissions, bounds, reactions and the like where what is changed says nothing of the kind."""
    paths = " ".join(path for path, _ in changed)
    return [m[0].strip() for find, answer in rows if (m := find.search(demand)) and not re.search(answer, paths)]


def _differences(before: Structure, after: Structure) -> Iterator[Value]:
    """The fields, down to single values, that differ in the later S."""
    for component in after.components:
        old = dict(_leaves(component.id, before[component.id].spec.model_dump())) if component.id in before else {}
        for path, value in _leaves(component.id, component.spec.model_dump()):
            if path not in old or old[path] != value:
                yield path, value
    for component in before.components:
        new = dict(_leaves(component.id, after[component.id].spec.model_dump())) if component.id in after else {}
        yield from ((path, None) for path, _ in _leaves(component.id, component.spec.model_dump()) if path not in new)


def _leaves(path: str, value: Any) -> Iterator[Value]:
    if isinstance(value, dict):
        for key, part in value.items():
            yield from _leaves(f"{path}.{key}", part)
    elif isinstance(value, list | tuple) and ends(value) is None:
        for number, part in enumerate(value):
            yield from _leaves(f"{path}.{number}", part)
    elif value is not None:
        yield path, value
