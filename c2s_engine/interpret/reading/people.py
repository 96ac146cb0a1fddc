"""People who are called by their names in a text's own case: "Mr Osei", "Sarah", "J. Miller", then "Miller"."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.scan import Span

WORD = r"[A-Z][a-z]+(?:['’-](?!s\b)[A-Z]?[a-z]+)*"
OWNS = r"(?:was |is |had been )?(?:driving|riding|steering|drove|rode|drives|rides|walking|cycling)"


@cache
def _titles() -> dict[str, str]:
    """Title -> sex."""
    return {title: sex for sex, titles in language.table("people")["titles"].items() for title in titles}


@cache
def _firsts() -> dict[str, str]:
    """First name -> sex; none for names of both."""
    named = language.table("people")["names"]
    both = set(named["m"]) & set(named["f"])
    return {name: "" if name in both else sex for sex, names in named.items() for name in names}


@cache
def _titled() -> re.Pattern[str]:
    titles = "|".join(_titles())
    return re.compile(rf"(?<![\w-])(?<!near )(?P<title>(?i:{titles}))\.? (?P<name>{WORD}(?: {WORD})?)(?![\w-])")


@cache
def _first() -> re.Pattern[str]:
    names = "|".join(n.capitalize() for n in _firsts())
    return re.compile(rf"(?<![\w'’-])(?P<name>(?:{names})(?: [A-Z]\.)?(?: {WORD})?)(?![\w-])")


OWNER = re.compile(
    rf"(?<![\w'’-])(?P<name>(?:[A-Z]\. )?{WORD}(?: {WORD})?)(?=(?:, (?:aged )?\d\d,)? {OWNS} (?P<own>his|her)\b)"
)
LOWER = re.compile(r"(?<![\w-])(?P<title>mrs?|ms)\.? (?P<name>[a-z]+(?:['-](?!s\b)[a-z]+)*)(?![\w-])")
AGED = re.compile(
    r"(?<=[aneAhsT] )(?P<name>\d{1,2}[- ]year[- ]old)(?=\s*(?:[.,;:)]|$)|\s+(?:was|is|had|has|then|from|in|on|at"
    r"|who|and|but|to|could|did|drove|lost|ran|hit|made|went|came|took|rode|\w+ed)\b)"
)
"""A person who is called by his or her age: "the 34-year-old"."""


def people(text: str, plain: str) -> list[Span]:
    """The people that a text calls by their names, everywhere it does so."""
    found = [m for p in (_titled(), _first(), OWNER, LOWER) for m in p.finditer(plain if p is LOWER else text)]
    spans: list[Span] = []
    known: dict[str, str] = {}
    for match in sorted(found, key=lambda m: (m.start(), -m.end())):
        parts = [p.strip(".").lower() for p in match["name"].split()]
        if any(s.start < match.end() and match.start() < s.end for s in spans) or not _a_person(match, plain, parts):
            continue
        sex = _sex(match, parts)
        known.update(dict.fromkeys((p for p in parts if len(p) > 2), sex))
        spans.append(_span(plain, match.start(), match.end(), parts, sex))
    aged = [_span(plain, m.start(), m.end(), [m[0].replace(" ", "-")], "") for m in AGED.finditer(plain)]
    return spans + aged


def _sex(match: re.Match[str], parts: list[str]) -> str:
    """Whether a person is "m" or "f", as far as the title, the first name or "his" and "her" tell."""
    told = match.groupdict()
    if told.get("own"):
        return "f" if told["own"] == "her" else "m"
    return _titles()[told["title"].lower()] if told.get("title") else _firsts().get(parts[0], "")


def _a_person(match: re.Match[str], plain: str, parts: list[str]) -> bool:
    """Whether a match is no road user by another name ("Ford drives"), pronoun, or place ("in Martin Street")."""
    language.actor_nouns()
    if match.re is OWNER and parts[0] in ("he", "she", "who", "they", "then", "while", "when", "driver"):
        return False
    titled = bool(match.groupdict().get("title"))
    places = language.table("people")["places"]["after"]
    return not (set(parts[1:]) & set(places)) and (titled or _no_place(plain, match.start(), match.end()))


def _no_place(plain: str, start: int, end: int) -> bool:
    """Whether neither the word before nor the one after a name makes it one of a place or firm."""
    places = language.table("people")["places"]
    before = re.search(r"([\w'-]+)[.\s]+$", plain[max(0, start - 16) : start])
    after = re.match(r"\s+([\w'-]+)", plain[end : end + 20])
    if after and after[1] in places["after"]:
        return False
    return not (before and before[1] in places["before"] and plain[start - 2] != ".")


def _span(plain: str, start: int, end: int, parts: list[str], sex: str) -> Span:
    noun = plain[start:end].replace(".", "")
    return Span(
        "actor",
        start,
        end,
        {
            "type": "pedestrian", "plural": False, "person": True, "noun": noun, "roles": [], "names": parts, "sex": sex
        },
    )
