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
        if re.search(r"\b(?:ego[- ]?|same (?:[\w-]+ ){0,2})\Z", text[: match.start()], re.IGNORECASE):
            continue  # "the same car as ego"
        found += [(match.start("noun"), match.start("noun"), "ego "), (match.start("tag"), match.end("tag"), "")]
    if found:
        return found
    for name in ("before", "said", "equal"):
        for match in _patterns()[name].finditer(text):
            if (cast := _cast(text, match, name)) is not None:
                return cast
    return []


def _cast(text: str, match: re.Match[str], name: str) -> list[Replacement] | None:
    """What is read instead of a sentence or phrase that casts a vehicle; None where it says who ego is by itself."""
    start, end = match.span("all")
    start -= len(text[:start]) - len(text[:start].rstrip(", "))
    opened = text[:start].rstrip()[-1:]
    noun, look = match["noun"], match["look"]
    named = re.compile(rf"\b(?:the |an? )?{re.escape(look)}(?P<noun>{re.escape(noun)})\b(?! ego)", re.IGNORECASE)
    first = named.search(text[:start])
    if first is not None:
        if re.search(r"\bego[- ]?\Z", text[: first.start("noun")], re.IGNORECASE):
            return None
        rest = "" if opened in (".", "", ";", ":") or text[end - 1] not in ".;" else text[end - 1]
        called = f"the {look}ego {first['noun']}" if first.start("noun") else f"Ego {first['noun']}"
        return [(*first.span(), called), (start, end, rest)]
    where = (match["where"] if name == "said" else "").strip()
    if name == "equal" and not re.search(r"=", match["all"]):
        return None
    after = "" if name == "said" and text[end : end + 1] == "," else "."
    said = f"The {look}ego {noun} {f'is {where}' if where else 'drives'}{after}"
    lead = " " if start < match.start("all") and opened else ""
    return [(start, end, f"{lead}{said}")]
