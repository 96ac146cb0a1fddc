"""Who is ego where nobody is called so."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import URGENT
from c2s_engine.interpret.reading.askers import bystanding
from c2s_engine.interpret.roles.among_others import anchors, crossed, cut_off, who_is_led, who_met_it
from c2s_engine.interpret.roles.aside import (
    AHEAD,
    IS_AHEAD,
    after,
    beside_nobody,
    from_aside,
    only_hides,
    seen_by_one,
)
from c2s_engine.interpret.roles.at_stops import at_a_stop
from c2s_engine.interpret.roles.bare import ROLE_WORDS, bare_first
from c2s_engine.interpret.roles.paired import leave_group, one_of_both
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


EMERGES = re.compile(
    r"@\w+ (?:suddenly )?(?:come|pull|drive|emerge|turn|shoot) out of (?:it|there)\b"
    r"|@\w+ (?:suddenly )?(?:appear|emerge|come) (?:out )?from behind\b"
)
HALTED = frozenset(("stop", "stationary", "brake_stop"))
OPPOSITE = re.compile(r"\b(?:in|on) the (?:opposite|oncoming|opposing|other) (?:lane|side|carriageway)\b")
FROM_WHERE = re.compile(r"\b(?:from|out of) (?:where|which) .*\b(?:emerg|appear|com|approach|turn)\w*")


def _comes_into_view(entity: Entity, cast: Cast, events: list[Event]) -> bool:
    """Whether one comes out from behind another, or from a place that is named: somebody else, ego, sees it."""
    for mention in entity.mentions:
        word = cast.words[mention.word]
        before = [w.norm for w in cast.words[max(0, word.i - 5) : word.i + 5] if w.sentence == word.sentence]
        if FROM_WHERE.search(" ".join(before)):
            return True
    first = cast.words[entity.mentions[0].word]
    new = {"a", "an"} & {w.norm for w in cast.words[max(0, first.i - 2) : first.i]}
    there = HALTED | {"travel", "approach"} if new else HALTED
    return any(EMERGES.search(e.whole) or e.act in there and OPPOSITE.search(e.whole) for e in events)


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


def _all_from_one_side(event: Event, vehicles: list[Entity]) -> bool:
    """Whether all who drive come from the same side, told together: ego, who meets them, is none of them."""
    together = {event.agent, *event.also}
    told = event.act in ("approach", "travel") and len(together) > 1 and together >= {*vehicles}
    return told and re.search(r"\bfrom the (?:left|right)\b", event.whole) is not None


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


def _of_parked(entity: Entity, clauses: Clauses) -> bool:
    """Whether it is one of several that only stand there ("two cars are parked; one is on the left")."""
    acts = [e for e in clauses.events if e.agent is entity.group and e.done] if entity.group is not None else []
    return bool(acts) and all(e.act == "stationary" and "park" in e.text for e in acts)


def _rests(entity: Entity, acts: list[Event]) -> bool:
    """Whether it only stands there."""
    return bool(entity.roles & {"parked", "stationary"}) or bool(acts) and all(v.act == "stationary" for v in acts)


def _held_up(entity: Entity, acts: list[Event], clauses: Clauses) -> bool:
    """Whether it only stands in traffic, for a light or a sign, and is run into: it may be whom the text is about."""
    waits = any(HELD.search(v.whole) for v in acts)
    return waits and any(v.act == "collide" and v.patient is entity and v.done for v in clauses.events)


def choose_ego(cast: Cast, clauses: Clauses) -> None:
    """Where nobody is called ego: the vehicle that the text is about, if there is one besides the others."""
    if cast.ego.mentions:
        return
    vehicles = [
        e for e in cast.entities if e.type in MOTOR and e.count == 1 and _on_its_own(e) and not _of_parked(e, clauses)
    ]
    told_by = cast.me is not cast.ego or bystanding(" ".join(w.norm for w in cast.words))
    firsts = [e.mentions[0].word for e in vehicles]
    if not told_by and any(IS_AHEAD.match(after(i, cast)) and not seen_by_one(i, cast) for i in firsts):
        return  # of somebody who is not named
    acting = {e: [v for v in clauses.events if v.agent is e and v.done] for e in vehicles}
    if not told_by and any(_all_from_one_side(v, vehicles) for v in clauses.events):
        return
    candidates = []
    for entity in vehicles:
        if (
            entity.roles & ROLE_WORDS
            or (entity.noun or entity.label) in NEVER_EGO
            or not told_by
            and (
                _passes_nobody(acting[entity])
                or "following" not in entity.roles
                and (
                    beside_nobody(entity, cast)
                    and not cut_off(entity, clauses)
                    or entity.group is not None
                    and beside_nobody(entity.group, cast)
                    or any(v.agent is entity and AHEAD.match(v.text) for v in clauses.events)
                )
            )
        ):
            continue
        head = cast.words[entity.mentions[0].word]
        if not told_by and len(vehicles) == 1 and any(from_aside(m.word, cast) for m in entity.mentions):
            continue
        before = cast.words[head.i - 1].norm if head.i else ""
        told_apart = {before, *(cast.words[c].norm for c in head.children)} & {"another", "other"}
        if told_apart and not all(_rests(e, acting[e]) for e in vehicles[: vehicles.index(entity)]):
            continue
        if "other" in told_apart and len(vehicles) == 1 and not told_by:
            continue
        if not told_by and _comes_into_view(entity, cast, acting[entity]):
            continue
        told = [v for v in acting[entity] if not v.whole.startswith("there be ")] or acting[entity]
        acts = ["stationary" if at_a_stop(v) else v.act for v in told]
        if any(v.act == "follow" and v.patient is None and re.search(r"\bbehind\b", v.text) for v in acting[entity]):
            continue  # "a truck follows 20 m behind": behind ego
        if any(v.act in TOWARDS and v.agent is cast.ego and v.patient is entity for v in clauses.events):
            continue
        if not acts and not any(v.patient is entity for v in clauses.events) or only_hides(entity, acts, clauses):
            continue
        held = _held_up(entity, acting[entity], clauses)
        if acts and not EGO_LIKE & set(acts) and not held:
            continue
        if (
            {"cut_in", "enter_road"} & set(acts)
            and not _runs_down(entity, clauses)
            or (acts and all(a == "stationary" for a in acts) and not held)
            or any(v.act == "reverse" and re.search(r"driveway|parking|garage", v.whole) for v in acting[entity])
        ):
            continue
        if (
            any(
                v.passive and v.patient is not None
                for v in clauses.events
                if v.agent is entity and v.act == "stationary"
            )
            or _by_whom(cast, entity)
        ) and not _runs_down(entity, clauses):
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
        candidates = one_of_both(cast, clauses)
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
    others = [e for e in cast.entities if e not in candidates]
    best = next((e for e in candidates if "following" in e.roles), candidates[0])
    best = best if acting.get(best) else who_met_it(best, candidates, clauses)
    best = who_is_led(best, [e for e in vehicles if not e.roles & ROLE_WORDS], clauses)
    hit = {v.patient for v in clauses.events if v.act in ("collide", "overtake", "follow", "yield") and v.agent is best}
    if (
        len(candidates) == 1
        and not others
        and any(v.act in ("brake", "cut_in", "enter_road") for v in acting.get(best, []))
        and not hit
    ) and re.search(r"\b(in front|ahead)\b", " ".join(w.norm for w in cast.words)):
        return
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
        and not anchors(best, clauses)
        and not crossed(best, clauses)
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
