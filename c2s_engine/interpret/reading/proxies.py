"""The words that the parser is shown: plain ones for names, road users, units and verbs that it would mistake."""

import regex

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.motions import participles
from c2s_engine.interpret.reading.scan import Span

WORD = regex.compile(
    r"can(?=not\b)|not\b|\p{L}+(?=n't\b)|n't\b|'(?:m|re|ve|ll|d)\b"
    r"|\p{L}[\p{L}\p{M}\p{N}]*(?:[-/]\p{L}[\p{L}\p{M}\p{N}]*)*|'s\b|'(?=\s)|\d+(?:[.,]\d+)*"
    r"|[^\s\w]|\S"
)


LETTERS_AFTER = regex.compile(
    r"\s*(?:\w+(?:s|ed|ing)|is|was|has|had|must|should|will|can|may|then|did|cut|hit|ran|went|came)\b"
)


def pieces_of(plain: str, start: int, end: int, spans: list[Span]) -> list[tuple[str, int, int, Span | None]]:
    inside = [s for s in spans if start <= s.start and s.end <= end]
    found: list[tuple[str, int, int, Span | None]] = []
    at = start
    last: Span | None = None
    for span in [*inside, None]:
        stop = span.start if span else end
        for number, match in enumerate(WORD.finditer(plain[at:stop])):
            after = bool(found) and (found[-1][0].endswith("ly") or found[-1][0] == "either")
            near = last if number == 0 or number == 1 and after else None
            found.append((_word(match[0], near, plain, at + match.start()), at + match.start(), at + match.end(), None))
        last = span
        if span:
            found += _proxies(plain, span, found[-1][0] if found else "")
            at = span.end
    return found


TO_SOMEBODY = regex.compile(r"\s+(?:us|me|him|her|it|them)\s+\p{L}")
"""A pronoun as the object of a participle."""
NOUN_BEFORE = regex.compile(r"\b(?:the|a|an|this|that|his|its|each)\s+(?:[\w-]+\s+){0,2}$")
ON_THE = regex.compile(r"\b(?:on|to|from|at|in|of)\s+(?:the|its|our|his|her|my|ego's)\s+$")
VERBAL_LEFT = regex.compile(r"left\s+(?:the|its|his|their|a|that|this)\s+(?!side|lane of)")


BOUND = frozenset(f"{way}{end}" for way in ("north", "south", "east", "west") for end in ("bound", "wards", "ward"))


FOLLOWS = regex.compile(
    r"\s*(?:[.,;:!?)]|$|(?:at|in|into|onto|on|off|out|over|across|along|towards?|from|to"
    r"|through|behind|past|with|without|for|and|then|while|when|as|because|due|hard|sharply|"
    r"suddenly|abruptly|heavily|slowly|left|right|straight|away|up|down|back|ahead|around"
    r"|again|gradually|before|after|but|so|too|immediately|quickly|by|under|until|because"
    r"|between|beside|just|directly|unexpectedly|strongly|level|abreast|alongside|parallel|round|clear|wide|short|inside|beyond|about|upon|against|near|close|straight|apart|together|first|or"
    r"|heading|coming|going|blocking|facing"
    r"|side by side|neck and|each other|one another)\b)"
)


CROSSES = regex.compile(r"\s+(?:the|a|from|in front|at the|over|on|behind|with|slowly|against|his|her|its)\b")


LANES = regex.compile(r"\s+(?:\w+\s+)?lanes?\b")


FORCES = {"forces": "makes", "forcing": "making"}


LIT = regex.compile(
    r"\bwith (?:\w+ ){0,3}?(?:beams?|lights?|headlights?|lamps?|hazards|indicators?|blinkers?|sirens?|beacons?)\s+$"
)
CRASHES = regex.compile(r"\s+(?:\w+ )?(?:collision|crash|impact|accident|encounter)")
BRAND = regex.compile(r"\b(?:an?|the|another)\s+[a-z][\w.-]+\s+$")
"""Before a name of ego that goes with that of its maker: "a Lumeno AV"."""


MODAL = regex.compile(
    r"\b(?:will|should|must|shall|would|could|can|may)\s+(?!be\b)\p{L}[^.;:]*?"
    r"(?:\band|\bthen|,|\bor)\s+(?:then |\w+ly )?$"
)
VERB_BEFORE = regex.compile(
    r"(?:in front|ahead|behind|on the (?:left|right)|of (?:me|us|it|him|her)|lane|,|\band|\bthen|\bbut|ly|\bfirst"
    r"|\b(?:it|he|she)|\blater|\bsoon|\bagain|\bjust \w+ed(?: hard)?"
    r"|\bwith (?:an?|his|her|its|their) (?:[\w-]+ )?[\w-]+)\s*$"
)
HAVING = regex.compile(r"\b(?:has|have|had|having)\s+(?:just\s+|already\s+|now\s+|\w+ly\s+)?$")
STRUCK = frozenset(("rear-ended", "t-boned", "side-swiped", "sideswiped", "broadsided", "contacted", "impacted"))


LETS = regex.compile(r"\b(?:let|lets|letting|make|makes|making|made|help|helps|watch|watches|sees)\s+(?:\S+\s+){1,4}$")


def _several(span: Span | None) -> bool:
    """Whether several road users stand before: after them a base form is a verb ("two cars race past ego")."""
    return span is not None and bool(span.data.get("plural"))


def _word(text: str, before: Span | None, plain: str, start: int) -> str:
    """The word that the parser sees in place of one that it would take for another part of speech."""
    if text in BOUND:
        return "east"
    if text in (known := language.table("parsing")["shown_as"]):
        return str(known[text])
    if text == "head-on" and not CRASHES.match(plain[start + 7 : start + 20]):
        return "directly"
    if text == "bend" and NOUN_BEFORE.search(plain[max(0, start - 24) : start]):
        return "curve"
    verb = regex.match(r"\s+(?:then |suddenly )?(\p{L}+)", plain[start + len(text) : start + 40])
    if text == "both" and verb and verb[1] in language.word_list("motion") | language.word_list("base"):
        return "they"
    lets = before is not None and text in language.word_list("motion") | language.word_list("base")
    if lets and LETS.search(plain[max(0, start - 48) : start]):
        return "go"
    person = before is not None and before.data.get("type") in ("pedestrian", "child", "animal")
    mover = before is not None and before.data.get("type")
    if mover and text in participles() and TO_SOMEBODY.match(plain, start + len(text)):
        return "following"  # "a van tailing us brakes"
    if text == "crossing" and mover and CROSSES.match(plain[start + 8 : start + 20]):
        return "walking" if person else "passing"
    if text in ("lane-splitting", "filtering") and mover:
        return "passing"
    if text in STRUCK:
        return "struck"
    if text in ("changes", "switches", "swaps") and before is not None and LANES.match(plain[start + len(text) :]):
        return "takes"
    if text in ("changing", "switching") and before is not None:
        return "taking"
    if text in language.table("parsing")["irregular"] and HAVING.search(plain[max(0, start - 24) : start]):
        return "gone" if FOLLOWS.match(plain[start + len(text) : start + len(text) + 14]) else "met"
    if text in FORCES and regex.match(
        r"\s+(?:the|its|an?|his|her|ego|them|it|me|us|another)\b", plain[start + len(text) :]
    ):
        return FORCES[text]
    if text == "on" and LIT.search(plain[max(0, start - 40) : start]):
        return "off"  # "with its lights on turns" is no "on turns"
    placed = ON_THE.search(plain[max(0, start - 12) : start]) is not None
    if text == "left" and (placed or not VERBAL_LEFT.match(plain[start : start + 24])):
        return "right"
    follows = FOLLOWS.match(plain[start + len(text) : start + len(text) + 14])
    if (
        before is not None
        and (before.kind != "quantity" or before.data["dimension"] == "speed" and text != "stops")
        and text.endswith("s")
        and (
            text in language.word_list("noun_like")
            or text in language.word_list("transitive")
            or text[:-1] in language.word_list("motion")
            or text[:-2] in language.word_list("motion")
        )
    ):
        if text in language.word_list("transitive"):
            return "follows" if text != "lets" else text
        if follows:
            return "goes"
    elif (
        text == "closes"
        and regex.match(r"\s+(?:in|up|on)\b", plain[start + 6 : start + 12])
        or follows
        and text.endswith("s")
        and (text in language.word_list("noun_like") or text in ("waits", "signals", "stops"))
        and VERB_BEFORE.search(plain[max(0, start - 36) : start])
        or before is not None
        and before.kind != "quantity"
        and text in ("decel", "accel", "decelerating", "accelerating")
        and text[-2:] != "ng"
    ):
        return "goes"
    elif (
        follows
        and text in (language.word_list("motion") if _several(before) else language.word_list("base"))
        and (
            before is not None
            and before.kind != "quantity"
            or MODAL.search(plain[max(0, start - 80) : start])
            or regex.search(r"\blanes\b|\bthey\s*$", plain[max(0, start - 28) : start])
        )
    ):
        return "go"
    return text


def _proxies(plain: str, span: Span, before: str) -> list[tuple[str, int, int, Span | None]]:
    start, end = span.start, span.end
    if span.kind == "quantity":
        number = regex.match(r"[+-]?[\d.,]+|\w+", plain[start:end])
        cut = start + number.end() if number else start + 1
        unit = {"speed": "mph", "distance": "meters", "time": "seconds", "acceleration": "mph", "percent": "percent"}[
            span.data["dimension"]
        ]
        if cut >= end:
            return [(unit, start, end, span)]
        return [(plain[start:cut], start, cut, span), (unit, cut, end, span)]
    if span.kind == "word":
        return [(span.data["proxy"], start, end, None)]
    if span.kind == "share":
        return [("men" if span.data["plural"] else "Mark", start, end, span)]
    named = plain[start:end].startswith("the ")
    after_determiner = (
        before in language.word_list("determiners")
        or before.endswith(("ing", "ed", "y", "-", "en", "al", "ow"))
        and not before.isdigit()
        or before.isdigit()
    )
    after_determiner = (
        after_determiner or span.kind == "ego" and BRAND.search(plain[max(0, start - 24) : start]) is not None
    )
    after_determiner = after_determiner and not (
        span.kind == "ego" and before.endswith(("way", "city", "country", "day"))
    )
    if span.kind == "label" and span.data["label"].startswith("pedestrian "):
        return [("Mary", start, end, span)]
    if span.kind == "label":
        return [("V" + span.data["label"].rpartition(" ")[2].upper(), start, end, span)]
    if span.kind == "ego":
        proxy = "I" if plain[start:end] == "i" else "car" if after_determiner or named else "John"
        if named:
            return [("the", start, start + 3, None), (proxy, start + 4, end, span)]
        return [(proxy, start, end, span)]
    kind = span.data["type"]
    if named:
        start += 4
        return [("the", start - 4, start - 1, None), ("car", start, end, span)]
    if span.data.get("plural"):
        return [
            ("bikes" if kind == "bicycle" else "men" if kind in ("pedestrian", "child") else "trucks", start, end, span)
        ]
    verb_follows = LETTERS_AFTER.match(plain[end : end + 20])
    proxy = "man" if span.data.get("person") else language.table("parsing")["proxies"].get(kind, "car")
    if not after_determiner and verb_follows and kind not in ("debris", "construction_zone", "obstacle"):
        proxy = "Mary" if kind in ("pedestrian", "child", "bicycle", "rider") else "Mark"
    return [(proxy, start, end, span)]
