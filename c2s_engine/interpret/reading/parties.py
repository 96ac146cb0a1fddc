"""Labels of people and of numbered actors ("P-1", "B2", "NPC 2"), and which party of a claim ego is not."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import VEHICLES
from c2s_engine.interpret.reading.motions import irregular, third_persons
from c2s_engine.interpret.spans import Span

EGO = re.compile(r"\bego\b")


FIRST = re.compile(r"(?<![\w-])(?:i|me|my|we|us|our)(?![\w-])")
BESIDE_ME = re.compile(
    r" (?:that was |who was |right |directly |just |immediately )*(?:behind|ahead|in front|beside|alongside|next to"
    r"|coming|from the (?:left|right|other)|in the (?:next|other|left|right|opposite))\b"
)
"""What tells that a vehicle of a company is another than the one in which the first person sits."""
WITHOUT_MOTOR = re.compile(
    r"\b(?:claimant|plaintiff|complainant)(?:,? (?!s\b)[\w-]+){0,6}?,? "
    r"(?:(?:riding|rode|on) (?:his|her|an?) (?:[\w-]+ )?"
    r"(?:bicycle|bike|push ?bike|cycle|e-bike)|cycl(?:ing|ed)|pedestrian(?! crossing)|cyclist|walk(?:ing|ed)|on foot"
    r"|stepped|crossing (?:the|a) (?:[\w-]+ ){1,6}?on foot|(?:was|were)(?: [\w-]+){0,2} (?:on|using) (?:the|an?)"
    r" (?:[\w-]+ )?(?:crossing|crosswalk))\b"
)
"""A party of a claim that is on a bicycle or on foot."""


def other_party(text: str, span: Span) -> bool:
    """Whether a name of ego means another: "the claimant", as the text tells of "the insured", too; "a robotaxi", where
    ego is called so."""
    name, _before = text[span.start : span.end], text[: span.start]
    if re.match(r"claimant|plaintiff|complainant", name):
        return "insured" in text or WITHOUT_MOTOR.search(text) is not None
    beside_me = FIRST.search(text) is not None and BESIDE_ME.match(text, span.end) is not None
    if beside_me and re.match(r"(?:company|fleet|works) ", name):
        return True
    if re.split(r"[ -]", name)[-1] not in language.actor_nouns() or EGO.search(name) or not EGO.search(text):
        return False
    return False


SOME_DRIVER = re.compile(
    r"(?<![\w-])(?:(?:an?|another|some) (?:(?!the|ego|test|safety|human|host|trained)\w+ )?"
    r"|the (?=driver (?:ahead|behind|in front)\b))(?P<noun>driver)"
    r"(?= (?:\w+ly |then )?(?P<verb>ahead\b|behind\b|who\b|in front\b|\w+(?:s|ed|ing)\b|[a-z]+\b))"
)
FORMS = frozenset(("ahead", "behind", "who", "in front"))
AT_HOME = re.compile(
    r"(?:is|was|has|does|of|in|on|at|with|and|or|as|to|for|from|assist\w*|seats?|driv\w+|drove|sits|sat|sitting|monitor\w*"
    r"|supervis\w*|operat\w*|control\w*|takes|took|uses|holds|held|engages|activates|keeps|warning\w*|alert\w*)$"
)


def some_driver(text: str, found: list[Span]) -> list[Span]:
    """ "A driver pulls out in front of ego": another vehicle, where ego has a name of its own."""
    if not any(s.kind == "ego" for s in found):
        return []
    data = {"type": "vehicle", "plural": False, "person": True, "noun": "driver", "roles": [], "words": [], "make": ""}
    return [
        Span("actor", m.start("noun"), m.end("noun"), dict(data))
        for m in SOME_DRIVER.finditer(text)
        if not AT_HOME.match(m["verb"]) and (m["verb"] in FORMS or m["verb"] in third_persons() | irregular().keys())
    ]


@cache
def _numbered_part() -> re.Pattern[str]:
    parts = language.alternatives(language.table("ego")["labels"]["parts"])
    return re.compile(rf"(?<![\w-])(?:the )?(?P<word>{parts})[ _-]?#?(?P<id>[1-9])(?![\w/%-]|\.\d|\s?(?:m|s|km)\b)")


@cache
def _short_label() -> re.Pattern[str]:
    shorts = "|".join(language.table("ego")["labels"]["short"])
    return re.compile(rf"(?<![\w-])(?P<word>{shorts})\.?[ -]?#?(?P<id>[1-9])(?![\w/%-]|\.\d)")


NO_ROAD = re.compile(
    r"(?:^|[.,;:(]|\b(?:and|struck|strikes?|hits?|hitting|striking|with|by|of|contacted|towards?|while|when|as|for|into"
    r"|behind))\s*$"
)


def short_labels(text: str) -> list[Span]:
    """The letters and numbers of people on foot and riders in a report ("P-1", "B2"), not of roads ("on the B1"), and
    those of actors in a test ("NPC 2")."""
    shorts = language.table("ego")["labels"]["short"]
    parts = [
        Span("label", m.start(), m.end(), {"label": f"{m['word']} {m['id']}", "word": ""})
        for m in _numbered_part().finditer(text)
    ]
    found = [m for m in _short_label().finditer(text) if NO_ROAD.search(text[max(0, m.start() - 12) : m.start()])]
    for match in found:
        noun, number = shorts[match["word"]], match["id"]
        driver = match["word"] == "p" and _drives(text, number)
        data = {"label": number, "word": "d"} if driver else {"label": f"{noun} {number}", "word": noun}
        parts.append(Span("label", match.start(), match.end(), data))
    return parts


ON_FOOT = re.compile(
    r"\b(?:pedestrians?|walk\w*|(?:in|on) (?:the|a) (?:\w+ )?crosswalk|on foot|jog\w*|cross(?:ed|ing|es)|stepp\w+"
    r"|stand(?:ing|s) (?:on|in|at|by|near|beside))\b"
)
"""What tells that somebody is on foot, who may be "P-2" then."""


@cache
def _vehicle_nouns() -> frozenset[str]:
    return frozenset(noun for noun, (kind, _, _) in language.actor_nouns().items() if kind in VEHICLES)


def _drives(text: str, number: str) -> bool:
    """Whether "P-2" is the party at the wheel of vehicle 2, as nothing tells of it on foot."""
    p = rf"(?<![\w-])p[ -]?{number}(?!\d)"
    afoot = (
        rf"{p},? (?:\(|a |an |the |who |\w+ly )*(?:(?:was|is|had been|began|started) )?(?:\w+ly )?(?:pedestrian|walk"
        r"|cross|step|stand|stood|r[au]n|jog|emerg|enter|dart|push|on foot|in (?:the|a) (?:\w+ )?cross)"
    )
    struck = rf"(?:struck|strikes?|striking|hits?|hitting|contacted|with|into|pedestrian \(?) ?{p}"
    rides = (
        rf"{p},? (?:(?:stated|said|says|states|reported|that|he|she|they|who|was|is|had been) )*"
        r"(?:riding|driving|operating|travel+ing|[nsew]/?b\b|(?:north|south|east|west)bound|in (?:the )?(?:#|lane))"
    )
    bracket = re.search(rf"{p} ?\(([^()]+)\)", text)
    aboard = bracket is not None and any(w in _vehicle_nouns() for w in re.findall(r"[\w-]+", bracket[1]))
    cycles = re.search(rf"{p},? (?:was )?(?:on|riding) (?:an?|his|her) (?:\w+ )?(?:bicycle|bike)\b", text)
    if aboard or not ON_FOOT.search(text) and not cycles:
        return True
    numbered = rf"(?<![\w-])(?:v|veh|vehicle|unit)[ -]?#?{number}(?!\d)|{rides}"
    return re.search(numbered, text) is not None and not re.search(f"{afoot}|{struck}", text)
