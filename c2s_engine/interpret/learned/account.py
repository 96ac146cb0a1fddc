"""What in the text each field of S rests on, and what of the text S does not have.

By words and numbers: a word is a component's where that says it (its type's nouns, its actions' verbs, the words of its
values and sentence); one that several could have said is of the one that has most of its clause. What the model says
that it left out, quantities that no field has, vehicles and animals that nobody of S is, and clauses of which no
component has a word, are not understood.
"""

import math
import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cache
from typing import Any

import yaml

from c2s_engine import paths
from c2s_engine.interpret import language
from c2s_engine.interpret.learned.units import quantities
from c2s_engine.interpret.mentions import Mention, mentions, names_ego
from c2s_engine.interpret.parser import parser
from c2s_engine.interpret.settings import Settings
from c2s_engine.interpret.text import normalised
from c2s_engine.structure.account import UNSAID, covering, meets
from c2s_engine.structure.components import Component, Link, Structure, Unmet
from c2s_engine.structure.objects import object_types, types
from c2s_engine.structure.sentences import sentence
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.structure.stems import stem, stems
from c2s_engine.structure.vocabulary import VEHICLES

Span = tuple[int, int]
Number = tuple[str, str, float]
"""Of a component: its id, the path, the SI value."""
NO_VALUE = "no field of S has the value {}"
NO_OBJECT = "no object of S is one"
NO_FIELD = "no field of S says that there is one"
WHEELED = frozenset({*VEHICLES, "animal", "vehicle"} - {"bicycle"})
"""What a noun names that has to be somebody of S: who is on foot or rides is also a driver, an owner, a passer-by."""
KIN = {"pickup": "truck", "van": "bus truck car", "truck": "van car", "bus": "van", "car": "van"}
"""By the type that a noun means, those that it may be called as well."""
_WORD = re.compile(r"[a-z]{2,}")
_SHARE = {"type": 2.0, "": 0.5}
"""What a word weighs for whom its clause is about, by the field that says it; others 1."""

LAST, STILL = 0.3, 1.5
"""The same for whoever was spoken of last; where the clause itself names nobody ("which brakes")."""


def accounted(structure: Structure, settings: Settings, left_out: Sequence[str] = ()) -> Structure:
    """S with its links, its background and what of its text was not understood; `left_out`: phrases of the text that
    the model said to be in no component."""
    text, plain = structure.text, normalised(structure.text)
    terms = {c.id: said_words(c, structure) for c in structure.components}
    nouns, numbers = mentions(text), numbers_of(structure)
    links: dict[str, list[Link]] = defaultdict(list)
    for cid, field, found in settings.found():
        links[cid].append(_link(text, found.span, field))
    missed = [*_phrases(structure, left_out), *_values(structure, numbers), *_absent(structure, nouns)]
    missed += [u for u in _things(structure) if not meets(u.span, *(m.span for m in missed if m.span))]  # type: ignore
    background: list[Unmet] = []
    last = "R"
    for clause in covering(text):
        own, about_whom = _of_clause(structure, plain, clause, terms, nouns, numbers, last)
        for cid, field, span in own:
            links[cid].append(_link(text, span, field))
        about = meets(clause, *(li.span for found in links.values() for li in found if li.span and li.field))
        named = any(meets((n.start, n.end), clause) for n in nouns)
        if not about and (reason := _topic(plain[slice(*clause)], named)):
            background.append(Unmet(text=text[slice(*clause)], reason=reason, span=clause))
        elif own:
            last = about_whom
        elif not about and meets(clause, *(u.span for u in missed if u.span)):
            continue
        elif not about and _content(plain[slice(*clause)]):
            missed.append(Unmet(text=text[slice(*clause)], reason=UNSAID, span=clause))
        elif not about:  # it goes on about whoever was spoken of
            links[last].append(_link(text, clause))
    for component in structure.components:
        own_links = sorted(dict.fromkeys(links[component.id]), key=lambda li: li.span or (0, 0))
        structure = structure.with_component(component.model_copy(update={"links": (*component.links, *own_links)}))
    update = {"background": tuple(background), "not_understood": (*structure.not_understood, *missed)}
    structure = structure.model_copy(update=update)
    return structure.model_copy(update={"unread": tuple(_unread(structure, plain, terms, nouns))})


def _of_clause(
    structure: Structure, plain: str, clause: Span, terms: Mapping[str, Mapping[str, str]], nouns: Sequence[Mention],
    numbers: Sequence[Number], last: str,
) -> tuple[list[tuple[str, str, Span]], str]:
    """The words of a clause that components say: whose, of which field, where; and whom it is about. `last`: who was
    spoken of before."""
    could: list[tuple[Span, dict[str, str]]] = []
    for noun in (n for n in nouns if clause[0] <= n.start < clause[1]):
        fitting = {c.id: "type" for c in structure.objects if isinstance(c.spec, ObjectSpec) and noun.fits(c.spec.type)}
        could.append(((noun.start, noun.end), fitting))
    names = any(fields for _, fields in could) or names_ego(plain[slice(*clause)])
    amounts = [((clause[0] + a, clause[0] + b), v, unit) for (a, b), v, unit in quantities(plain[slice(*clause)])]
    taken = [*(span for span, _ in could), *(span for span, _, _ in amounts)]
    for match in _WORD.finditer(plain, *clause):
        word = match[0]
        if word in _small() or meets(match.span(), *taken):
            continue
        could.append((match.span(), {cid: said[stem(word)] for cid, said in terms.items() if stem(word) in said}))
    for span, value, _ in amounts:
        could.append((span, {cid: _whole(path) for cid, path, held in numbers if same(held, value)}))
    weight: dict[str, float] = defaultdict(float, {last: LAST if names else STILL})
    for _, whose in could:
        for cid, field in whose.items():
            weight[cid] += _SHARE.get(field, 1.0) / len(whose)
    order = structure.ids
    best = [(span, max(whose, key=lambda c: (weight[c], -order.index(c))), whose) for span, whose in could if whose]
    about = max(weight, key=lambda c: (weight[c], -order.index(c)))
    own = sorted((cid, whose[cid], span) for span, cid, whose in best if whose[cid] or cid == about)
    return own, about


def _unread(
    structure: Structure, plain: str, terms: Mapping[str, Mapping[str, str]], nouns: Sequence[Mention]
) -> Iterator[Span]:
    """The nouns, verbs and words that describe on which no field rests and which no component says."""
    lost = (u.span for u in (*structure.not_understood, *structure.background) if u.span)
    rests = (li.span for c in structure.components for li in c.links if li.span and li.field)
    taken = [*lost, *rests, *((n.start, n.end) for n in nouns)]
    trade = language.table("trade")
    said = {word for own in terms.values() for word in own} | words_of_fields(structure)
    said |= set(map(stem, (*trade["again"], *trade["ego"])))
    for token in parser()(plain):
        span = token.idx, token.idx + len(token)
        tells = token.pos_ in ("NOUN", "VERB", "ADJ", "ADV") and token.is_alpha and token.lower_ not in _small()
        tells |= token.lower_ in trade["directions"]
        if tells and stem(token.lower_) not in said and not meets(span, *taken):
            yield span


def said_words(component: Component, structure: Structure) -> dict[str, str]:
    """The stems by which a component is spoken of, each with the field that says it; "": its sentence does."""
    return dict(_terms(component, structure))


def _terms(component: Component, structure: Structure) -> Iterator[tuple[str, str]]:
    """The same one by one: later ones count."""
    egos = frozenset(language.table("trade")["ego"])
    for found in stems(sentence(component, structure)) - _small_stems() - egos:
        yield found, ""
    if component.id == "E":
        yield from ((word, "") for word in egos)
    for path, value in values_of(component.spec.model_dump(exclude_defaults=True, exclude={"component", "name"})):
        if value is True:
            yield stem(path.split(".")[-1]), _whole(path)
        if isinstance(value, str) and not re.fullmatch(r"O\d+|ego", value):
            field = _whole(path)
            yield from ((word, field) for word in stems(f"{value} {value.removesuffix('most')}") - _small_stems())
            words = language.table("trade")["values"].get(re.split(r"\.(?!\d)", path)[-1], {}).get(value, ())
            yield from ((stem(word), field) for word in words)
            if path.endswith((".action", "reaction")):
                yield from ((word, field) for word in _verbs().get(value, ()))


def values_of(value: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """(path, value) of the single values in plain data."""
    if isinstance(value, dict | list | tuple):
        items = value.items() if isinstance(value, dict) else enumerate(value)
        for name, inner in items:
            yield from values_of(inner, f"{path}.{name}".lstrip("."))
    else:
        yield path, value


def numbers_of(structure: Structure) -> list[Number]:
    """The numbers that components hold: whose, by which path."""
    return [(c.id, path, float(held)) for c in structure.components
            for path, held in values_of(c.spec.model_dump(exclude_defaults=True))
            if isinstance(held, int | float) and not isinstance(held, bool)]  # fmt: skip


def _whole(path: str) -> str:
    """The field to which a value belongs: the phase that it is in, the list that it is of."""
    return ".".join(path.split(".")[:2]) if path.startswith("phases") else re.sub(r"\.\d+$", "", path)


def same(held: float, value: float) -> bool:
    """Whether a number that S holds is one of the text, which is rounded."""
    return math.isclose(held, value, rel_tol=0.02, abs_tol=0.06)


def _values(structure: Structure, numbers: Sequence[Number]) -> Iterator[Unmet]:
    """The quantities of the text that no field of S has; times also as the way that is driven in them."""
    speeds = [held for _, path, held in numbers if path.split(".")[0] == "speed"]
    for span, value, unit in quantities(structure.text):
        ways = [value * speed for speed in speeds] if unit == "s" else []
        if not any(same(held, v) for _, _, held in numbers for v in (value, *ways)):
            words = structure.text[slice(*span)]
            yield Unmet(text=words, reason=NO_VALUE.format(words), span=span)


def _absent(structure: Structure, nouns: Sequence[Mention]) -> Iterator[Unmet]:
    """The vehicles and animals that the text names and that nobody of S can be; ego is never several."""
    several = [n for n in nouns if _plural(structure.text[n.start : n.end].lower())]
    one = absent([n for n in nouns if n not in several], types(structure))
    for span in sorted((*one, *absent(several, object_types(structure)))):
        yield Unmet(text=structure.text[slice(*span)], reason=NO_OBJECT, span=span)


def _plural(noun: str) -> bool:
    return noun.endswith("s") and noun[:-1] in language.actor_nouns()


def absent(
    nouns: Iterable[Mention], there: Collection[str], kinds: Collection[str] = WHEELED
) -> Iterator[Span]:
    """Where vehicles and animals, or others of such `kinds`, are named that nobody of the types that are there can
    be."""
    for noun in nouns:
        known = any(noun.fits(kind) for kind in there) or set(there) & set(KIN.get(noun.type, "").split())
        if noun.type in kinds and not known:
            yield noun.start, noun.end


def _things(structure: Structure) -> Iterator[Unmet]:
    """The signs, lights and places that the text names, not as what there is none of, and S does not have."""
    plain = normalised(structure.text)
    held = {(path.rsplit(".", 1)[-1], value) for c in structure.components
            for path, value in values_of(c.spec.model_dump(mode="json", exclude_defaults=True))
            if isinstance(value, str | int)}  # fmt: skip
    for row in language.table("trade")["things"]:
        if any((name, value) in held for name, values in row["fields"].items() for value in values):
            continue
        for match in re.finditer(rf"(?<![\w-])(?:{language.alternatives(row['words'])})(?![\w-])", plain):
            if not re.search(r"\b(?:no|not|without)\W+(?:\w+\W+){0,2}$", plain[: match.start()]):
                yield Unmet(text=structure.text[slice(*match.span())], reason=NO_FIELD, span=match.span())


def _phrases(structure: Structure, left_out: Sequence[str]) -> Iterator[Unmet]:
    """What was said to be left out, but for what S does say."""
    numbers, said = numbers_of(structure), words_of_fields(structure) if left_out else frozenset()
    for phrase in left_out:
        found = re.search(r"\s+".join(map(re.escape, phrase.split())), structure.text, re.IGNORECASE)
        if found and not is_said(phrase, numbers, said):
            yield Unmet(text=found[0], reason=UNSAID, span=found.span())


def words_of_fields(structure: Structure) -> frozenset[str]:
    """The stems of the words that fields of S say, and of those for the fields that hold a number."""
    said = {word for c in structure.components for word, field in said_words(c, structure).items() if field}
    for name in {path.rsplit(".", 1)[-1] for _, path, _ in numbers_of(structure)}:
        said |= {stem(word) for word in (name, *language.table("trade")["fields"].get(name, ()))}
    return frozenset(said)


def is_said(phrase: str, numbers: Sequence[Number], said: Collection[str]) -> bool:
    """Whether fields of S, by their numbers and words, have every word and every amount of a phrase."""
    plain = normalised(phrase)
    amounts = quantities(plain)
    if not all(any(same(held, value) for _, _, held in numbers) for _, value, _ in amounts):
        return False
    for (start, end), _, _ in reversed(amounts):
        plain = plain[:start] + " " + plain[end:]
    own = {stem(word) for word in _WORD.findall(plain)} - _small_stems()
    return bool(own or amounts) and own <= set(said)


def _topic(clause: str, named: bool) -> str:
    """Why a clause is background by what it is about; empty where it is about nothing of the kind. `named`: whether it
    names somebody."""
    said = set(_WORD.findall(clause))
    said |= {stem(word) for word in said}
    for topic in language.table("background").values():
        if said & set(topic["words"]) or not named and said & set(topic["about"]):
            return str(topic["reason"])
    return ""


def _content(clause: str) -> bool:
    return any(word not in _small() for word in _WORD.findall(clause))


@cache
def _small() -> frozenset[str]:
    """Words that are nobody's."""
    return frozenset(parser().Defaults.stop_words) - frozenset(language.table("trade")["ego"])


@cache
def _small_stems() -> frozenset[str]:
    return frozenset(map(stem, _small()))


@cache
def _verbs() -> dict[str, frozenset[str]]:
    """The stems of the verbs that say an action, by the events that show it (data/vocabulary.yaml, data/asked.yaml)."""
    shows = yaml.safe_load(paths.shipped("vocabulary.yaml").read_text(encoding="utf-8"))["actions"]
    facts = yaml.safe_load(paths.shipped("asked.yaml").read_text(encoding="utf-8"))["facts"]
    more = language.table("trade")["verbs"]
    said = {name: {w for f in facts if set(f["events"]) & set(row["shows"]) for w in f["words"]}
            for name, row in shows.items()}  # fmt: skip
    every = {*said, *more}
    return {name: frozenset(stem(w.split()[0]) for w in (*said.get(name, ()), *more.get(name, ()))) for name in every}


def _link(text: str, span: Span, field: str = "") -> Link:
    return Link(kind="text", label=text[slice(*span)], span=span, field=field)
