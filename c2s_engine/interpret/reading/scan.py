"""First stage: the spans that mean one thing as a whole: names, road users, things.

Every offset is one of the text that is read. The normalised text has the same length, so that spans need no mapping."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.makes import MAKE, ridden, stands_for_a_vehicle
from c2s_engine.interpret.reading.narrators import asked
from c2s_engine.interpret.reading.parties import short_labels
from c2s_engine.interpret.spans import Span

__all__ = ["Span"]

SAME = str.maketrans(
    "\u2018\u2019\u201b\u2032\u201c\u201d\u00a0\u2010\u2011\u2012\u2013\u2014\u2015\u2212\u202f\t",
    "''''\"\"" + " " + "------- " + " ",
)


def normalised(text: str) -> str:
    """The text in lower case with plain quotes, dashes and blanks, of the same length."""
    plain = text.translate(SAME)
    return "".join(c.lower() if len(c.lower()) == 1 else c for c in plain)


@cache
def _ego() -> re.Pattern[str]:
    return re.compile(rf"(?<![\w-])(?:{'|'.join(language.table('ego')['strong'])})(?![\w-])")


@cache
def _label() -> re.Pattern[str]:
    labels = language.table("ego")["labels"]
    words = "|".join(sorted([*labels["words"], *labels["typed"]], key=len, reverse=True))
    return re.compile(
        rf"(?<![\w-])(?P<word>{words})(?:(?:\s|-)?(?:no\.?|number|#)?\s?#?\s?)(?P<id>0?[1-9]|one"
        rf"|two|three|four|five|[a-e])(?![\w/%-]|\.\d|\s?(?:st|nd|rd|th|km|m|mph|ft|s)\b)"
    )


@cache
def _letter() -> re.Pattern[str]:
    return re.compile(
        r"(?<![\w-])(?:the )?(?P<word>lv|pov|fv|tv|gvt|vt|bv|ov|nv|sov|evt(?! ?#?\d\d)|pv|ltv|civ|cov)"
        r"(?P<id>[1-9]?)(?![\w-])"
    )


@cache
def _actor() -> re.Pattern[str]:
    nouns = language.alternatives(list(language.actor_nouns()))
    role = language.alternatives(list(language.roles()))
    return re.compile(
        rf"(?<![\w-])(?P<roles>(?:(?:{role})[\s-]+)*)(?:(?:dummy|mock-?up|inflatable)[\s-]+)?(?P<noun>{nouns})"
        r"(?:[\s-]+(?:target|dummy|surrogate))?(?![\w]|-(?!(?:and|or)\b)\w)"
    )


SHORT = ("v", "u", "d", "mv", "op", "opr", "tu", "ap")
NUMBERS = ("one", "two", "three", "four", "five")
LABEL_NUMBERS = {n: str(i) for names in (NUMBERS, "abcde") for i, n in enumerate(names, 1)}


def names(text: str, cased: list[Span] | None = None) -> list[Span]:
    """Names of ego, labels of vehicles (V2, Unit 2), road users and things, without overlaps; with the letters
    and people that the text's own case gave, where it was looked at."""
    found: list[Span] = list(cased or ())
    lettered = [(s.start, s.end) for s in found if s.kind == "label"]
    asking = asked(text)
    found += [
        Span("ego", match.start(), match.end())
        for match in _ego().finditer(text)
        if (match[0] != "i" or not any(s <= match.start() < e for s, e in asking))
    ]
    for match in _letter().finditer(text):
        role = "following" if match["word"] == "fv" else "lead" if match["word"] == "lv" else ""
        found.append(
            Span(
                "actor",
                match.start(),
                match.end(),
                {
                    "type": "vehicle",
                    "plural": False,
                    "noun": "",
                    "label": match[0].removeprefix("the "),
                    "roles": [role] if role else [],
                },
            )
        )
    for match in _label().finditer(text):
        if any(s < match.end() and match.start() < e for s, e in lettered):
            continue
        word, number = match["word"], match["id"]
        bare = text[match.end("word") : match.start("id")]
        if number in ("one", "two", "three", "four", "five") and not re.match(r"[\s-]", bare):
            continue  # "done"
        if number in "abcde" and (word in (*SHORT, "driver") or not re.match(r"[\s-]", bare)):
            continue
        typed = word in language.table("ego")["labels"]["typed"]
        if typed and number.isalpha():
            continue
        if number == "a" and not typed:
            continue
        if (
            word in ("car", "driver", "vehicle")
            and number in ("one", "two", "three", "four", "five")
            and re.match(r"\s+(?:lane|second|third|of|lanes|car)", text[match.end() : match.end() + 12])
        ):
            continue
        found.append(
            Span(
                "label",
                match.start(),
                match.end(),
                {"label": f"{word} {number}" if typed else LABEL_NUMBERS.get(number, number.lstrip("0")), "word": word},
            )
        )
    found += short_labels(text)
    found += _numbered(text, found)
    taken = [(s.start, s.end) for s in found]
    tables = language.table("actors")
    queues = tables["queues"]
    for match in _actor().finditer(text):
        start, end = match.span()
        if any(s < end and start < e for s, e in taken):
            continue
        made = match["noun"] in language.makes()
        noun = match["noun"] if made else re.sub(r"[\s-]+", " ", match["noun"])
        if (
            noun in ("lead", "leader", "package")
            and text[max(0, start - 12) : start].strip().split(" ")[-1] in tables["leads"]
        ):
            continue
        if noun in tables["with_animals"]:
            continue
        if noun == "pick up" and text[max(0, start - 3) : start] == "to ":
            continue
        if noun in tables["verbs_too"] and any(s.end == start - 1 and s.kind != "quantity" for s in found):
            continue
        if noun in language.makes() and not stands_for_a_vehicle(text, start, end):
            continue
        if noun == "cab" and re.search(r"(?:\b(?:his|her|its|their)|'s)\s+$", text[max(0, start - 8) : start]):
            continue
        if noun in ("couple", "flock", "herd", "family", "group", "wall") and re.match(r"\s+of\s", text[end : end + 4]):
            continue
        if (
            noun in queues
            and re.match(r"\s+of\s", text[end : end + 4])
            or noun == "bus"
            and _BUS_STOP.match(text[end : end + 16])
        ):
            continue
        make = MAKE.search(text[max(0, start - 20) : start]) if noun in language.makes() else None
        if make and make["make"] in language.makes() and not match["roles"]:
            start -= len(make[0])  # "a Honda Civic"
        kind, plural, person = _noun(noun)
        kind = ridden(text, start, kind) if made else kind
        plural = plural or noun in tables["invariant"] and _several(text, match.start(), end)
        words = re.split(r"[\s]+", match["roles"].strip()) if match["roles"].strip() else []
        known = language.roles()
        found.append(
            Span(
                "actor",
                start,
                end,
                {
                    "type": kind,
                    "plural": plural,
                    "person": person,
                    "noun": noun,
                    "roles": [known[w] for w in _role_words(match["roles"])]
                    + _nominal(noun)
                    + ["stationary"] * (noun in queues),
                    "words": words,
                    "make": make["make"] if make else "",
                },
            )
        )
    found.sort(key=lambda s: (s.start, -s.end))
    kept: list[Span] = []
    for span in found:
        if kept and span.start < kept[-1].end:
            continue
        kept.append(span)
    return kept


def _several(text: str, start: int, end: int) -> bool:
    """Whether a number before or a plural verb after such a noun tells that there are several."""
    counts = "|".join(c for c in language.table("actors")["counts"] if c not in ("one",))
    before = re.search(rf"\b(?:{counts}|[2-9]|[1-9]\d)(?: of)?(?: \w+){{0,2}}\s*$", text[max(0, start - 28) : start])
    after = re.match(
        r"\s+(?:are|were|have|stand|cross|graze|run|walk|block|wander|come|lie|appear|jump|leap)\b", text[end:]
    )
    return bool(before or after)


def _numbered(text: str, found: list[Span]) -> list[Span]:
    """The vehicle by whose number a log begins ("Coach 417, route 9", "unit 7: deer ahead"): that is ego."""
    labels = [s for s in found if s.kind == "label"]
    named = {text[s.start : s.end] for s in found if s.kind == "ego"}
    if named - {"i"} or len({s.data["label"] for s in labels}) > 1:
        return []
    match = _number_of_fleet().search(text[:80])
    if match is None or any(s.data["label"] in ("1", "2") for s in labels):
        return []
    for span in labels:
        if span.start < match.end("name"):
            found.remove(span)
    name = re.escape(match["name"]).replace(r"\ ", r"\s+")
    return [Span("ego", m.start(), m.end()) for m in re.finditer(rf"(?<![\w-]){name}(?![\w-])", text)]


def of_fleets(text: str, names: list[Span]) -> list[Span]:
    """The names of ego by a number of a fleet, where somebody tells of it: no "van 60" that has that speed."""
    told = re.search(r"\b(?:i|me|my|our|driver|operator)\b", text) is not None
    return [n for n in names if told and n.kind == "ego" and text[n.end - 1].isdigit()]


@cache
def _number_of_fleet() -> re.Pattern[str]:
    known, fleet = language.actor_nouns().items(), language.table("actors")["fleet"]
    named = [n for n, (kind, plural, person) in known if kind in fleet and not plural and not person]
    nouns = language.alternatives(named)
    return re.compile(
        rf"(?:^|[.:,;(\n]\s*)(?P<name>(?:{nouns}|unit|vehicle|fleet vehicle) "
        rf"(?:no\.? ?|number |#)?(?:\d{{2,5}}|[3-9](?=\s*:)))"
        rf"(?=\s*(?:[,.:;()]|-|w/|(?:with|towing|pulling|hauling)\b|\b(?:on|was|is|in|at|had|has|stopped|travel\w+|driv\w+|approach\w*|proceed\w*|pull\w*)\b))"
    )


_BUS_STOP = re.compile(
    r"\s+(?:lane|shelter|station|bay)\b|\s+stop(?=\s*(?:[,.;)]|$|on\b|at\b|in\b|and\b|to\b"
    r"|where\b|with\b|is\b|ahead\b|when\b|while\b|as\b|but\b|near\b|outside\b|opposite\b|behind\b|before\b|from\b|was\b|sign\b))"
)


def _noun(noun: str) -> tuple[str, bool, bool]:
    known = language.actor_nouns()
    if noun in known:
        return known[noun]
    for name, value in known.items():
        if re.sub(r"[\s-]+", "", name) == noun.replace(" ", ""):
            return value
    return ("vehicle", False, False)


def _nominal(noun: str) -> list[str]:
    return [role for role, nouns in language.table("actors")["nominal_roles"].items() if noun in nouns]


def _role_words(text: str) -> list[str]:
    known = language.roles()
    parts = text.strip()
    found = []
    while parts:
        for word in sorted(known, key=len, reverse=True):
            match = re.match(re.escape(word).replace(r"\-", r"[\s-]?") + r"(?![a-z])[\s-]*", parts)
            if match:
                found.append(word)
                parts = parts[match.end() :]
                break
        else:
            break
    return found
