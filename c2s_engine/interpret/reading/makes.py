"""Makes and models that stand for a vehicle: "a black BMW", "a Jaguar I-Pace"."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.motions import verb_lemmas
from c2s_engine.interpret.spans import Span

MAKE = re.compile(r"(?<![\w-])(?!an |the |my )(?P<make>[a-z]{2,}(?:-[a-z]+)?)[ -]$")
DOES = re.compile(r"\b(?:i|we|you|they|to|and|then|must|should|will|can) $")
"""Before a verb."""


def stands_for_a_vehicle(text: str, start: int, end: int) -> bool:
    """Whether a make or model is the noun itself: "a black BMW" or "a 2019 Honda Civic", not "the Ford pickup"."""
    before, after = text[max(0, start - 36) : start], text[end : end + 40]
    if (state := _state().search(before)) is not None:  # "a disabled Honda CR-V"
        before = before[: state.start()] + before[state.end() :]
    if text[start:end] in verb_lemmas() and DOES.search(before):
        return False  # "we dodge it"
    model = re.match(r"[\s-]+([\w-]+)", after)
    noun = re.match(r"[\s-]+(?:(?P<kind>[\w-]+)\s+)?(?:" + _noun_words() + r")\b", after)
    if model and model[1] in language.makes() or noun:
        return False
    named = re.search(
        (
            r"(?:\b(?:an?|the|his|her|their|my|our|your|another|this|that|white|black|red|blue|silver|grey|gray|green"
            r"|yellow|dark|old|new)|\d{4}|'s|s'|^|[.,:;(])\s*(?:[\w-]+\s+)?$"
        ),
        before,
    )
    return bool(named)


@cache
def _state() -> re.Pattern[str]:
    told = language.alternatives([*language.words("stands"), *language.roles(), "disabled"])
    return re.compile(rf"(?<=\b[an] )(?:{told})\s+|(?<=\ban )(?:{told})\s+|(?<=\bthe )(?:{told})\s+")


@cache
def _noun_words() -> str:
    return language.alternatives([n for n in language.actor_nouns() if n not in language.makes()])


@cache
def _with_model() -> re.Pattern[str]:
    makes = language.alternatives(list(language.makes()))
    return re.compile(
        rf"(?<![\w-])(?P<make>(?i:{makes})) (?P<model>[A-Z0-9][\w-]*(?: (?:[A-Z]{{1,3}}\d*|\d+\w*))?)(?![\w-])"
    )


def models(text: str, plain: str) -> list[Span]:
    """Makes with a model that no table knows, by the text's own case: "a Jaguar I-Pace", "the Kia EV6"."""
    found = []
    for match in _with_model().finditer(text):
        make, model = match["make"].lower(), match["model"].lower()
        if stands_for_a_vehicle(plain, match.start(), match.end()):
            found += _by_model(text, match.end(), make, match["model"])
        known = model in language.actor_nouns() or model in NO_MODEL
        if known or not stands_for_a_vehicle(plain, match.start(), match.end()):
            continue
        nouns = language.actor_nouns()
        kind = ridden(plain, match.start(), nouns.get(f"{make} {model}", nouns[make])[0])
        data = {"type": kind, "plural": False, "person": False, "noun": make, "roles": [], "words": [], "make": make}
        found.append(Span("actor", match.start(), match.end(), data))
    return found


def _by_model(text: str, start: int, make: str, model: str) -> list[Span]:
    """Where a vehicle is then called by its model alone, which no table knows: "a Ford Ranger ... the Ranger"."""
    nouns = language.actor_nouns()
    if len(model) < 3 or not model[0].isupper() or model.lower() in nouns:
        return []
    kind = nouns.get(f"{make} {model.lower()}", nouns[make])[0]
    data = {"type": kind, "plural": False, "person": False, "noun": make, "roles": [], "words": [], "make": make}
    later = re.compile(
        rf"\b(?:[Tt]he|[Tt]his|[Tt]hat|[Hh]is|[Hh]er|'s|’s)(?: \w+)? (?P<model>{re.escape(model)})(?![\w-])"
    )
    return [Span("actor", m.start("model"), m.end("model"), dict(data)) for m in later.finditer(text, start)]


RIDES = re.compile(
    r"\b(?:(?:rid(?:e|es|ing|den)|rode|astride)|(?:was|am|is|were|out|sat|sitting|got|'m|'s) on)"
    r" (?:my|his|her|their|our|an?|the) (?:[\w-]+ )?$"
)


def ridden(plain: str, start: int, kind: str) -> str:
    """The type of a make at that place: a motorcycle where somebody rides it ("riding my Honda")."""
    return "motorcycle" if kind == "car" and RIDES.search(plain[max(0, start - 40) : start]) else kind


NO_MODEL = frozenset(("av", "ads", "i", "and", "driver"))
