"""Events at intersections: turning, going straight, running red lights and stop signs."""

from collections.abc import Iterator
from functools import lru_cache

import numpy as np
from scenic.domains.driving.roads import ManeuverType

from c2s_engine.dryrun.events.motion import fact
from c2s_engine.dryrun.events.situation import NOWHERE, Seen, Situation, wrap
from c2s_engine.dryrun.events.table import definitions
from c2s_engine.maps.extras import MapExtras
from c2s_engine.structure.facts import EventFact

RAMPS = ("on_ramp", "off_ramp", "transition")
TURNS = {
    ManeuverType.LEFT_TURN: "turn_left",
    ManeuverType.RIGHT_TURN: "turn_right",
    ManeuverType.U_TURN: "u_turn",
    ManeuverType.STRAIGHT: "go_straight",
}


def junctions(seen: Seen, situation: Situation) -> Iterator[EventFact]:
    """All events of this module that a vehicle shows."""
    if not seen.moves or not seen.drives:
        return
    found: list[EventFact] = []
    passed = visits(seen, situation)
    rings = [visit for visit in passed if in_ring(situation, visit[0])]
    found += [fact(turn, situation, step) for turn, step in _round(seen, situation, rings)]
    for junction, first, last in passed:
        turn = passage(seen, situation, junction, first, last)
        if turn and (junction, first, last) not in rings:
            found.append(fact(turn, situation, first))
        if first and seen.speed[first] > definitions()["run_red"].speed and seen.forward[first] > 0:
            road = _approach(seen, situation, first)
            if road is not None and state(situation, junction, road, first) == "red":
                found.append(fact("run_red", situation, first))
            if road is not None and stop_sign(seen, situation, junction, road, first) and not _stood(seen, first):
                found.append(fact("run_stop", situation, first))
    around = u_turn(seen)
    if around is not None and not any(f.event == "u_turn" for f in found):
        found.append(fact("u_turn", situation, around))
    yield from found


def is_intersection(situation: Situation, junction: str | None) -> bool:
    """Whether a junction is more than a merge or a diverge of ramps."""
    if junction is None:
        return False
    extras = situation.extras
    if extras is not None and junction.isdigit() and int(junction) in extras.junctions:
        return extras.junctions[int(junction)].kind not in RAMPS
    crossing = situation.index.junctions.get(junction)
    return crossing is None or any(m.type is not ManeuverType.STRAIGHT for m in crossing.maneuvers)


def beside(seen: Seen, situation: Situation) -> dict[int, str | None]:
    """The junction beside whose ways one who rides on no lane is, at each such step."""
    off = np.flatnonzero(seen.lanes == NOWHERE) if seen.moves and seen.drives else np.zeros(0, int)
    return dict(zip(off.tolist(), situation.index.junctions_around(seen.xy[off]), strict=True))


def visits(seen: Seen, situation: Situation) -> list[tuple[str, int, int]]:
    """(junction, first step, last step) of each time that it is within an intersection."""
    lanes, around = situation.index.lanes, beside(seen, situation)
    inside = [lanes[lane].junction if lane != NOWHERE else around[k] for k, lane in enumerate(seen.lanes.tolist())]
    found: list[tuple[str, int, int]] = []
    for step, junction in enumerate(inside):
        if junction is None:
            continue
        if found and found[-1][0] == junction and step - found[-1][2] <= 20:
            found[-1] = (junction, found[-1][1], step)
        else:
            found.append((junction, step, step))
    return [visit for visit in found if is_intersection(situation, visit[0])]


def in_ring(situation: Situation, junction: str) -> bool:
    """Whether a junction is one of those of a roundabout."""
    extras = situation.extras
    known = extras is not None and junction.isdigit() and extras.junctions.get(int(junction))
    return bool(known and known.kind == "roundabout")


def _round(seen: Seen, situation: Situation, rings: list[tuple[str, int, int]]) -> Iterator[tuple[str, int]]:
    """(event, step) of its ways through roundabouts, each taken as one junction: by the direction in which it leaves,
    at the step at which it comes in; of one that is in the ring at the start by whether it leaves it."""
    if not rings or situation.extras is None:
        return
    ring, lanes = _ring_roads(situation.extras), situation.index.lanes
    ends = {n: road for name in {r[0] for r in rings} for n, road in _ends(situation.index, name).items()}
    inside: list[bool] = []
    for lane in seen.lanes.tolist():  # who is off the lanes is where it was; a way out of the ring is outside
        there = lane != NOWHERE and int(ends.get(lane, lanes[lane].road)) in ring
        inside.append(there if lane != NOWHERE or not inside else inside[-1])
    entered: int | None = None
    for step in (k for k in range(1, len(inside)) if inside[k] != inside[k - 1]):
        if inside[step]:
            entered = step
            continue
        lane = int(seen.lanes[step])
        heading = float(lanes[lane].headings[-1]) if lane in ends else float(seen.heading[step])
        if entered is None:
            yield "turn_right", step
        elif not any(inside[step : step + 10]):
            turned = float(np.unwrap(seen.heading[entered : step + 1])[-1] - seen.heading[entered])
            yield _direction(turned + float(wrap(heading - seen.heading[step]))), entered
    if all(inside):
        yield from (("go_straight", first) for _, first, last in rings if last + 1 < len(inside))


def _ring_roads(extras: MapExtras) -> set[int]:
    """The one-way roads that lead from one junction of a roundabout to the next."""
    known = [j for j in extras.junctions.values() if j.kind == "roundabout"]
    return {r for a in known for b in known if a is not b for r in set(a.outgoing) & set(b.incoming) - set(a.incoming)}


def arms_of_ring(extras: MapExtras, junction: int) -> int:
    """How many roads lead into the roundabout of a junction: it has a junction for each."""
    round_, found = _ring_roads(extras), {junction}
    while True:
        roads = {r for j in found for r in (*extras.junctions[j].incoming, *extras.junctions[j].outgoing)} & round_
        more = {i for i, j in extras.junctions.items() if roads & {*j.incoming, *j.outgoing}} - found
        if not more:
            return len(found)
        found |= more


@lru_cache(maxsize=64)
def _ends(index, junction: str) -> dict[int, str]:  # type: ignore[no-untyped-def]
    """The roads to which the ways of a junction lead."""
    ways = index.junctions[junction].maneuvers if junction in index.junctions else ()
    return {index.number[m.connectingLane.uid]: str(m.endLane.road.id) for m in ways if m.connectingLane is not None}


def _direction(turned: float) -> str:
    """The event of one whose heading has changed by so much (rad, to the left) over a junction."""
    if abs(turned) >= np.radians(150):
        return "u_turn"
    if abs(turned) >= np.radians(definitions()["turn_left"].turn):
        return "turn_left" if turned > 0 else "turn_right"
    return "go_straight"


def passage(seen: Seen, situation: Situation, junction: str, first: int, last: int) -> str | None:
    """Which way it takes: by the connecting lane if it is halfway through it, else by its change of heading."""
    within = [int(lane) for lane in seen.lanes[first : last + 1] if lane != NOWHERE]
    ways = _maneuvers(situation, junction)
    limits = definitions()["turn_left"]
    if within:
        lane = max(set(within), key=within.count)
        info = situation.index.lanes[lane]
        steps = [s for s in range(first, last + 1) if seen.lanes[s] == lane]
        progress, _ = info.project_many(seen.xy[steps])
        onward = float(progress[-1]) / max(info.length, 0.1)
        straying = len(set(within)) > 3
        fits = abs(float(wrap(seen.heading[steps[-1]] - info.heading_at(float(progress[-1]))))) < np.radians(50)
        if lane in ways and fits and not straying:
            return TURNS.get(ways[lane]) if onward >= limits.half else None
    turn = _direction(float(np.unwrap(seen.heading[first : last + 1])[-1] - seen.heading[first]))
    return turn if turn != "go_straight" or last < seen.until else None


def _maneuvers(situation: Situation, junction: str) -> dict[int, ManeuverType]:
    return _ways(situation.index, junction)


@lru_cache(maxsize=256)
def _ways(index, junction: str) -> dict[int, ManeuverType]:  # type: ignore[no-untyped-def]
    crossing = index.junctions.get(junction)
    if crossing is None:
        return {}
    return {index.number[m.connectingLane.uid]: m.type for m in crossing.maneuvers if m.connectingLane is not None}


def u_turn(seen: Seen) -> int | None:
    """The step at which it has turned round within a short way."""
    limits = definitions()["u_turn"]
    heading = np.unwrap(seen.heading)
    start = 0
    for step in range(0, len(heading), 3):
        while seen.travelled[step] - seen.travelled[start] > limits.within:
            start += 1
        if abs(heading[step] - heading[start : step + 1]).max() >= np.radians(limits.turn):
            return step
    return None


def _approach(seen: Seen, situation: Situation, step: int) -> str | None:
    """The road by which it comes to the junction."""
    for lane in seen.lanes[:step][::-1]:
        if lane != NOWHERE:
            info = situation.index.lanes[lane]
            return info.road if info.junction is None else None
    return None


def state(situation: Situation, junction: str, road: str, step: int) -> str | None:
    """What the light of an approach shows at a step (None: there is no light)."""
    shown = None
    now = step * situation.step + 1e-6
    for time, where, approach, colour in situation.recording.lights:
        if time > now:
            break
        if (where, approach) == (junction, road):
            shown = colour
    return shown


def stop_sign(seen: Seen, situation: Situation, junction: str, road: str, step: int) -> bool:
    """Whether a stop sign, of the map or a prop, faces who comes to a junction by a road."""
    extras = situation.extras
    if extras is not None and junction.isdigit() and extras.control(int(junction), int(road)) == "stop":
        return True
    return any(
        o.path.role.startswith("stop_sign") and np.hypot(o.x[0] - seen.x[step], o.y[0] - seen.y[step]) < 20.0
        and faces(o, seen.x[0], seen.y[0])
        for o in situation.objects
    )  # fmt: skip


def faces(sign: Seen, x: float, y: float) -> bool:
    """Whether a sign prop is turned towards a point (by less than 60 degrees)."""
    bearing = np.arctan2(-(x - sign.x[0]), y - sign.y[0])
    return bool(abs(wrap(sign.heading[0] - bearing)) < np.radians(60))


def _stood(seen: Seen, step: int) -> bool:
    limits = definitions()["run_stop"]
    near = seen.travelled[step] - seen.travelled[: step + 1] <= limits.before
    return bool((seen.speed[: step + 1][near] < limits.standing).any())
