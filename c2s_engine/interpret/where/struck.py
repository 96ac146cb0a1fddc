"""Places and parties that a collision tells: who was behind whom, on which side of the road stands what was hit."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.towards import side
from c2s_engine.interpret.who.mentions import Cast

SIDE = r"(?:passenger |driver )?(?:doors?|side|quarter|panel|wheel|fender|tires?|tyres?|axle|wing)"
"""What follows "rear" in a part of the side."""
END = rf"(?:(?:rear|back)(?:[- ](?:end|bumper|plane))?(?! (?:{SIDE})\b)|tail|boot|trunk|tailgate)"
HEAD_ON = re.compile(r"\bhead[- ]?on\b|\bfront to front\b|\bfrontally\b")
SHIFTS = {
    **dict.fromkeys(("merge", "move", "shift", "change", "switch"), "lane_change"),
    "drift": "drift",
    "veer": "swerve",
    "swerve": "swerve",
}
"""What one does who "merges into" another."""
COMES_OUT = frozenset(("enter_road", "reverse", "cut_in", "go_straight", "cross_path", "lane_change"))
OUT_INTO = re.compile(
    r"\bout of (?:an?|the|its|his|her) (?:\w+ ){1,3}(?:straight |right |directly )?into (?:the )?"
    rf"(?:(?:\w+ )?(?:{END}|{SIDE}|front) of )?(?:the |an? )?@(?P<whom>\w+)\b"
    rf"(?! 's (?:(?!{SIDE}|{END}|front)\w+ )?(?:lane|path|way|street|road))"
)
"""Into whom one comes that was off the road."""
PUSHES = language.words("pushes")
IN_ORDER = re.compile(r"\bin (?:that|this|the same|numerical|the following) order\b")


def merged_into(clauses: Clauses) -> None:
    """Who merges or drifts into another changes lanes or drifts first: "merged right into V1"."""
    for event in [e for e in clauses.events if e.act == "collide" and e.done and not e.passive]:
        shift = SHIFTS.get(clauses._lemma(clauses.words[event.word]))
        earlier = (e for e in clauses.events if e.agent is event.agent and e.order < event.order)
        shifted = any(e.act in ("lane_change", "cut_in", "drift", "turn", "leave_road") for e in earlier)
        if shift is not None and not shifted:
            clauses.events.append(Event.echo(event, act=shift, order=event.order - 0.1, adverbial=event.adverbial))


def came_out_into(clauses: Clauses) -> None:
    """Who comes out of somewhere "into" another hits that one: "reversed out of a drive into my door"."""
    by_key = {e.key: e for e in (clauses.cast.ego, *clauses.cast.entities)}
    hits = {(e.word, e.agent) for e in clauses.events if e.act == "collide"}
    for event in [e for e in clauses.events if e.act in COMES_OUT and e.done and not e.passive]:
        into = OUT_INTO.search(event.text)
        struck = by_key.get(into["whom"]) if into else None
        if struck is not None and struck is not event.agent and (event.word, event.agent) not in hits:
            clauses.events.append(Event.echo(event, act="collide", patient=struck, order=event.order + 0.3))
            hits.add((event.word, event.agent))


def struck_places(cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Fill the places that collisions tell; what is said stays."""
    for hit in clauses.events:
        if hit.act != "collide" or not hit.done or hit.patient is None:
            continue
        if hit.agent.ego and hit.patient in of and not hit.patient.mover:
            _thing(hit, clauses, of[hit.patient])
        if _from_behind(hit, clauses):
            _one_behind(hit, of)
        elif not HEAD_ON.search(hit.text):
            _ahead_of_pushed(hit)


def _from_behind(hit: Event, clauses: Clauses) -> bool:
    """Whether somebody is hit from behind by one who drives forwards."""
    backs = any(e.agent is hit.agent and e.act == "reverse" and e.done for e in clauses.events)
    assert hit.patient is not None
    other = rf"@{hit.patient.key}"
    return not backs and bool(
        re.search(
            rf"^rear(?:-?end)?\b(?! (?:of|bumper))|\b{END} of (?:the )?(?:\w+ )?{other}\b"
            rf"|{other} (?:'s )(?:left |right )?{END}\b"
            rf"|{other} (?:from behind|(?:from|in|at) the (?:rear|back))",
            hit.text,
        )
        or hit.passive
        and re.search(r"^\w+ (?:from behind|(?:from|in|at|on) (?:the|its) (?:rear|back))(?: end)? by\b", hit.text)
    )


def _open(where: Where) -> bool:
    return where.open and where.facing is None


def _one_behind(hit: Event, of: dict[Entity, Where]) -> None:
    """Who hits another from behind starts behind it."""
    agent, patient = hit.agent, hit.patient
    assert patient is not None
    if agent.ego:
        if patient in of and patient.mover and not patient.person and _open(of[patient]):
            of[patient].rel, of[patient].lane = "ahead", "same"
    elif agent in of and _open(of[agent]) and not agent.roles & {"oncoming", "crossing"}:
        of[agent].rel, of[agent].lane = "behind", "same"
        of[agent].of = None if patient.ego else patient


def _ahead_of_pushed(hit: Event) -> None:
    """Whom one is pushed into is ahead of that one: "ran into V2, pushing it into V3"."""
    _agent, patient = hit.agent, hit.patient
    assert patient is not None


def _thing(hit: Event, clauses: Clauses, where: Where) -> None:
    """A thing that ego hits off the road stands on the side on which it left; what it backs into is near."""
    before = [e for e in clauses.events if e.agent.ego and e.done and e.order <= hit.order]
    leaves = [e for e in before if e.act in ("leave_road", "swerve", "drift", "lose_control")]
    fixed = hit.patient is not None and hit.patient.noun in language.table("actors")["fixed"]
    if where.lane in (None, "roadside", "sidewalk") and (leaves or fixed):
        where.lane = where.lane or "roadside"
        where.side = next((s for e in reversed(leaves) if (s := side(e))), None) or where.side
