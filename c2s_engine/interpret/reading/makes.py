"""Makes and models that stand for a vehicle: "a black BMW", "a Jaguar I-Pace"."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.motions import verb_lemmas

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


RIDES = re.compile(
    r"\b(?:(?:rid(?:e|es|ing|den)|rode|astride)|(?:was|am|is|were|out|sat|sitting|got|'m|'s) on)"
    r" (?:my|his|her|their|our|an?|the) (?:[\w-]+ )?$"
)


def ridden(plain: str, start: int, kind: str) -> str:
    """The type of a make at that place: a motorcycle where somebody rides it ("riding my Honda")."""
    return "motorcycle" if kind == "car" and RIDES.search(plain[max(0, start - 40) : start]) else kind
