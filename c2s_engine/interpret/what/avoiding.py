"""What is done to avoid somebody, and what is begun and given up."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

JERKS = r"(?:swerv|veer|jerk|lurch|dodg)\w+"
AVOIDS = re.compile(
    rf"(?:{JERKS}|(?:steer|pull|swing|swung|cut|turn|go|went|goes|head)\w*) (?:\w+ )?(?:to the )?(?:left|right) "
    r"(?:in order |so as |trying |in an attempt )?(?:to (?:avoid|miss|dodge|evade|clear|get (?:out|around|past))"
    r"|and (?:avoid|miss)\w*|around (?:it|the|a)|avoiding|missing)\b"
    rf"|{JERKS} (?:\w+ )?(?:to the )?(?:left|right)(?= (?:and|but|when|as|while|[,.;])| ?$)"
)
GIVES_UP = re.compile(
    r"\b((?:drop|fall|tuck|pull)\w* back(?: in)?(?= (?:behind|again|in|because|when|as|due|since|once)\b| ?[.,;]| ?$)"
    r"|abort\w*|abandon\w*|cancel\w*|breaks? (it )?off|gives? up|gave up|changes? (its|his|her) mind"
    r"|think(s)? better of it|(go|goes|went|move|moves|moved|pull|pulls|pulled|steer|steers|swerve|swerves|drift|drifts"
    r"|come|comes|slip|slips|swing|swings) (right |straight )?back(?! (in|to) front)"
    r"|returns? to (its|the|his|her) (own |original |previous |initial )?lane|returns? to (its|his|her) own"
    r"|(goes|went|stays|stayed|remains|remained) (back )?in (its|his|her) own (lane)?)\b"
)
BEGINS = language.words("begins")


def by_means(cast: Cast, clauses: Clauses) -> None:
    """Who avoids somebody by braking or steering does that because of him: "avoids the bus by steering left"."""
    for event in [e for e in clauses.events if e.act == "evade" and e.done]:
        for way in clauses.events:
            word = cast.words[way.word]
            by = word.dep == "pcomp" and cast.words[word.head].norm == "by"
            if by and way.agent is event.agent and way.patient is None:
                event.mode, way.patient, way.mode = "hypothetical", event.patient, "fact"
                way.act = "swerve" if way.act == "turn" else way.act


def abandoned(cast: Cast, clauses: Clauses) -> None:
    """A lane change that is begun and given up is a swerve; an overtaking that is given up does not happen."""
    for event in clauses.events:
        if event.act not in ("lane_change", "cut_in", "overtake") or not event.done:
            continue
        words, at = cast.words, cast.words[event.word]
        begun = clauses._lemma(words[at.head]) in (BEGINS if at.head != at.i else BEGINS - {"go"})
        out = clauses.by_word.get(at.head)  # "pulls out to overtake, but drops back"
        begun = begun or event.mode == "purpose" or at.tag == "VB" and out is not None and out.act == "lane_change"
        later = [w for w in words if w.i > event.word and w.sentence - at.sentence <= 1]
        given_up = GIVES_UP.search(" ".join(w.norm for w in later))
        if not begun or given_up is None:
            continue
        word = _word_at(later, given_up.start())
        others = [e for e in clauses.events if event.word < e.word < word and e.agent is not event.agent]
        own = any(e.word == word and e.agent is event.agent for e in clauses.events)
        if not own and any(
            not e.agent.ego or e.act == "overtake" for e in others if words[e.word].sentence == words[word].sentence
        ):
            continue
        back = [e for e in clauses.events if e.agent is event.agent and abs(e.word - word) <= 1 and e is not event]
        if out is not None and out.act == "lane_change" and out.agent is event.agent and event.act == "overtake":
            out.act, out.side = "swerve", out.side or "left"  # it leaves its lane and comes back
        if event.act == "overtake":
            event.act, event.mode = ("overtake", "hypothetical") if event.agent.ego else ("follow", "fact")
            event.patient = event.patient or cast.ego
        elif event.agent.ego:
            event.act = "swerve"
            for other in back:
                other.mode = "hypothetical" if other.act in ("reverse", "lane_change", "swerve") else other.mode
        else:
            for other in back:
                other.act = "lane_change" if other.act == "reverse" else other.act


def _word_at(words: list[Word], offset: int) -> int:
    """The index of the word at an offset of their joined text."""
    for word in words:
        if offset <= 0:
            return word.i
        offset -= len(word.norm) + 1
    return words[-1].i
