"""Who is cast as ego: "the car behind, as ego, passes", "with the van as ego", "a bus brakes. Ego = the bus.": the
vehicle is called ego where it is first named, and what only casts it is left out."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import VEHICLES
from c2s_engine.interpret.reading.rewritten import Replacement

EGO = r"(?:the )?(?:role of )?(?:the )?ego(?:[- ](?:vehicle|car|agent))?(?:[’']s role| role)?"
WHERE = (
    r"(?: (?:behind|ahead|in front|at the (?:back|rear|front)|in the (?:rear|back|middle)|waiting|coming from behind"
    r"|(?:on|from) the (?:left|right)))?"
)
ROLE = r"(?:acting |serving |playing |used |taken |cast |here |treated |chosen |seen )?as "
END = r"(?=\s*(?:[.,;:)]|$))"
NO_LOOK = (
    r"an?|the|with|of|and|or|to|in|on|at|by|is|ego|other|another|no|that|this|second|first|third"
    r"|my|our|his|her|their|its"
)
LOOK = rf"(?:(?!(?:{NO_LOOK})\b)[\w-]+ ){{0,3}}?"


@cache
def _patterns() -> dict[str, re.Pattern[str]]:
    kinds = language.actor_nouns().items()
    nouns = language.alternatives([n for n, (kind, several, rider) in kinds if kind in VEHICLES and not several])
    one = rf"\b(?P<look>{LOOK})(?P<noun>{nouns})"
    found = {
        "beside": rf"\b(?P<noun>{nouns})(?P<where>{WHERE})(?P<tag>\s*\((?:as |acting as |being |playing |= ?)?{EGO}\),?"
        rf"|(?:,? (?:{ROLE}|which is |that is )|, (?:being |playing )){EGO}(?:,|{END}))",
        "before": rf"(?:(?<=\A)|(?<=[.;:,(\n] )|(?<=[.;:(\n]))(?P<all>(?:with|take|taking|make|making|let|consider|use"
        rf"|using|having) (?:the|an?) {one} (?:{ROLE}|be(?:ing)? |play(?:ing)? ){EGO}\b\s*[:,.;]?)",
        "said": rf"(?:(?<=\A)|(?<=[.;:,(\n] )|(?<=[.;:(\n]))(?P<all>(?:and )?(?:the )?{one}(?P<where>{WHERE})"
        rf"(?: (?:is|was|being|plays|acts as|serves as|represents|shall be|should be|is to be) | ?:?= ?)"
        rf"{EGO}{END}[.;]?)",
        "equal": rf"(?:(?<=\A)|(?<=[.;:,(\n] )|(?<=[.;:(\n]))(?P<all>(?:the )?ego(?:[- ](?:vehicle|car))?"
        rf"(?: (?:is|being|shall be|should be|is to be) the | ?:?= ?(?:the |an? )?){one}{END}[.;]?)",
    }
    return {name: re.compile(pattern, re.IGNORECASE) for name, pattern in found.items()}


LESSON = re.compile(
    r"\b(?:driving (?:instructors?|lessons?|schools?|tests?|examiners?)|instructors?|examiner|learner drivers?"
    r"|your (?:pupil|student|candidate|learner|trainee))\b",
    re.IGNORECASE,
)
"""What tells that a text is about learning to drive."""
PUPIL = re.compile(
    r"\b(?:the|your) (?:pupil|student|candidate|learner|trainee)(?: driver)?(?:[’']s (?:car|vehicle)\b)?(?![’'\w-])",
    re.IGNORECASE,
)


def cast_as_ego(text: str) -> list[Replacement]:
    """The name of ego before the vehicle that is cast so, and nothing instead of what casts it; the name of ego for
    who learns to drive."""
    if LESSON.search(text):
        return [(m.start(), m.end(), "the ego vehicle") for m in PUPIL.finditer(text)]
    if not re.search(r"\bego\b", text, re.IGNORECASE):
        return []
    found: list[Replacement] = []
    for match in _patterns()["beside"].finditer(text):
        found += [(match.start("noun"), match.start("noun"), "ego "), (match.start("tag"), match.end("tag"), "")]
    if found:
        return found
    return []
