"""Which way somebody drives, by the compass: told beside its name, or by what it does; and whose lanes are whose."""

import re

from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.towards import side
from c2s_engine.interpret.who.mentions import Entity

COMPASS = {"north": 0, "east": 90, "south": 180, "west": 270}
WAY = re.compile(r"\b(north|south|east|west)(bound|ward|wards|erly)?\b")
FROM = re.compile(r"(?:from|of) (?:the )?$")
OFF = re.compile(r"\b(?:from|out of|leave|exit|off|depart)\b.*$")
OF_ROAD = re.compile(
    r"\b(?:in|from|out of|off|on|leave|at) (?:the |a |an )?(?:\w+ )?"
    r"(?:road|street|leg|arm|approach|driveway|entrance|drive|alley) (?:to|on|at) (?:the |its )?$"
)
SIDE = re.compile(r" (?:side|curb|kerb|edge|shoulder|sidewalk|pavement)\b")
PLACE = re.compile(r" (?:end|leg|corner|quadrant|crosswalk|approach|part|portion)\b")
INTO = re.compile(r"\b(?:into|onto|towards?|across|over|in front of) (?:the )?$")
LOOKS_BACK, LOOKS_ON, INSERTED = 4, 12, 24
TOLD = frozenset(("VBD", "VBZ", "VBP", "MD"))


def _heading(text: str) -> int | None:
    """Which way somebody drives of whom the words tell: degrees from north."""
    for match in WAY.finditer(text):
        before, after = text[: match.start()], text[match.end() :]
        way = COMPASS[match[1]]
        if OF_ROAD.search(before):
            return (way + 180) % 360  # from "the side road to the north"
        if SIDE.match(after) or not match[2] and FROM.search(before):
            if SIDE.match(after) and OFF.search(before) is None:
                continue  # stands there
            return (way + 180) % 360
        if PLACE.match(after) and not match[2] or INTO.search(before):
            continue
        return way
    return None


def _told(words: list[Word]) -> str:
    return " ".join(w.lemma if w.verb else w.norm for w in words)


def _another(clauses: Clauses, word: Word, who: Entity) -> bool:
    """Whether another road user is named there."""
    named = clauses.cast.of.get(word.i)
    return named is not None and named is not who and (named.ego or named.mover)


def _beyond(clauses: Clauses, at: int) -> list[Word]:
    """The words behind a name without what is put in beside it: "V1 (a 2013 Prius), driven by a woman, was"."""
    rest = clauses.words[at + 1 :]
    for first, last in (("(", ")"), (",", ",")):
        if rest and rest[0].norm == first:
            end = next((n for n, w in enumerate(rest[1:INSERTED], 1) if w.norm == last), None)
            inner = rest[1:end] if end is not None else []
            told = any(w.tag in TOLD and first == "," or WAY.fullmatch(w.norm) for w in inner)
            if end is not None and inner and not told:
                rest = rest[end + 1 :]
    return rest


def _by_mentions(clauses: Clauses, who: Entity) -> int | None:
    """The heading told right beside a mention: "a westbound Tahoe", "V1, eastbound on Main Street, ..."."""
    for mention in who.mentions:
        sentence = clauses.words[mention.word].sentence
        before: list[Word] = []
        for word in reversed(clauses.words[max(0, mention.word - LOOKS_BACK) : mention.word]):
            if word.sentence != sentence or word.i in clauses.cast.of or not word.tag.startswith(("JJ", "NN", "CD")):
                break
            before.insert(0, word)
        after: list[Word] = []
        subject = clauses.words[mention.word].dep in ("nsubj", "nsubjpass", "poss", "ROOT")
        for word in _beyond(clauses, mention.word)[: LOOKS_ON - 1]:
            if word.sentence != sentence or _another(clauses, word, who):
                break
            if word.tag in ("VBD", "VBZ") and not subject and clauses.words[word.head].i != mention.word:
                break  # of another: "a pickup behind V1 pulled into the northbound lane"
            after.append(word)
        found = _heading(_told(before)) if before else None
        found = _heading(_told(after)) if found is None else found
        if found is not None:
            return found
    return None


def heading(clauses: Clauses, who: Entity) -> int | None:
    """Which way somebody drives, by the words beside its mentions, else by what it does."""
    found = _by_mentions(clauses, who)
    if found is not None:
        return found
    for event in clauses.events:
        if event.agent is who or who in event.also:
            own = [clauses.words[i] for i in sorted(event.words)]
            found = _heading(_told(own) if own else event.whole)
            if found is not None:
                return found
    return None


EDGE = re.compile(
    r"\b(?P<way>north|south|east|west)(?:ern)? "
    r"(?:side|edge|shoulder|curb|kerb|verge|ditch|embankment|roadside|guard ?rail)\b"
    r"|\b(?:to|towards?) (?:the )?(?P<to>north|south|east|west)\b(?! (?:of|on)\b)"
)
"""The side of the road, or of one who drives there, by the compass."""
SIDEWAYS = frozenset(("leave_road", "exit_road", "drift", "swerve", "lane_change", "lose_control"))


def sides_by_compass(clauses: Clauses) -> None:
    """The side by which somebody leaves the road or its lane: "eastbound, it ran off the north side"."""
    for event in clauses.events:
        edge = EDGE.search(event.text) if event.act in SIDEWAYS and side(event) is None else None
        own = heading(clauses, event.agent) if edge else None
        if edge and own is not None:
            turned = (COMPASS[edge["way"] or edge["to"]] - own) % 360
            event.side = {90: "right", 270: "left"}.get(turned)


LANES_OF = re.compile(
    r"\b(?:(?:in|on)to|enter|cross|across|over|in) (?:the )?(?P<way>north|south|east|west)bound (?:\w+ ){0,2}lanes?\b"
)
GETS_OVER = frozenset(
    ("lane_change", "cut_in", "drift", "swerve", "lose_control", "cross_path", "enter_road", "travel")
)


def against_the_traffic(clauses: Clauses) -> None:
    """Who gets into the lanes of the other direction, by the compass, drives against the traffic there."""
    for event in clauses.events:
        lanes = LANES_OF.search(event.text) if event.done and event.act in GETS_OVER and event.agent.mover else None
        own = heading(clauses, event.agent) if lanes else None
        if lanes and own is not None and (COMPASS[lanes["way"]] - own) % 360 == 180 and not lanes[0].startswith("in "):
            event.act, event.side, event.patient = "oncoming", "left", None
    _pulls_out_into_oncoming(clauses)


TURNS = frozenset(("turn", "u_turn", "oncoming", "lane_change"))


def _pulls_out_into_oncoming(clauses: Clauses) -> None:
    """Who pulls out and then meets one that drives the other way was in its lane: "pulled out and struck V2"."""
    for blow in [e for e in clauses.events if e.act == "collide" and e.done and e.patient is not None]:
        one, other = heading(clauses, blow.agent), heading(clauses, blow.patient) if blow.patient else None
        if one is None or other is None or (other - one) % 360 != 180:
            continue
        before = [e for e in clauses.events if e.done and e.order < blow.order and e.act in TURNS]
        moves = [e for e in before if e.agent in (blow.agent, blow.patient)]
        if len(moves) == 1 and moves[0].act == "lane_change" and side(moves[0]) in (None, "left"):
            moves[0].act, moves[0].side, moves[0].patient = "oncoming", "left", None
