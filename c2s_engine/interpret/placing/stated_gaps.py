"""The gap of an object at the start: told with its place, as a time headway, or as a distance of its own sentence."""

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.scan import Span
from c2s_engine.interpret.scene import Scene
from c2s_engine.structure.specs import EgoSpec

NAMED = re.compile(
    r"(?<!lateral )(?<!side )(?<!braking )(?<!stopping )(?<!sideways )"
    r"(?<!over a )(?<!within a )(?<!after a )\b(?:gap|distance|headway|separation|spacing|thw)"
    r"(?P<whose>(?: (?:between|to|from|towards?|behind|in front|ahead|with|of (?=the |ego)|and)[^.;,:]{0,60}?)?)"
    r"(?: of| is| was| are| being| equals?| at|:|=)? ?(?:about |around |at least |roughly |approximately |only )?$"
)
TIMED = re.compile(r"[ -]?(?:(?:time|following) )?(?:gap|headway|distance)\b| (?:behind|ahead|in front)\b")
"""What comes behind a time (s) that two are apart."""
REACHED = re.compile(r"\bto(?: an?| about)* $")
"""What comes before one to which that changes only later."""
MARGIN = (1.02, 1.2)
"""A gap by time is measured between the bumpers: a little more than the way driven in it."""


def gap_of(scene: Scene, entity: Entity, position: str, ego: EgoSpec) -> tuple[float, float] | None:
    """Between the bounding boxes, m: as told, else as a time says."""
    where = scene.where(entity)
    if where.gap is not None:
        return where.gap
    lengthwise = position in ("ahead", "behind")
    if position == "ahead" and (ttc := _start_ttc(scene)) is not None:
        speed, own = scene.speeds.get(scene.cast.ego), scene.speeds.get(entity)
        if speed and not any(scene.where(e).gap for e in scene.actors):
            closing = max(1.0, speed[0] - (own[0] if own else 0.0))
            return closing * ttc * MARGIN[0], closing * ttc * MARGIN[1]
    if lengthwise and not any(scene.where(e).gap for e in scene.actors):
        return _by_name(scene, entity, ego)
    return None


def _by_time(scene: Scene, entity: Entity, seconds: float, ego: EgoSpec) -> tuple[float, float] | None:
    """The gap of a time headway, or of a time to collision where the text speaks of one."""
    assumed = ego.speed if isinstance(ego.speed, int | float) else sum(ego.speed) / 2 if ego.speed else None
    own = scene.speeds.get(entity)
    told = scene.speeds.get(scene.cast.ego) or own
    closing = (told[0] + told[1]) / 2 if told else assumed
    if not closing:
        return None
    return closing * seconds * MARGIN[0], closing * seconds * MARGIN[1]


def _by_name(scene: Scene, entity: Entity, ego: EgoSpec) -> tuple[float, float] | None:
    """The gap that a noun names: "a distance of 20 m", "the headway to the car in front is 0.9 s"."""
    moments = {e.trigger["at"] for e in scene.clauses.events if e.trigger and e.done and "at" in e.trigger}
    for span in scene.spans:
        dimension = span.data.get("dimension") if span.kind == "quantity" else None
        if dimension not in ("distance", "time") or span.start in moments:
            continue
        before = scene.plain[max(0, span.start - 90) : span.start]
        match = NAMED.search(before)
        timed = dimension == "time" and TIMED.match(scene.plain[span.end :]) and not REACHED.search(before)
        of = span.start - len(before) + match.start("whose") if match else span.start if timed else None
        if of is None or not _may_be_of(scene, entity, span, of):
            continue
        if dimension == "distance":
            return span.data["low"], span.data["high"]
        return _by_time(scene, entity, span.data["low"], ego)
    return None


def _may_be_of(scene: Scene, entity: Entity, span: Span, start: int) -> bool:
    """Whether the parties that are named from there to a distance, if any, are ego and that one."""
    named = {e for i, e in scene.cast.of.items() if start <= scene.words[i].start < span.start and not e.ego}
    if not named:  # "a car comes towards it; the initial distance is 400 m"
        at = next((w.sentence for w in scene.words if w.start >= span.start), None)
        named = {e for i, e in scene.cast.of.items() if scene.words[i].sentence == at and not e.ego and e.mover}
        return not named or entity in named
    return named == {entity}


def _start_ttc(scene: Scene) -> float | None:
    """The time to collision at the start, where it is no trigger of what another does."""
    for span in scene.spans:
        if span.kind == "quantity" and span.data["dimension"] == "time":
            near = scene.plain[max(0, span.start - 45) : span.end + 35]
            used = any(
                e.trigger
                and e.trigger["kind"] == "ttc"
                and (not e.agent.ego or e.trigger.get("at") == span.start)
                and e.act not in ("travel", "stationary")
                and e.trigger["value"] == span.data["low"]
                for e in scene.clauses.events
            )
            if re.search(r"\bttc\b|time[- ]to[- ](collision|contact)", near) and not used:
                return span.data["low"]
    return None
