"""First stage: sentences, and the spans that mean one thing as a whole (names, road users, quantities).

Every offset is one of the user's text. The normalised text has the same length, so that spans need no mapping.
"""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

import re
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from c2s_engine.interpret import language

SAME = str.maketrans(
    "\u2018\u2019\u201b\u2032\u201c\u201d\u00a0\u2010\u2011\u2012\u2013\u2014\u2015\u2212\u202f\t",
    "''''\"\"" + " " + "------- " + " ",
)


@dataclass
class Span:
    """A stretch of the text that was recognised as a whole."""

    kind: str
    start: int
    end: int
    data: dict[str, Any] = field(default_factory=dict)


def normalised(text: str) -> str:
    """The text in lower case with plain quotes, dashes and blanks, of the same length."""
    plain = text.translate(SAME)
    return "".join(c.lower() if len(c.lower()) == 1 else c for c in plain)


@cache
def _number() -> str:
    words = language.alternatives(list(language.table("units")["numbers"]))
    return rf"(?:\d+(?:[.,]\d+)?|\b(?:{words})\b)"


@cache
def _quantity() -> re.Pattern[str]:
    number = _number()
    unit = "|".join(re.escape(u).replace(r"\ ", r"\s+") for u in sorted(language.units(), key=len, reverse=True))
    return re.compile(
        rf"(?<![\w.])(?P<low>[+-]?{number})(?:\s*(?P<lowunit>{unit})(?![\w/]))?(?:\s*(?:-|to|and|\.\.\.?|or)\s*(?P<high>{number}))?"
        rf"(?:\s*|-)(?P<unit>{unit})(?![\w/²^])(?:\s+(?P<half>and a half))?"
    )


DIGITS = "zero|one|two|three|four|five|six|seven|eight|nine|niner"


@cache
def _bare() -> re.Pattern[str]:
    nouns = language.alternatives(list(language.actor_nouns()))
    number = language.alternatives([w for w, v in language.table("units")["numbers"].items() if 10 <= float(v) <= 200])
    return re.compile(
        rf"(?:(?:\(ego\)|\b)(?:{nouns}|(?:{'|'.join(language.table('ego')['strong'])})|v[12]|car ?[1-9]|(?<=\(ego\))|straight|left|right|lane|ahead|behind|doing|going|brakes? to|slows? (?:down )?to|accelerates? to)"
        rf"(?: at| drives| doing|:| speed)? (?:about |around |roughly |a steady |only )?)(?<!lane )(?P<low>\d{{2,3}}|(?:{number})\b)(?=\s*(?:[,.;)]|$|straight\b|and\b|in the\b|same\b|left\b|right\b|but\b|on the\b|behind\b|ahead\b|in (?:left|right)\b))"
        rf"|\b(?:ego|lead|lv|sv|vut|target) (?P<head>\d{{2,3}})(?= (?!(?:m|s|sec\w*|min\w*|hours?|years?|people|cars|vehicles|trucks|km|ft|feet|degrees|percent|to|of|lanes?|am|pm)\b)[a-z])"
        rf"|\b(?:(?:north|south|east|west)bound|driv\w+|travel\w*|going|cruis\w+|moving|sit\w*|approach\w*|arriv\w+|rid\w+|coming|runs?)(?: [a-z][\w'-]*){{0,3}} at (?:about |around |roughly |a steady )?(?P<at>[1-9]\d?[05]|(?:{number}))(?=\s*(?:[,.;)]|$|and\b|when\b|in\b|on\b|because\b|as\b|while\b|with\b))"
        rf"|\b(?:{nouns}|ego|lead|v[12]) \((?P<bracket>\d{{2,3}})(?=[,)])"
        rf"|(?:speed|doing|going|at) (?:of )?(?P<spelt>(?:{DIGITS}) (?:{DIGITS})(?: (?:{DIGITS}))?)(?=\s*(?:[,.;)]|$|and\b|in\b|on\b))"
        rf"|\bthe speed (?P<plain>\d{{2,3}})\b(?! ?(?:km|mph|k|m/))"
        rf"|(?<=lane )(?P<lane>\d{{2,3}})(?=\s*(?:[,.;)]|$))"
    )


def bare_speeds(text: str) -> list[Span]:
    """Numbers without a unit after a road user or its lane, in the shorthand of tests ("ego 60, lead 40"): mph where
    the text has mph anywhere, else km/h."""
    found = []
    factor = 0.44704 if re.search(r"\bmph\b|\bmiles?\b|\bfeet\b|\bfoot\b|\d ?ft\b|\byards?\b", text) else 1 / 3.6
    for match in _bare().finditer(text):
        group = next(name for name, value in match.groupdict().items() if value)
        value = _value(match[group])
        if 10 <= value <= 200:
            data = {"dimension": "speed", "low": value * factor, "high": value * factor, "bare": True}
            found.append(Span("quantity", match.start(group), match.end(group), data))
    return found


def _value(text: str) -> float:
    text = " ".join(text.split()).lstrip("+")
    words = language.table("units")["numbers"]
    digits = text.split()
    if len(digits) > 1 and all(d in DIGITS.split("|") for d in digits):
        return float("".join(str(min(9, DIGITS.split("|").index(d))) for d in digits))
    if text in words:
        return float(words[text])
    if re.fullmatch(r"-?\d{1,3},\d{3}", text):
        return float(text.replace(",", ""))
    return float(text.replace(",", "."))


def quantities(text: str) -> list[Span]:
    """Numbers with a unit, in SI; a range has `low` and `high`."""
    found = []
    for match in _quantity().finditer(text):
        dimension, factor = language.units()[" ".join(match["unit"].split())]
        if match["unit"] in ("'", "mi", "g") and not match["low"][-1:].isdigit():
            continue
        if match["unit"] == "m" and not match["low"][-1:].isdigit():
            continue
        low = _value(match["low"]) * (
            language.units()[" ".join(match["lowunit"].split())][1] if match["lowunit"] else factor
        )
        first = low
        joined = (
            re.search(r"(-|to|and|\.\.|or)\s*$", text[match.end("low") : match.start("high")])
            if match["high"]
            else None
        )
        high = _value(match["high"]) * factor if match["high"] else low
        before = text[max(0, match.start() - 30) : match.start()]
        if joined and joined[1] == "and" and "between" not in before:
            low = high
        if high < low:
            low, high = high, low
        found.append(Span("quantity", match.start(), match.end(), {"dimension": dimension, "low": low, "high": high}))
        if joined and joined[1] == "to" and re.search(r"from\s*$", before):
            second = _value(match["high"]) * factor
            found[-1].data.update({"first": first, "second": second})
    return found


@cache
def _ego() -> re.Pattern[str]:
    return re.compile(rf"(?<![\w-])(?:{'|'.join(language.table('ego')['strong'])})(?![\w-])")


@cache
def _label() -> re.Pattern[str]:
    labels = language.table("ego")["labels"]
    words = "|".join(sorted([*labels["words"], *labels["typed"]], key=len, reverse=True))
    return re.compile(
        rf"(?<![\w-])(?P<word>{words})(?:(?:\s|-)?(?:no\.?|number|#)?\s?#?\s?)(?P<id>0?[1-9]|one|two|three|four|five|[a-e])(?![\w/%-]|\.\d|\s?(?:st|nd|rd|th|km|m|mph|ft|s)\b)"
    )


@cache
def _letter() -> re.Pattern[str]:
    return re.compile(r"(?<![\w-])(?:the )?(?P<word>lv|pov|fv|tv|gvt|vt)(?P<id>[1-9]?)(?![\w-])")


@cache
def _actor() -> re.Pattern[str]:
    nouns = language.alternatives(list(language.actor_nouns()))
    role = language.alternatives(list(language.roles()))
    return re.compile(rf"(?<![\w-])(?P<roles>(?:(?:{role})[\s-]+)*)(?P<noun>{nouns})(?![\w]|-(?!(?:and|or)\b)\w)")


LABEL_NUMBERS = {"one": "1", "two": "2", "three": "3", "four": "4", "five": "5"} | dict(
    zip("abcde", "12345", strict=True)
)


def names(text: str) -> list[Span]:
    """Names of ego, labels of vehicles (V2, Unit 2), road users and things, without overlaps."""
    found: list[Span] = []
    found += [Span("ego", match.start(), match.end()) for match in _ego().finditer(text)]
    for match in _letter().finditer(text):
        role = "following" if match["word"] == "fv" else "lead" if match["word"] == "lv" else ""
        found.append(
            Span(
                "actor",
                match.start(),
                match.end(),
                {"type": "vehicle", "label": match[0].removeprefix("the "), "roles": [role] if role else []},
            )
        )
    for match in _label().finditer(text):
        word, number = match["word"], match["id"]
        bare = text[match.end("word") : match.start("id")]
        if word in ("v", "u", "d") and bare.strip(" #-"):
            continue
        if number in "abcde" and (word in ("v", "u", "d", "driver") or not re.match(r"[\s-]", bare)):
            continue
        typed = word in language.table("ego")["labels"]["typed"]
        if (
            typed
            and number.isalpha()
            and not re.match(
                r"\s*(?:$|[.,;:)(-]|(?:is|was|has|and|in|at|on|brakes|drives|turns|cuts|stops|changes|overtakes|follows)\b)",
                text[match.end() : match.end() + 12],
            )
        ):
            continue
        if (
            number == "a"
            and not typed
            and not re.match(
                r"\s*(?:$|[.,;:)(']|\w+(?:s|ed|ing)\b|is\b|was\b|did\b|has\b|had\b|and\b|in\b|at\b|on\b|from\b)",
                text[match.end() : match.end() + 20],
            )
        ):
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
    taken = [(s.start, s.end) for s in found]
    queues = language.table("actors")["queues"]
    for match in _actor().finditer(text):
        start, end = match.span()
        if any(s < end and start < e for s, e in taken):
            continue
        noun = re.sub(r"[\s-]+", " ", match["noun"])
        if noun in language.makes() and not _stands_for_a_vehicle(text, start, end):
            continue
        if noun == "cab" and re.search(r"(?:\b(?:his|her|its|their)|'s)\s+$", text[max(0, start - 8) : start]):
            continue
        if noun in ("couple", "flock", "herd", "family", "group") and re.match(r"\s+of\s", text[end : end + 4]):
            continue
        if (
            noun in queues
            and re.match(r"\s+of\s", text[end : end + 4])
            or noun == "bus"
            and _BUS_STOP.match(text[end : end + 16])
        ):
            continue
        kind, plural, person = _noun(noun)
        words = re.split(r"[\s]+", match["roles"].strip()) if match["roles"].strip() else []
        known = language.roles()
        found.append(
            Span("actor", start, end, {
                "type": kind, "plural": plural, "person": person, "noun": noun,
                "roles": [known[w] for w in _role_words(match["roles"])] + _nominal(noun) + ["stationary"] * (noun in queues), "words": words,
            })
        )  # fmt: skip
    found += _letters(text, found)
    found.sort(key=lambda s: (s.start, -s.end))
    kept: list[Span] = []
    for span in found:
        if kept and span.start < kept[-1].end:
            if span.end - span.start > kept[-1].end - kept[-1].start and span.kind != "actor":
                kept[-1] = span
            continue
        kept.append(span)
    return kept


_BUS_STOP = re.compile(
    r"\s+(?:lane|shelter|station|bay)\b|\s+stop(?=\s*(?:[,.;)]|$|on\b|at\b|in\b|and\b|to\b|where\b|with\b|is\b|ahead\b))"
)


def _stands_for_a_vehicle(text: str, start: int, end: int) -> bool:
    """Whether a make or model is the noun itself: "a black BMW" or "a 2019 Honda Civic", not "the Ford pickup"."""
    before, after = text[max(0, start - 24) : start], text[end : end + 40]
    if re.match(r"[\s-]+(?:[\w-]+\s+)?(?:" + _noun_words() + r")\b", after):
        return False
    named = re.search(
        r"(?:\b(?:an?|the|his|her|their|my|another|white|black|red|blue|silver|grey|gray|green|yellow|dark|old|new)|\d{4}|^|[.,:;(])\s*(?:[\w-]+\s+)?$",
        before,
    )
    return bool(named)


@cache
def _noun_words() -> str:
    return language.alternatives([n for n in language.actor_nouns() if n not in language.makes()])


def _letters(text: str, found: list[Span]) -> list[Span]:
    """Bare letters that stand for vehicles called by them elsewhere: "car A follows car B; B brakes"."""
    named = {s.data["label"]: s for s in found if s.kind == "label" and re.search(r"[a-e]$", text[s.start : s.end])}
    letters = {text[s.end - 1]: n for n, s in named.items()}
    spans = []
    for letter, number in letters.items():
        verb = (
            r"(?=\s+(?!car\b|truck\b|bus\b|van\b)\w+(?:s|ed)\b|\s+(?:is|was|has|cannot|must|then)\b)"
            if letter == "a"
            else r"(?![\w'-]*\.\w)"
        )
        spans += [
            Span("label", match.start(), match.end(), {"label": number, "word": "letter"})
            for match in re.finditer(rf"(?<![\w-]){letter}(?![\w-]){verb}", text)
            if not any(s.start <= match.start() < s.end for s in found)
        ]
    return spans


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


ABBREVIATION = re.compile(
    r"(?:\b(?:e\.g|i\.e|approx|ca|vs|no|st|ave|rd|dr|mr|mrs|min|max|fig|sec|incl|etc|resp|veh)|\b[a-z])\.$"
)


def sentences(text: str) -> list[tuple[int, int]]:
    """The sentences' spans: at full stops, question marks, semicolons, line ends of lists, and blank lines."""
    found: list[tuple[int, int]] = []
    start = 0
    for match in re.finditer(r"[.!?]+[\"')\]]*(?=\s|$)|;|\n\s*(?=\n|[-*•]|\d+[.)]\s)|\n+", text):
        before = text[start : match.end()].rstrip()
        if match[0].startswith(".") and ABBREVIATION.search(before.lower()):
            rest = text[match.end() :].lstrip()
            if not re.match(r"[A-Z]", rest) or re.search(r"\b(?:e\.g|i\.e|approx|vs|no|veh)\.$", before.lower()):
                continue
        if match[0].startswith("\n") and "\n\n" not in text[match.start() : match.end() + 1]:
            rest = text[match.end() :].lstrip()
            wrapped = rest[:1].islower()
            if wrapped and not re.match(r"[-*•]|\d+[.)]", rest):
                continue
        if text[start : match.end()].strip():
            found.append(_trimmed(text, start, match.end()))
        start = match.end()
    if text[start:].strip():
        found.append(_trimmed(text, start, len(text)))
    return [(s, e) for s, e in found if s < e]


def shorthand(plain: str, sentences: list[tuple[int, int]], names: list[Span]) -> list[tuple[int, int]]:
    """The sentences, with those of bare notes ("bus at stop, ego 40, car ahead brakes") cut where a new one is spoken of."""
    found: list[tuple[int, int]] = []
    for start, end in sentences:
        piece = plain[start:end]
        at = start
        colon = re.search(r":\s+(?=\S)", piece)
        if (
            colon
            and not any(start <= n.start < start + colon.start() for n in names)
            and any(start + colon.end() <= n.start < end for n in names)
        ):
            found.append((start, start + colon.start()))
            at = start + colon.end()
        if not re.search(r"\b(?:the|an?|its?|his|her|their)\b", piece):
            for name in names:
                comma = re.search(r",\s*$", plain[at : name.start]) if at < name.start <= end else None
                if comma is None or name.kind == "label":
                    continue
                told = len(re.findall(r"\w+", plain[at : name.start])) >= 2
                says = re.match(r"\s*[\w+-]", plain[name.end : end]) and not re.match(
                    r"\s*(?:and|or)\b", plain[name.end : end]
                )
                if told and says:
                    found.append((at, at + comma.start()))
                    at = name.start
        found.append((at, end))
    return found


def _trimmed(text: str, start: int, end: int) -> tuple[int, int]:
    while start < end and (text[start].isspace() or text[start] in "-*•"):
        start += 1
    numbered = re.match(
        r"(?:\(?(?:\d{1,2}|[a-h]|[ivx]{1,4})[.)]|(?:step|phase|stage|event)\s\d{1,2}\s*[:.)-])\s+(?=\S)",
        text[start:end],
        re.IGNORECASE,
    )
    if numbered:
        start += numbered.end()
    while end > start and text[end - 1].isspace():
        end -= 1
    return start, end
