"""First stage: numbers with a unit, in SI, and bare numbers that can only be speeds."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.scan import Span

MILES = re.compile(r"\bmph\b|\bmiles?\b|\bfeet\b|(?<!on )(?<!by )\bfoot\b|\d ?ft\b|\byards?\b")
AMERICAN = re.compile(
    r"\bi-\d{1,3}\b|\binterstate\b|\btroopers?\b|\bsheriff\b|\bhighway patrol\b|\bstate (?:police|route)\b"
    r"|\b(?:18|eighteen)-wheelers?\b|\btractor[- ]trailers?\b|\bus[- ]\d{1,3}\b"
)
METRIC = re.compile(r"\bkm\b|\bkm/h\b|\bk[mp]?ph\b|\bkmh\b|\bkilomet|\d ?m\b|\bmet(?:er|re)s?\b|\d ?m/s")
DIGITS = "zero|one|two|three|four|five|six|seven|eight|nine|niner"
TENS = "(?:twenty|thirty|forty|fifty|sixty|seventy|eighty|ninety)"


@cache
def _number() -> str:
    words = language.alternatives(list(language.table("units")["numbers"]))
    return rf"(?:\d+(?:[.,]\d+)?|\b{TENS}[ -](?:{DIGITS})\b|\b(?:{words})\b)"


@cache
def _quantity() -> re.Pattern[str]:
    number = _number()
    unit = "|".join(re.escape(u).replace(r"\ ", r"\s+") for u in sorted(language.units(), key=len, reverse=True))
    return re.compile(
        rf"(?<![\w.])(?P<low>[+-]?{number})(?:\s*(?P<lowunit>{unit})(?![\w/]))?(?:\s*(?:-|to|and"
        rf"|\.\.\.?|or)\s*(?P<high>{number}))?(?:\s*(?:±|\+/?-)\s*\d+(?:[.,]\d+)?\)?)?"
        rf"(?:\s*|-)(?P<unit>{unit})(?![\w/²^])(?:\s+(?P<half>and a half))?"
    )


@cache
def _bare() -> re.Pattern[str]:
    nouns = language.alternatives(list(language.actor_nouns()))
    number = language.alternatives([w for w, v in language.table("units")["numbers"].items() if 10 <= float(v) <= 200])
    return re.compile(
        rf"(?:(?:\(ego\)|\b)(?:{nouns}|(?:{'|'.join(language.table('ego')['strong'])})|v[12]"
        rf"|car ?[1-9]|straight|left|right|lane|ahead|behind|doing|going|brakes? to"
        rf"|(?:slow|reduc|drop|brak|decelerat)\w* (?:speed |down )?to|accelerat\w*(?: back| up| again)* to"
        rf"|(?:speeds?|sped|picks?|picked) up to)"
        rf"(?:,? at|,? with|,? doing| (?:drives|does|did|goes|went|is doing|was doing|runs)|:| speed)?"
        rf" (?:about |around |roughly |maybe |a steady |only |at least "
        rf"|easily |over |nearly |almost )?)(?<!lane )(?P<low>\d{{2,3}}|(?:{number})\b)"
        rf"(?=\s*(?:[,.;)]|$|straight\b|and\b"
        rf"|in the\b|when\b|while\b|where\b|although\b|same\b|left\b|right\b|but\b|on the\b|behind\b|ahead\b"
        rf"|in (?:left|right)\b"
        rf"|tops\b|max\b|or so\b|coming\b|heading\b|approaching\b|towards?\b|up to\b|down the\b|along\b"
        rf"|past\b|at the most\b|when a\b))"
        rf"|\bcruise(?: control)?(?: is| was)?(?: set)? (?:at|to|on) (?P<cruise>\d{{2,3}})(?=\s*(?:[.,;)]|$|and\b))"
        rf"|\b(?:sat|sitting|sits) on (?:about |around )?(?P<sat>\d{{2,3}})(?=\s*(?:[.,;)]|$|and\b|in\b|when\b))"
        rf"|(?<![\w.])(?P<dial>\d{{2,3}})(?= on the (?:limiter|clock|speedo\w*|dial|cruise)\b)"
        rf"|\bat (?:about |around |maybe )?(?P<most>\d{{2}})(?= (?:tops|max|or so|at (?:the )?most)\b)"
        rf"|\b(?:ego|lead|lv|sv|vut|target) (?P<head>\d{{2,3}})(?= (?!(?:m|s|sec\w*|min\w*|hours?"
        rf"|years?|people|cars|vehicles|trucks|km|ft|feet|degrees|percent|to|of|lanes?|am"
        rf"|pm)\b)[a-z])"
        rf"|\b(?:(?:north|south|east|west)bound|driv\w+|travel\w*|going|cruis\w+|moving|sit\w*"
        rf"|approach\w*|arriv\w+|rid\w+|com(?:es?|ing)|came|runs?|clos(?:es?|ed|ing)"
        rf"|catch\w*|caught|pass(?:es|ed|ing)"
        rf"|overtak\w+|overtook|lead(?:s|ing)?|follow\w*|merg\w+|enter\w*|head\w+|join\w*)"
        rf"(?: [a-z][\w'-]*| (?<=interstate )\d+){{0,3}} (?:at|with) (?:about |around "
        rf"|roughly |a steady )?(?P<at>[1-9]\d?[05]|(?:{number}))(?=\s*(?:[,.;)]|$|and\b|when\b"
        rf"|in\b(?! the (?:morning|evening|afternoon))|on\b|because\b|as\b|while\b|with\b|behind\b|towards?\b))"
        rf"|\b(?:{nouns}|ego|lead|v[12]) \((?P<bracket>\d{{2,3}})(?=[,)])"
        rf"|(?:speed|doing|going|at) (?:of )?(?P<spelt>(?:{DIGITS}) (?:{DIGITS})(?: "
        rf"(?:{DIGITS}))?)(?=\s*(?:[,.;)]|$|and\b|in\b|on\b))"
        rf"|(?:\A|[.,;:(] |\band )(?:all|both)(?: of them)?(?: (?:at|do|drive|go|with|doing|driving))?"
        rf" (?P<all>\d{{2,3}})"
        rf"(?=\s*(?:[.,;)]|$))"
        rf"|\bthe speed (?P<plain>\d{{2,3}})\b(?! ?(?:km|mph|k|m/))"
        rf"|(?:autobahn|motorway|freeway|highway|interstate|road|lane|street|carriageway)"
        rf"(?:,| at) (?P<tail>\d{{2,3}})(?=\s*(?:[.;,]|$))"
        rf"|(?<=lane )(?P<lane>\d{{2,3}})(?=\s*(?:[,.;)]|$))"
        rf"|\b(?:(?:speed )?limit(?:ed)?(?: zone)?(?: (?:t?here|on (?:that|this) \w+))?|posted)"
        rf"(?: is| was| of| to| at|:)? ?(?P<limit>\d{{2,3}})(?! ?(?:km|mph|k|m|s|%)\b)"
        rf"|(?<![\w.])(?P<zone>\d{{2,3}})[- ](?=zone\b|limit\b|speed limit\b|(?:speed )?signs?\b)"
        rf"|\b(?:at|do|did|does|doing|go|goes|going|went|drives?|driving|drove|hits?|hitting) "
        rf"(?:about |around |roughly |maybe )?"
        rf"(?P<over>\d{{2,3}})(?= (?:[\w/]+ )?in an? \d{{2,3}}\b)"
        rf"|(?<=\d in a )(?P<inside>\d{{2,3}})(?! ?(?:m|s|km|cm|ft)\b)"
    )


FROM_TO = re.compile(
    r"\b(?:slow|brak|decelerat|accelerat|drop|reduc|speed|went|go|goes|came|comes)\w*"
    r"(?: (?:down|up|hard|gradually|speed|back))* from (?:about |around )?(?P<first>\d{2,3})"
    r" (?:down |up )?to (?:about |around |roughly |maybe )?(?P<second>\d{2,3})"
    r"(?=\s*(?:[.,;)]|$|(?:and|because|as|when|while|but|in|within|over|behind|for|before|then|so)\b))"
)
"""A change of speed in bare numbers: "slowed from 65 to about 45"."""


@cache
def _bare_ranges() -> re.Pattern[str]:
    """Two numbers after a road user: "VUT 50-80"."""
    nouns = language.alternatives([n for n, (_, several, _) in language.actor_nouns().items() if not several])
    names = rf"(?:{nouns}|{'|'.join(language.table('ego')['strong'])})"
    return re.compile(
        rf"(?<![\w-])(?:{names})(?: at| speed|:)? (?P<low>[1-9]\d{{1,2}}) ?(?:-|to) ?(?P<high>[1-9]\d{{1,2}})"
        rf"(?=\s*(?:[.,;)/|]|$|and\b|in the\b|on the\b))"
    )


def bare_speeds(text: str) -> list[Span]:
    """Numbers without a unit after a road user or its lane, in the shorthand of tests ("ego 60, lead 40"): mph where
    the text has mph anywhere or is American, else km/h."""
    found = []
    factor = 0.44704 if in_miles(text) else 1 / 3.6
    for match in _bare().finditer(text):
        group = next(name for name, value in match.groupdict().items() if value)
        value = value_of(match[group])
        if 10 <= value <= 200:
            data = {"dimension": "speed", "low": value * factor, "high": value * factor, "bare": True}
            found.append(Span("quantity", match.start(group), match.end(group), data))
    for match in _bare_ranges().finditer(text):
        low, high = (value_of(match[g]) * factor for g in ("low", "high"))
        if low < high:
            data = {"dimension": "speed", "low": low, "high": high, "bare": True}
            found.append(Span("quantity", match.start("low"), match.end("high"), data))
    for match in FROM_TO.finditer(text):
        first, second = (value_of(match[g]) * factor for g in ("first", "second"))
    return found


def in_miles(text: str) -> bool:
    """Whether speeds without a unit are in mph there."""
    return bool(MILES.search(text) or AMERICAN.search(text) and not METRIC.search(text))


def value_of(text: str) -> float:
    text = " ".join(text.split()).lstrip("+")
    words = language.table("units")["numbers"]
    digits = text.split()
    if compound := re.fullmatch(rf"({TENS})[ -](\w+)", text):
        return float(words[compound[1]]) + words[compound[2]]
    if len(digits) > 1 and all(d in DIGITS.split("|") for d in digits):
        return float("".join(str(min(9, DIGITS.split("|").index(d))) for d in digits))
    if text in words:
        return float(words[text])
    if re.fullmatch(r"-?\d{1,3},\d{3}", text):
        return float(text.replace(",", ""))
    return float(text.replace(",", "."))


ELAPSED = re.compile(  # what follows a second of time, not a second car
    r"\s*(?:[.,;:!?)'-]|$|(?:ahead|behind|away|before|after|later|from|apart|or|and|to|of|into|in|at|gap|headway|long|pause"
    r"|delay|earlier|sooner|passes|passed|ago|when|then|while|until)\b)"
)
EARLIER = re.compile(r"(?:(?<![\w.])\d+(?:\.\d+)?, ?)+$")
"""The first numbers of a list that shares its last one's unit: "60, 50 and 40 km/h"."""


def quantities(text: str) -> list[Span]:
    """Numbers with a unit, in SI, without those that only say the one before again: "72 km/h (45 mph)"."""
    found = [q for q in _measured(text) if q.data["dimension"] != "distance" or not SIZE.search(text[: q.start])]
    return found[:1] + [q for before, q in zip(found, found[1:], strict=False)]


SIZE = re.compile(r"\b(?:stature|height|width|body length|diameter|tall|wingspan)(?: of| is| =|:)? ?$")
"""What stands before how big somebody or something is."""


def _measured(text: str) -> list[Span]:
    """Numbers with a unit, in SI; a range has `low` and `high`."""
    found = []
    for match in _quantity().finditer(text):
        dimension, factor = language.units()[" ".join(match["unit"].split())]
        if match["high"] and match["lowunit"]:
            other, own = language.units()[" ".join(match["lowunit"].split())]
        if match["unit"] in ("'", "mi", "g") and not match["low"][-1:].isdigit():
            continue
        if match["unit"] == "yard" and match["low"] in ("a", "one"):
            continue
        if match["unit"] == "second" and match["low"] in ("a", "one") and not ELAPSED.match(text[match.end() :]):
            continue
        low = value_of(match["low"]) * (
            language.units()[" ".join(match["lowunit"].split())][1] if match["lowunit"] else factor
        )
        first = low
        joined = (
            re.search(r"(-|to|and|\.\.|or)\s*$", text[match.end("low") : match.start("high")])
            if match["high"]
            else None
        )
        high = value_of(match["high"]) * factor if match["high"] else low
        before = text[max(0, match.start() - 30) : match.start()]
        each, first_at = None, match.start()
        if joined and joined[1] == "and" and "between" not in before:
            earlier = (EARLIER.search(before) or [""])[0]
            listed, first_at = [value_of(n) for n in re.findall(r"\d+(?:\.\d+)?", earlier)], first_at - len(earlier)
            each = (*(v * factor for v in listed), low, high)
            low = high
        if high < low:
            low, high = high, low
        found.append(Span("quantity", first_at, match.end(), {"dimension": dimension, "low": low, "high": high}))
        if each is not None:
            found[-1].data["each"] = each
        if joined and joined[1] == "to" and re.search(r"from\s*$", before):
            second = value_of(match["high"]) * factor
            found[-1].data.update({"first": first, "second": second})
    return found
