"""Who is ego where nobody is called so."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import URGENT
from c2s_engine.interpret.reading.askers import bystanding
from c2s_engine.interpret.roles.among_others import who_is_led, who_met_it
from c2s_engine.interpret.roles.aside import beside_nobody, from_aside
from c2s_engine.interpret.roles.at_stops import at_a_stop
from c2s_engine.interpret.roles.bare import ROLE_WORDS, bare_first
from c2s_engine.interpret.roles.paired import leave_group
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import MOTOR, VEHICLES, Cast, Entity

NEVER_EGO = language.words("never_ego")


EGO_LIKE = frozenset(
    (
        "travel",
        "turn",
        "go_straight",
        "lane_change",
        "lose_control",
        "leave_road",
        "run_red",
        "run_stop",
        "reverse",
        "follow",
        "overtake",
        "drift",
        "approach",
        "collide",
        "keep_lane",
        "brake",
        "yield",
        "oncoming",
        "u_turn",
        "brake_stop",
        "stop",
        "swerve",
        "enter_road",
        "start",
        "accelerate",
        "cut_out",
        "overtake",
        "evade",
    )
)


IN_MODE = re.compile(
    r"\b(?:in|with|on|under) (?:its |the |full |fully |an? )*(?:autonomous|automated|self-driving|driverless|autopilot"
    r"|conventional|manual)\b(?: driving)?(?: (?:mode|control|system|engaged|active|on)\b)?|\boperating autonomously\b"
)
"""What is said of the vehicle that a report of an automated vehicle is about."""


HELD = re.compile(
    r"\b(?:stop|wait|stand|halt|sit|stopped|waiting)\b.*\b(?:light|lights|signal|sign|line|traffic|queue|turn|crosswalk|crossing"
    r"|junction|intersection|pedestrians?|roundabout)\b"
)
"""What one stops for that drives."""


TOWARDS = frozenset(("collide", "overtake", "follow", "yield", "cut_in", "evade"))
"""What ego does to another: who is meant by "the driver" is not the other."""


def _in_mode(entity: Entity, cast: Cast) -> bool:
    """Whether it is said in which mode it drives ("a Lexus in autonomous mode"), before another one is spoken of."""
    for mention in entity.mentions:
        rest = cast.words[mention.word + 1 : mention.word + 24]
        other = (n for n, w in enumerate(rest) if w.sentence != cast.words[mention.word].sentence or w.i in cast.of)
        if IN_MODE.search(" ".join(w.norm for w in rest[: next(other, len(rest))])):
            return True
    return False


def _demanded(entity: Entity, cast: Cast) -> bool:
    """Whether a rule asks something of it: "the vehicle shall clear the lane"."""
    return any(
        cast.words[c].norm in ("shall", "must") and cast.words[m.word].dep == "nsubj"
        for m in entity.mentions
        for c in cast.words[cast.words[m.word].head].children
    )


def _passes_nobody(acts: list[Event]) -> bool:
    """Whether one goes past somebody who is never named: that may be ego."""
    passed = [v.patient for v in acts if v.act == "overtake"]
    return bool(passed) and all(p is None or p.mover and p.type not in VEHICLES for p in passed)


def _by_whom(cast: Cast, entity: Entity) -> bool:
    """Whether it is first named as who did something to another ("was hit by a left-turning truck")."""
    at = entity.mentions[0].word
    head = cast.words[cast.words[at].head]
    return cast.words[at - 1 if at else 0].norm == "by" or head.dep == "agent" and cast.words[at].dep == "pobj"


def _runs_down(entity: Entity, clauses: Clauses) -> bool:
    """Whether it hits somebody without a motor ("a cyclist was knocked down by a van"): then it is whom it is about."""
    hits = [v.patient for v in clauses.events if v.act in ("collide", "approach") and v.agent is entity and v.done]
    return any(p is not None and p.mover and p.type not in MOTOR for p in hits)


def _on_its_own(entity: Entity) -> bool:
    """Whether it is told of by itself, if only as one of several ("one of them")."""
    return entity.group is None or entity.group.type in MOTOR and not entity.group.roles & ROLE_WORDS


def _held_up(entity: Entity, acts: list[Event], clauses: Clauses) -> bool:
    """Whether it only stands in traffic, for a light or a sign, and is run into: it may be whom the text is about."""
    waits = any(HELD.search(v.whole) for v in acts)
    return waits and any(v.act == "collide" and v.patient is entity and v.done for v in clauses.events)


def choose_ego(cast: Cast, clauses: Clauses) -> None:
    """Where nobody is called ego: the vehicle that the text is about, if there is one besides the others."""
    if cast.ego.mentions:
        return
    vehicles = [e for e in cast.entities if e.type in MOTOR and e.count == 1 and _on_its_own(e)]
    told_by = cast.me is not cast.ego or bystanding(" ".join(w.norm for w in cast.words))
    acting = {e: [v for v in clauses.events if v.agent is e and v.done] for e in vehicles}
    candidates = []
    for entity in vehicles:
        if (
            entity.roles & ROLE_WORDS
            or (entity.noun or entity.label) in NEVER_EGO
            or not told_by
            and (_passes_nobody(acting[entity]) or "following" not in entity.roles and (beside_nobody(entity, cast)))
        ):
            continue
        head = cast.words[entity.mentions[0].word]
        if not told_by and len(vehicles) == 1 and any(from_aside(m.word, cast) for m in entity.mentions):
            continue
        before = cast.words[head.i - 1].norm if head.i else ""
        told_apart = {before, *(cast.words[c].norm for c in head.children)} & {"another", "other"}
        if told_apart and vehicles.index(entity):
            continue
        if "other" in told_apart and len(vehicles) == 1 and not told_by:
            continue
        told = [v for v in acting[entity] if not v.whole.startswith("there be ")] or acting[entity]
        acts = ["stationary" if at_a_stop(v) else v.act for v in told]
        if any(v.act in TOWARDS and v.agent is cast.ego and v.patient is entity for v in clauses.events):
            continue
        if not acts and not any(v.patient is entity for v in clauses.events):
            continue
        held = _held_up(entity, acting[entity], clauses)
        if acts and not EGO_LIKE & set(acts) and not held:
            continue
        if {"cut_in", "enter_road"} & set(acts):
            continue
        if (_by_whom(cast, entity)) and not _runs_down(entity, clauses):
            continue
        if (
            cast.words[entity.mentions[0].word].dep == "pobj"
            and cast.words[cast.words[entity.mentions[0].word].head].dep == "agent"
            and not acts
        ):
            continue
        candidates.append(entity)
    candidates = bare_first(vehicles, cast) or candidates
    driverless = [e for e in vehicles if _in_mode(e, cast)]
    if len(driverless) == 1:
        candidates = driverless
    if not candidates:
        struck = {v.patient for v in clauses.events if v.act == "collide" and v.done and not v.agent.ego}
        candidates = [e for e in vehicles if e in struck and not e.roles & ROLE_WORDS][:1]
    if not candidates and len(vehicles) == 1 and not beside_nobody(vehicles[0], cast):
        passed = [v.patient for v in acting[vehicles[0]] if v.act in ("overtake", "cut_in")]
        candidates = (
            vehicles if passed and all(p is not None and p.type not in MOTOR and not p.ego for p in passed) else []
        )
    if not candidates:
        candidates = []
    if not candidates:
        return
    demanded = [e for e in candidates if _demanded(e, cast)]
    ordinary = [e for e in candidates if e.type not in URGENT]
    candidates = demanded or (candidates if told_by else ordinary) or candidates
    generic = [e for e in candidates if e.noun == "vehicle"]
    if generic and "the" in [
        w.norm for w in cast.words[max(0, generic[0].mentions[0].word - 2) : generic[0].mentions[0].word]
    ]:
        candidates = generic
    best = next((e for e in candidates if "following" in e.roles), candidates[0])
    best = best if acting.get(best) else who_met_it(best, candidates, clauses)
    best = who_is_led(best, [e for e in vehicles if not e.roles & ROLE_WORDS], clauses)
    plain = " ".join(w.norm for w in cast.words)
    implied = re.search(
        r"\b(coming|comes) (the other way|towards)|(?<!\bno )\boncoming\b|opposite (direction|lane)|other direction",
        plain,
    )
    met = any("oncoming" in v.patient.roles for v in acting.get(best, []) if v.patient is not None)
    first = bool(cast.asking and best.mentions) and best.mentions[0].word == min(
        m.word for e in cast.entities for m in e.mentions
    )
    if (
        implied
        and not told_by
        and not first
        and not met
        and not any(v.act == "oncoming" for v in acting.get(best, []))
        and best.mentions[0].word > 6
        and best is not (generic[0] if generic else None)
    ):
        return
    leave_group(best, cast, clauses)
    cast.entities.remove(best)
    if best.type != "vehicle":
        cast.ego.type, cast.ego.typed = best.type, True
    cast.ego.mentions = best.mentions
    for i, entity in list(cast.of.items()):
        if entity is best:
            cast.of[i] = cast.ego
    for event in clauses.events:
        event.text = re.sub(rf"@{best.key}\b", "@ego", event.text)
        event.whole = re.sub(rf"@{best.key}\b", "@ego", event.whole)
        event.agent = cast.ego if event.agent is best else event.agent
        event.patient = cast.ego if event.patient is best else event.patient
        event.also = [cast.ego if a is best else a for a in event.also]
