"""How objects stand to each other at the start: half-planes, lanes, gaps, and who hides whom."""

import numpy as np
import shapely

from c2s_engine.dryrun.contacts import corners
from c2s_engine.dryrun.events.junctions import in_ring, is_intersection
from c2s_engine.dryrun.events.pairs import box_gap
from c2s_engine.dryrun.events.situation import NOWHERE, Seen, Situation, wrap
from c2s_engine.structure.facts import StartFact

AXIS = 0.3
"""m: who is so near to the lane's axis is on neither side of it."""
SIGHT_HEIGHT = 0.8
"""m: what is lower hides nobody."""
ROADSIDE = 15.0
FAR = 25.0
"""m beside a way beyond which somebody is not on that road: how it lies to that way says nothing."""


def starts(seen: Seen, other: Seen, situation: Situation) -> StartFact:
    """How `seen` stands to `other` at the start."""
    lanes = lane_relations(seen, other, situation)
    return StartFact(relations=relations(seen, other), lanes=lanes, gap=round(gap(seen, other, lanes), 2))


def relations(seen: Seen, other: Seen) -> tuple[str, ...]:
    """Half-planes of the other's frame, and quadrants by the side of the other's lane axis."""
    dx, dy = seen.x[0] - other.x[0], seen.y[0] - other.y[0]
    sin, cos = np.sin(other.heading[0]), np.cos(other.heading[0])
    ahead, aside = -sin * dx + cos * dy, -cos * dx - sin * dy
    found = ["ahead" if ahead > 0 else "behind", "left" if aside > 0 else "right"]
    if other.drives and other.way is not None:
        place, d = other.way.place(np.array([[seen.x[0], seen.y[0]], [other.x[0], other.y[0]]]))
        along = abs(wrap(other.heading[0] - other.way.heading_at(float(place[1])))) < np.pi / 2
        side = (float(d[0]) if along else -float(d[0])) if abs(float(d[0])) <= FAR else float(aside)
    else:
        side = float(aside)
    if abs(side) > AXIS:
        found.append(f"{found[0]}_{'left' if side > 0 else 'right'}")
    return tuple(found)


def lane_relations(seen: Seen, other: Seen, situation: Situation) -> tuple[str, ...]:
    """Every lane relation that holds."""
    index = situation.index
    mine = int(seen.lanes[0])
    found: list[str] = []
    if mine == NOWHERE:
        point = shapely.Point(seen.x[0], seen.y[0])
        if len(index.network.sidewalks) and len(index.walks.query(point, predicate="within")):
            found.append("sidewalk")
        if index.lanes and index.lanes[int(index.tree.nearest(point))].lane.polygon.distance(point) < ROADSIDE:
            found.append("roadside")
        return tuple(found)
    if int(other.lanes[0]) == NOWHERE or not other.drives:
        base = _nearest_lane(other, situation)
    else:
        base = int(other.lanes[0])
    way = set(situation.way_from(base, other).lanes) if other.way is None else set(other.way.lanes)
    way |= situation.chain(base)
    if mine in way:
        found.append("same")
    left, right = _beside(situation, way)
    if mine in left - way:
        found += ["left", "adjacent"]
    if mine in right - way:
        found += ["right", "adjacent"]
    if mine not in way and _oncoming(situation, mine, way):
        found.append("oncoming")
    if not found or found == ["oncoming"]:
        approach = _approach(seen, other, situation)
        found += [name for name in approach if name not in found]
    return tuple(dict.fromkeys(found))


def _nearest_lane(seen: Seen, situation: Situation) -> int:
    index = situation.index
    near = index.tree.query(shapely.Point(seen.x[0], seen.y[0]), predicate="dwithin", distance=ROADSIDE)
    if not len(near):
        return int(index.tree.nearest(shapely.Point(seen.x[0], seen.y[0])))
    return min((int(i) for i in near), key=lambda i: index.misfit(i, seen.x[0], seen.y[0], float(seen.heading[0])))


def _beside(situation: Situation, way: set[int]) -> tuple[set[int], set[int]]:
    """The lanes directly left and right of a way, and what continues them."""
    index = situation.index
    left = {n for i in way for n in index.lanes[i].left}
    right = {n for i in way for n in index.lanes[i].right}
    return left, right


def _oncoming(situation: Situation, lane: int, way: set[int]) -> bool:
    index = situation.index
    return any(lane in index.lanes[i].opposite or i in index.lanes[lane].opposite for i in way)


def _approach(seen: Seen, other: Seen, situation: Situation) -> tuple[str, ...]:
    """oncoming, or crossing and from which side: by the directions in which the two come to the same intersection or
    roundabout, which has a junction for each of its arms."""
    ahead, theirs = _next_junction(int(seen.lanes[0]), situation), _next_junction_of(other, situation)
    if ahead is None or theirs is None:
        return ()
    if ahead[0] != theirs[0] and not all(in_ring(situation, junction) for junction, _ in (ahead, theirs)):
        return ()
    turn = float(wrap(ahead[1] - theirs[1]))
    if abs(turn) > np.radians(135):
        return ("oncoming",)
    return ("crossing", f"crossing_{'right' if turn > 0 else 'left'}") if abs(turn) > np.radians(40) else ()


def _next_junction(lane: int, situation: Situation) -> tuple[str, float] | None:
    """(junction, heading at its line) that a lane leads to or is in."""
    index = situation.index
    info = index.lanes[lane]
    if info.junction is not None and is_intersection(situation, info.junction):
        return info.junction, float(info.headings[0])
    for one, two in zip(chain := index.path(lane, info.length + 200.0), chain[1:], strict=False):
        junction = index.lanes[two].junction
        if junction is not None and is_intersection(situation, junction):
            return junction, float(index.lanes[one].headings[-1])
    return None


def _next_junction_of(other: Seen, situation: Situation) -> tuple[str, float] | None:
    lane = int(other.lanes[0])
    return _next_junction(lane if lane != NOWHERE else _nearest_lane(other, situation), situation)


def gap(seen: Seen, other: Seen, lanes: tuple[str, ...]) -> float:
    """m between the boxes: along the other's way where both are on its road, else straight."""
    if "crossing" in lanes or other.way is None or not other.drives:
        return box_gap(seen, other)
    s, d = other.way.place(np.array([[seen.x[0], seen.y[0]], [other.x[0], other.y[0]]]))
    if abs(float(d[0])) > FAR:
        return box_gap(seen, other)

    def half(o: Seen, at: float) -> float:
        turn = abs(float(wrap(o.heading[0] - other.way.heading_at(at)))) if other.way else 0.0
        return 0.5 * (o.path.length * abs(np.cos(turn)) + o.path.width * abs(np.sin(turn)))

    return max(0.0, abs(float(s[0] - s[1])) - half(seen, float(s[0])) - half(other, float(s[1])))


def hidden_behind(seen: Seen, situation: Situation) -> tuple[str, ...]:
    """The objects that stand in the line of sight from ego at the start."""
    ego = situation.ego
    if seen is ego:
        return ()
    eye = (float(ego.x[0]), float(ego.y[0]))
    box = corners(float(seen.x[0]), float(seen.y[0]), float(seen.heading[0]), seen.path.length, seen.path.width)
    targets = [(float(seen.x[0]), float(seen.y[0])), *box]
    lines = shapely.linestrings([[eye, target] for target in targets])
    found = []
    for other in situation.objects:
        if other in (seen, ego) or other.path.height < SIGHT_HEIGHT:
            continue
        shape = shapely.Polygon(
            corners(float(other.x[0]), float(other.y[0]), float(other.heading[0]), other.path.length, other.path.width)
        )
        blocked = shapely.intersects(lines, shape)
        if blocked[0] and blocked.sum() >= 3:
            found.append(other.name)
    return tuple(found)
