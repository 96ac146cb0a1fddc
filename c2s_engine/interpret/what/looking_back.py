"""What is told later and came first: "It brakes. Before that, it cut in", "it had cut in shortly before"."""

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast

SOON = (
    r"(?:(?:and|but|just|only|even|shortly|right|immediately|directly|moments?|seconds?|minutes?|long|not|some|a|an|one"
    r"|few|little|while|moment|second|short|time|instant|#time) )*"
)
OPENS = re.compile(
    rf"{SOON}(?:(?:before|prior to|preceding) (?:that|this|which)\b|(?:before|beforehand|earlier|previously)"
    r"(?: on)? (?:,|@|it\b|he\b|she\b|they\b|have\b))"
)
CLOSES = re.compile(
    r"(?<!\bas )(?<!\blike )(?<!\bthan )\b(?:before(?:hand)?|earlier|previously|(?:before|prior to) (?:that|this)"
    r"|at (?:the|that) time(?: of (?:the |this )?(?:collision|crash|accident|impact|incident))?)"
    r"(?: on)? ?\.?$"
)
IN_VAIN = re.compile(
    r"\b(?:could not|couldn't|unable to|not able to|failed to|too late to|no time to|was not enough to)"
    r" (?:\w+ )?(?:avoid|stop|prevent|evade|miss|react)\b"
)
TRIES = frozenset(
    ("turn_or_change", "brake", "brake_stop", "stop", "swerve", "lane_change", "evade", "reverse", "accelerate")
)
ONWARDS = re.compile(
    r"\b(?:by (?:then|now|that time|this time|the time)|then|now|meanwhile|meantime|finally|again|afterwards|later)\b"
)


def looking_back(cast: Cast, clauses: Clauses) -> None:
    """What a sentence says to have come first is put before what was told of the same one."""
    for number in sorted({w.sentence for w in cast.words}):
        told = [e for e in clauses.events if cast.words[e.word].sentence == number and e.mode != "hypothetical"]
        main = next((e for e in told if _main(cast, e)), None)
        whole = clauses.render([w.i for w in cast.words if w.sentence == number])
        if main is None or not _came_first(cast, main, whole.strip()):
            continue
        earlier = [e for e in clauses.events if cast.words[e.word].sentence < number and e.agent is main.agent]
        if not earlier:
            continue
        last = max(cast.words[e.word].sentence for e in earlier)
        first = min(e.order for e in earlier if cast.words[e.word].sentence == last)
        for at, event in enumerate(sorted(told, key=lambda e: e.order)):
            event.order = first - 0.5 + 0.02 * at


def tried_to_avoid(cast: Cast, clauses: Clauses) -> None:
    """Put what one tried in vain before the blow that was told first: "was struck by V2, whose driver said he swerved
    but could not avoid it", "hit a car because a child ran out and I had to swerve"."""
    for number in sorted({w.sentence for w in cast.words}):
        here = [w for w in cast.words if w.sentence == number]
        why = next((w.i for w in here if w.norm == "because"), None)
        why = here[0].i if why is None and IN_VAIN.search(" ".join(w.norm for w in here)) else why
        for event in [e for e in clauses.events if cast.words[e.word].sentence == number and e.done]:
            if why is None or event.word < why or event.act not in TRIES:
                continue
            blows = [e for e in clauses.events if e.act == "collide" and e.done and e.word < why]
            first = next((e.order for e in blows if event.agent in (e.agent, e.patient)), None)
            event.order = event.order if first is None else first - 0.3


def _main(cast: Cast, event: Event) -> bool:
    """Whether it is the first that a sentence tells in its main clause."""
    word = cast.words[event.word]
    return word.dep == "ROOT" and word.verb


def _came_first(cast: Cast, event: Event, sentence: str) -> bool:
    """Whether a main clause says that it was before what was told: by its words, by "had" or "has just"."""
    word = cast.words[event.word]
    if OPENS.match(sentence) or CLOSES.search(sentence):
        return True
    helpers = {cast.words[c].norm for c in word.children if c < event.word}
    had = "had" in helpers or {"has", "just"} <= helpers
    joined = any(cast.words[c].dep == "advcl" and cast.words[c].tag != "VBG" for c in word.children)
    return had and word.tag == "VBN" and not joined and not ONWARDS.search(sentence)
