"""What a question asks of a run: which fact, of whom, towards whom, when and within which bound, by the words of
data/asked.yaml. What of it was not read is kept: no yes or no is given where something was not."""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal

import yaml

from c2s_engine import paths
from c2s_engine.dryrun.events.table import definitions
from c2s_engine.interpret.language import actor_nouns
from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.structure.stems import stem

_WORD = re.compile(r"\d+(?:\.\d+)?|(?:km/h|m/s[2²]?)|o\d+\b|[a-z]+(?:[-'][a-z]+)*", re.I)
_NUMBER = re.compile(r"\d")
_WHETHER = re.compile(r"(?:is|are|was|were|does|do|did|has|have)(?:n't)?\b")
LONGEST = 5
"""Words that mean one thing together."""


@dataclass(frozen=True)
class Fact:
    """A kind of fact: how it is called, and the events that show it."""

    verb: str
    events: tuple[str, ...]


@dataclass(frozen=True)
class Party:
    """Somebody who is asked about: the components that are named, or whoever it is; `others` than ego."""

    cids: tuple[str, ...] = ()
    how: Literal["", "any", "all"] = ""
    others: bool = False

    def __bool__(self) -> bool:
        return bool(self.cids or self.how)


@dataclass(frozen=True)
class Question:
    """`whether`: yes or no is asked; `moment`: its word, the fact and whose; `aside`: what restricts the question and
    cannot be told from a run."""

    whether: bool
    fact: Fact | None = None
    measure: str = ""
    subject: Party = Party()
    object: Party = Party()
    moment: str = ""
    moment_fact: Fact | None = None
    moment_subject: Party = Party()
    order: str = ""
    aside: str = ""
    unread: str = ""
    absent: str = ""
    negated: bool = False


@dataclass(frozen=True)
class _Part:
    """Words of the question that mean one thing."""

    kind: str
    text: str
    at: int
    value: Any = None


@dataclass(frozen=True)
class _Words:
    parts: list[_Part]

    def of(self, *kinds: str) -> list[_Part]:
        return [p for p in self.parts if p.kind in kinds]

    def first(self, *kinds: str) -> _Part | None:
        return next(iter(self.of(*kinds)), None)


@cache
def _table() -> Any:
    return yaml.safe_load(paths.shipped("asked.yaml").read_text("utf-8"))


@cache
def takes_another() -> frozenset[str]:
    """The events that name another party."""
    return frozenset(name for name, event in definitions().items() if event.other)


@cache
def of_ego_alone() -> frozenset[str]:
    """Those of them that are looked for between ego and others, not between any two."""
    return frozenset(name for name in takes_another() if "(ego" in definitions()[name].holds)


@cache
def _known() -> dict[tuple[str, ...], tuple[str, Any]]:
    """By the stems of words, what they mean: a kind of part and its value."""
    table, found = _table(), {}
    for kind in ("plain", "open", "moments", "below", "above", "not", "it", "them", "everybody", "anybody", "order"):
        for word in table[kind]:
            found[_stems(word)] = (kind, word)
    for measure, words in table["measures"].items():
        found.update({_stems(word): ("measure", measure) for word in words})
    for fact in table["facts"]:
        value = Fact(fact["words"][0], tuple(fact["events"]))
        found.update({_stems(word): ("fact", value) for word in fact["words"]})
    return found


def _stems(text: str) -> tuple[str, ...]:
    forms = _table()["forms"]
    return tuple(stem(forms.get(word, word)) for word in text.lower().split())


def read(question: str, structure: Structure) -> Question:
    """What is asked, as far as its words tell."""
    plain = re.sub(r"^\s*(?:and|but|so|then|or)\s+", "", question.replace("’", "'").strip().rstrip("?!. ")).lower()
    words = _Words(_parts(plain, structure))
    main = words.first("fact", "measure")
    moment = next((p for p in words.of("moments") if main and p.at > main.at), None)
    clause = _Words([p for p in words.parts if moment is None or p.at < moment.at])
    fact = main.value if main and main.kind == "fact" else None
    aside = _aside(clause, fact)
    body = _Words([p for p in clause.parts if aside is None or p.at < aside.at])
    subject, object_ = _parties(plain, clause if aside is None or _to_somebody(clause, aside, fact) else body, main)
    if fact and "hits" not in fact.events and not subject and object_ and not takes_another() & set(fact.events):
        subject, object_ = object_, Party()  # "was there a lane change by the van?"
    later = _Words([p for p in words.parts if moment and p.at > moment.at])
    moment_fact = f.value if moment and (f := later.first("fact")) and not later.of("unread") else None
    hanging = moment if moment and moment_fact is None else None  # "before the child"
    ends = [p.at for p in (aside, hanging) if p is not None]
    quantity = clause.first("quantity")
    extra = [p.text for p in body.parts if p.kind == "unread"]
    extra += [p.text for p in body.of("fact", "measure") if p is not main and p.value != getattr(main, "value", 0)]
    return Question(
        whether=_WHETHER.match(plain) is not None, fact=fact,
        measure=str(main.value) if main and main.kind == "measure" else quantity.value if quantity else "",
        subject=subject, object=object_, moment=moment.text if moment else "", moment_fact=moment_fact,
        moment_subject=_party(later.parts) if moment else Party(),
        order=next((p.text for p in body.of("order")), ""), aside=plain[min(ends):].strip() if ends else "",
        unread=", ".join(dict.fromkeys(extra)), absent=next((p.text for p in words.of("absent")), ""),
        negated=bool(words.of("not")) or "n't" in plain,
    )  # fmt: skip


def _parts(plain: str, structure: Structure) -> list[_Part]:
    """The question cut into words that mean one thing, the longest first; articles stay apart from all."""
    named, found = _named(structure), []
    tokens = list(_WORD.finditer(re.sub(r"'s\b|n't\b", lambda m: " " * len(m[0]), plain)))
    tokens = [m for m in tokens if m[0] not in ("a", "an", "the")]
    at = 0
    while at < len(tokens):
        for length in range(min(LONGEST, len(tokens) - at), 0, -1):
            taken = tokens[at : at + length]
            part = _meant(plain, taken, named)
            if part is not None or length == 1:
                found.append(part or _Part("unread", taken[0][0], taken[0].start()))
                at += length
                break
    return found


def _meant(plain: str, taken: list[re.Match[str]], named: dict[tuple[str, ...], tuple[str, ...]]) -> _Part | None:
    """What some words mean together; None where nothing."""
    words, start = [m[0] for m in taken], taken[0].start()
    text = " ".join(words)
    stemmed = _stems(text)
    if stemmed in named:
        return _Part("name", text, start, named[stemmed])
    if len(words) == 2 and _NUMBER.match(words[0]) and words[1] in _table()["units"]:
        return _Part("quantity", text, start, _table()["units"][words[1]])
    noun = words[-1].endswith("ing") and re.search(r"\b(?:a|an|the) $", plain[:start])  # "the crossing"
    if (known := _known().get(stemmed)) and not noun:
        kind, value = known
        if kind == "order" and plain[:start].rstrip().endswith("the"):  # "the last car"
            return _Part("unread", text, start)
        return _Part(kind, text, start, value)
    kind = actor_nouns().get(text, "")
    return _Part("absent", text, start) if kind and kind not in ("vehicle", "rider", "car") else None


def _named(structure: Structure) -> dict[tuple[str, ...], tuple[str, ...]]:
    """By the stems of what they can be called, the components that these words name."""
    found: dict[tuple[str, ...], list[str]] = {
        _stems(word): ["E"] for word in ("ego", "i", "me", "my", "my car", "we", "us", "our", "you", "your", "ego car")
    }
    nouns: dict[str, list[str]] = {}
    for noun, kind in actor_nouns().items():
        nouns.setdefault(kind, []).append(noun)
    for component in structure.objects:
        spec = component.spec
        if isinstance(spec, ObjectSpec):
            own = [spec.name.replace("_", " ").removeprefix("the "), component.id]
            for word in dict.fromkeys([*own, spec.type.replace("_", " "), *nouns.get(spec.type, ())]):
                if component.id not in (cids := found.setdefault(_stems(word), [])):
                    cids.append(component.id)
            for word in own:  # its own name means it alone
                found[_stems(word)] = [component.id, *(c for c in found[_stems(word)] if _calls(structure, c, word))]
    return {words: tuple(dict.fromkeys(cids)) for words, cids in found.items()}


def _calls(structure: Structure, cid: str, word: str) -> bool:
    """Whether a component's type, too, is what another is named ("the car")."""
    return cid != "E" and getattr(structure[cid].spec, "type", "").replace("_", " ") == word  # type: ignore[index]


def _aside(clause: _Words, fact: Fact | None) -> _Part | None:
    """Where in the clause it begins to restrict what cannot be told: a word of place or cause, with what it names."""
    main = clause.first("fact", "measure")
    for part in clause.of("open", "quantity"):
        behind = [p for p in clause.parts if p.at > part.at and p.kind != "plain"]
        if part.kind == "quantity" and fact or part.kind == "open" and main and part.at > main.at and (
            behind or part.text in ("in time", "out", "away")
        ):  # fmt: skip
            return None if fact and _to_somebody(clause, part, fact) else part
    return None


def _to_somebody(clause: _Words, part: _Part, fact: Fact | None) -> bool:
    """Whether a word of place only leads on to the other party of an event that has one ("ahead of the van")."""
    behind = [p for p in clause.parts if p.at > part.at and p.kind != "plain"]
    takes = fact is not None and takes_another() & set(fact.events)
    leads = part.text in ("for", "ahead", "in front", "into", "on")
    return bool(takes and leads and behind and all(p.kind in ("name", "it", "anybody") for p in behind))


def _parties(plain: str, clause: _Words, main: _Part | None) -> tuple[Party, Party]:
    """Who does it, and to whom; turned round where it is told in the passive."""
    at = main.at if main else len(plain)
    before, behind = [p for p in clause.parts if p.at < at], [p for p in clause.parts if p.at > at]
    subject, object_ = _party(before), _party(behind, subject=bool(_party(before)))
    being = re.match(r"(?:is|are|was|were|has|have)\b", plain) and not re.search(r"\bthere\b", plain)
    verb = plain[at:].split(" ", 1)[0]
    if main and main.kind == "fact" and being and not verb.endswith("ing") and set(main.value.events) & takes_another():
        return object_ or Party(how="any"), subject
    return subject, object_


def _party(parts: Iterable[_Part], subject: bool = True) -> Party:
    parts = list(parts)
    cids = tuple(dict.fromkeys(cid for p in parts if p.kind == "name" for cid in p.value))
    several = [p for p in parts if p.kind == "name"]
    others = any(p.text in ("else", "other", "others", "another") for p in parts)
    if cids:
        everybody = len(several) > 1 or any(p.kind == "everybody" for p in parts)
        return Party(cids, "all" if everybody else "")
    if any(p.kind == "everybody" for p in parts):
        return Party(how="all", others=others)
    if any(p.kind == "anybody" for p in parts):
        return Party(how="any", others=others)
    if subject and any(p.kind == "it" for p in parts):
        return Party(("E",))
    return Party(how="any") if any(p.kind == "them" for p in parts) else Party()
