"""R: the place, from what is said of the road and from what happens there."""

import re

from c2s_engine.interpret.composing.ego_lane import ego_lane_of
from c2s_engine.interpret.placing.arms import in_another_arm
from c2s_engine.interpret.placing.compass import compass
from c2s_engine.interpret.placing.lengthwise import at_edge, wrong_way
from c2s_engine.interpret.scene import Scene, side
from c2s_engine.interpret.surroundings import place as places
from c2s_engine.interpret.surroundings.approach import start_distance
from c2s_engine.interpret.surroundings.lanes import lanes_of
from c2s_engine.interpret.what.overtakings import PART
from c2s_engine.interpret.what.towards import OPPOSITE
from c2s_engine.interpret.who.mentions import MOTOR, Entity
from c2s_engine.structure.specs import PlaceSpec

LIES_AHEAD = frozenset(("intersection", "roundabout", "crosswalk", "on_ramp", "off_ramp"))
STANDING = frozenset(("stationary", "parked"))


def compose_place(scene: Scene) -> PlaceSpec:
    """The place spec of a scene."""
    road, ego = scene.road, scene.cast.ego
    turn = next((e for e in scene.events(ego) if e.act in ("turn", "u_turn")), None)
    kind = road.kind
    at_junction = _at_junction(scene)
    if kind in (None, "straight", "curve") and at_junction:
        kind = "intersection"
    if kind == "intersection" and road.no_intersection and not at_junction and road.control is None:
        kind = None
    exits = [e for e in scene.clauses.events if e.act == "exit_road" and e.done]
    if kind == "off_ramp" and exits and not any(e.agent.ego for e in exits):
        kind = "motorway"
    manoeuvre = None
    if road.signal and (kind is None or kind == "straight" and not (road.crosswalk or road.no_intersection)):
        kind = "intersection"
    if kind == "intersection":
        if turn is not None:
            sides = [side(e) for e in scene.events(ego) if e.act == "turn"]
            manoeuvre = "u_turn" if turn.act == "u_turn" else next((s for s in sides if s), "left")
        if manoeuvre is None and _ends_before(scene):
            manoeuvre = "straight"
        manoeuvre = manoeuvre or "straight"
    _one_of_two(scene)
    needs_left, needs_right, oncoming = _neighbours(scene, kind == "intersection")
    ego_lane = ego_lane_of(scene)
    goes = next((side(e) for e in scene.events(scene.cast.ego) if e.act in ("lane_change", "cut_out")), None)
    if goes is not None and ego_lane == f"{goes}most":  # the lane that is named is where it goes
        ego_lane, needs_left, needs_right = None, needs_left or goes == "left", needs_right or goes == "right"
    lanes = road.lanes
    if (needs_left or needs_right) and (lanes or 0) < 2:
        lanes = 2
    if needs_left and needs_right:
        lanes = max(lanes or 0, 3)
    if lanes == 2 and ego_lane == "middle":
        lanes = 3
    if ego_lane is None and lanes and lanes >= 2:
        if needs_left and needs_right:
            ego_lane = "middle"
        elif needs_left:
            ego_lane = "rightmost" if lanes == 2 else None
        elif needs_right:
            ego_lane = "leftmost" if lanes == 2 else None
    if kind is None:
        kind = "curve" if road.bend else "motorway" if road.ramp else None
    on_ramp = road.ramp and _ego_on_ramp(scene)
    if on_ramp:
        kind = "on_ramp"
    if kind is None:
        kind = "straight" if road.straight or road.no_intersection else "road"
    if kind == "road" and road.crosswalk and not at_junction:
        kind = "crosswalk"
    has_oncoming = road.oncoming if road.oncoming is not None else (True if oncoming else None)
    if kind == "motorway":
        has_oncoming = None
    shoulder = True if _needs_shoulder(scene) else None
    sidewalk = True if any(scene.where(e).lane == "sidewalk" for e in scene.actors) else None
    control = road.control if kind == "intersection" else None
    if kind == "on_ramp":
        ego_lane = None
    return PlaceSpec(
        kind=kind,  # type: ignore[arg-type]
        arms=road.arms if kind == "intersection" else None,  # type: ignore[arg-type]
        control=control,  # type: ignore[arg-type]
        manoeuvre=manoeuvre,  # type: ignore[arg-type]
        lanes=min(4, lanes) if lanes else None,
        ego_lane=ego_lane,  # type: ignore[arg-type]
        oncoming=has_oncoming,
        curve=road.curve if kind == "curve" else None,  # type: ignore[arg-type]
        shoulder=shoulder,
        sidewalk=sidewalk,
        crosswalk=True if road.crosswalk else None,
        distance=_distance(scene) if kind in LIES_AHEAD else None,
        speed_limit=round(road.speed_limit, 2) if road.speed_limit and road.speed_limit <= 40 else None,
    )


def _distance(scene: Scene) -> float | None:
    """How far ego starts from the place, where that is told."""
    quantities = [s for s in scene.spans if s.kind == "quantity"]
    return start_distance(scene.plain, scene.sentences, quantities, [m.start for m in scene.cast.ego.mentions])


FROM_LANE = re.compile(
    r"\b(?:from|in|out of) (?:the |its |an? )?(?:[\w-]+ ){0,3}lane\b|\bacross (?:the )?(?:@\w+ 's lane\b|lane of @?)"
)
"""The lane from which one turns, or which one crosses."""


def _at_junction(scene: Scene) -> bool:
    """Whether what happens needs a junction: turns, runs red, crosses paths."""
    if any(e.act in ("run_red", "run_stop") and e.done for e in scene.clauses.events):
        return True
    for event in scene.clauses.events:
        if event.act == "turn" and event.done and (event.agent.ego or event.agent in scene.actors):
            text = FROM_LANE.sub("", event.text)
            if re.search(r"driveway|parking|lane|\b(?:field|yard|farm|gate)\b", text) and not re.search(
                r"intersection|junction|street|road", event.whole
            ):
                continue
            if side(event) is not None or re.search(r"across|path of|in front of", event.text):
                return not scene.road.no_intersection
    if re.search(r"unprotected (left|right)|protected left", scene.plain):
        return True
    crossing = [e for e in scene.actors if scene.where(e).lane == "crossing" and not e.person and e.type != "bicycle"]
    meets = [
        e
        for e in scene.clauses.events
        if e.act == "cross_path"
        and e.done
        and (e.patient is scene.cast.ego or e.agent in _struck(scene))
        and e.agent in scene.actors
    ]
    if any(e.agent.type in MOTOR and scene.where(e.agent).lane is None for e in meets):
        return not scene.road.no_intersection
    if any(_from_other_road(scene, e) for e in scene.actors):
        return not scene.road.no_intersection
    return (
        bool(crossing)
        and not scene.road.no_intersection
        and any(e.act in ("cross_path", "go_straight", "collide", "yield", "run_stop") for e in scene.clauses.events)
    )


def _from_other_road(scene: Scene, who: Entity) -> bool:
    """Whether one that drives across ego's direction, by the compass, turns there or meets ego: at a junction."""
    where = scene.where(who)
    if who.type not in MOTOR or where.lane not in (None, "same", "crossing") or where.rel is not None:
        return False
    acts = {e.act for e in scene.events(who)}
    meets = who in _struck(scene) or any(
        e.act == "collide" and (e.patient is None or e.patient.ego) for e in scene.events(who)
    )
    if acts & {"enter_road", "reverse", "u_turn", "stationary"} or not (meets or "turn" in acts):
        return False
    return compass(scene, who) in ("left", "right")


def _struck(scene: Scene) -> list[Entity | None]:
    """Whom ego runs into."""
    return [e.patient for e in scene.events(scene.cast.ego) if e.act == "collide"]


def _ends_before(scene: Scene) -> bool:
    return scene.does(scene.cast.ego, "stop", "stationary", "brake_stop") is not None


ON_RAMP = re.compile(
    r"on-?ramp|acceleration lane|slip road|entrance ramp|entry ramp|ramp"
    r"|merg\w+ (on)?to the (motorway|highway|freeway|interstate)|join\w* (the |a )?(motorway"
    r"|highway|freeway|interstate)"
)


def _ego_on_ramp(scene: Scene) -> bool:
    for event in scene.events(scene.cast.ego):
        whole = re.sub(r"(off|exit)[- ]?ramp", "", event.whole)
        match = ON_RAMP.search(whole)
        if match:
            return True
        if event.act == "lane_change" and re.search(r"\bmerg\w+|join", event.text):
            return True
    return False


def _one_of_two(scene: Scene) -> None:
    """Place those ahead in ego's own lane who are told to be in one of two lanes, where others are in the other one, or
    ego goes there: "two lanes; a crate lies in the right lane, a car is beside ego in the left lane"."""
    if ego_lane_of(scene) is not None or lanes_of(scene.plain, counted_only=True)[0] != 2:
        return
    there = {s: [e for e in scene.actors if scene.where(e).lane == s and _by_ego(scene, e)] for s in OPPOSITE}
    goes = next((side(e) for e in scene.events(scene.cast.ego) if e.act in ("lane_change", "cut_out")), None)
    if not any(there.values()) or not all(there[s] or goes == s for s in OPPOSITE):
        return
    shut = [s for s in OPPOSITE for e in there[s] if not e.mover or e.roles & STANDING]
    passes = [s for s in OPPOSITE for e in there[s] if scene.does(e, "overtake")]
    own = OPPOSITE[goes] if goes else shut[0] if shut else OPPOSITE[passes[0]] if passes else "right"
    for entity in there[own]:
        where = scene.where(entity)
        where.lane, where.rel = "same", where.rel or "ahead"


def _by_ego(scene: Scene, entity: Entity) -> bool:
    """Whether it is placed by ego or by nobody."""
    return scene.where(entity).of in (None, scene.cast.ego)


def _neighbours(scene: Scene, at_junction: bool) -> tuple[bool, bool, bool]:
    """Whether a lane to the left, to the right, and one of the other direction are needed; who is on one side at a
    junction, and in no lane, is in another arm."""
    left = right = oncoming = False
    shifts: dict[Entity, int] = {}
    for event in scene.clauses.events:
        if not event.done and not (event.mode == PART and "lane" in event.text):
            continue
        if event.act in ("lane_change", "cut_out") and (
            event.agent.ego or scene.where(event.agent).lane in (None, "same")
        ):
            at = shifts[event.agent] = shifts.get(event.agent, 0) + {"left": -1, "right": 1}.get(side(event) or "", 0)
            left, right = left or at < 0, right or at > 0
        if event.act == "oncoming" and not wrong_way(scene, event.agent):
            oncoming = True
    for entity in scene.actors:
        where = scene.where(entity)
        if where.of is not None and not where.of.ego:
            continue
        if not at_edge(scene, entity) and not (at_junction and in_another_arm(scene, entity)):
            left, right = left or where.lane == "left", right or where.lane == "right"
        if (where.lane == "oncoming" or "oncoming" in entity.roles) and not wrong_way(scene, entity):
            oncoming = True
    lane = ego_lane_of(scene)
    if lane == "leftmost":
        left = False
    if lane == "rightmost":
        right = False
    return left, right, oncoming


def _needs_shoulder(scene: Scene) -> bool:
    return any(scene.where(e).lane in ("parked",) for e in scene.actors)


__all__ = ["compose_place", "places"]
