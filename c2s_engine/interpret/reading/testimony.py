"""Questions and answers of a witness ("Q. How fast? A. Thirty."), as what the answers say of whom they are asked."""

import re

from c2s_engine.interpret.reading.rewritten import Replacement

MARK = re.compile(r"(?:(?<=^)|(?<=[.?!\"'’”)\n] )|(?<=\n))(?P<who>Q|A|Question|Answer)[.:]\s+(?=\S)")
ASKED = re.compile(
    r"(?:\b(?:where|how fast|which (?:way|lane)|what (?:way|lane)|what|how|when)?\s*(?:is|was|were|did|had|does)"
    r"|^and|^what about)\s+(?P<who>(?:the |that |this )?(?:[\w-]+ ){0,2}?"
    r"(?:(?:car|vehicle|driver|unit) (?:one|two|\d|[ab])|[\w-]+))"
    r"(?=\s*(?:[,?]|\b(?:do|go|com|travel|driv|brake|slow|stop|turn)|\b(?:in|at|before|when|then)\b))",
    re.IGNORECASE,
)
DID = re.compile(r"\bdid (?P<who>[\w -]+?) (?P<verb>brake|slow down|slow|stop|swerve|turn|accelerate|speed up)\b", re.I)
YES = re.compile(r"(?:oh,? |well,? )*(?:yes|yeah|yep|(?:he|she|it|they|i) did)\b[,.!]?\s*", re.IGNORECASE)
PAST = {"slow down": "slowed down", "slow": "slowed", "stop": "stopped", "swerve": "swerved", "speed up": "sped up"}
GOING = re.compile(r"(?:just )?(?!during|nothing|something|anything|everything)[a-z]{2,}ing\b", re.IGNORECASE)
FAST = re.compile(
    r"(?:(?!\d)[\w']+[.,] )?(?P<speed>[^.?!]*\b(?:miles?|mph|km|kilomet\w+|kph|kmh)\b[^.?!]*)[.?!]?", re.I
)
NOBODY = frozenset(("it", "that", "there", "they", "what", "happen", "happened", "he", "she", "this", "anything"))


def testimony(text: str) -> list[Replacement]:
    """Each question left out, and each answer as a sentence of its own."""
    marks = list(MARK.finditer(text))
    asked = [m for m in marks if m["who"][0] == "Q"]
    if len(asked) < 2 or len(marks) - len(asked) < 2:
        return []
    found: list[Replacement] = []
    topic, question = "", ""
    for mark, end in zip(marks, [*(m.start() for m in marks[1:]), len(text)], strict=True):
        said = text[mark.end() : end]
        if mark["who"][0] == "Q":
            question = said
            topic = _topic(said, topic)
            found.append((mark.start(), end, _told(said)))
        else:
            found.append((mark.start(), mark.end(), ""))
            found += [(mark.end() + s, mark.end() + e, new) for s, e, new in _answer(said, question, topic)]
    return found


def _told(question: str) -> str:
    """What a question says beside asking."""
    parts = re.findall(r"[^.?!]+[.?!]+\s*", question)
    return "".join(p for p in parts if not p.rstrip().endswith("?"))


def _topic(question: str, before: str) -> str:
    """Whom a question is about; as before, where it does not say."""
    asked = [m["who"].strip() for m in ASKED.finditer(question)]
    asked = ["I" if w.lower() == "you" else w for w in asked]
    named = [w for w in asked if w.lower().split(" ")[-1] not in NOBODY]
    return named[-1] if named else before


def _answer(said: str, question: str, topic: str) -> list[Replacement]:
    """The answer's first words as a sentence about whom it is."""
    if not topic:
        return []
    name = topic[:1].upper() + topic[1:]
    did = DID.search(question)
    if did is not None and (yes := YES.match(said)):
        past = PAST.get(did["verb"].lower(), f"{did['verb'].rstrip('e')}ed")
        return [(0, yes.end(), f"{name} {past}. ")]
    fast = FAST.match(said) if re.search(r"\bhow fast\b|\bwhat speed\b", question, re.IGNORECASE) else None
    if fast is not None:
        speed = fast["speed"].strip()
        return [(0, fast.end(), f"{name} was going {speed[:1].lower()}{speed[1:]}.")]
    if GOING.match(said):
        return [(0, 1, f"{name} was {said[:1].lower()}")]
    return []
