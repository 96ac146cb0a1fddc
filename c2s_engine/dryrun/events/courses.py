"""Where each object is on the road over time, what ego can see of it, and who touches whom where."""

from functools import partial
from itertools import groupby

import numpy as np
import shapely

from c2s_engine.dryrun.contacts import corners
from c2s_engine.dryrun.events.junctions import beside, is_intersection, stop_sign
from c2s_engine.dryrun.events.situation import NOWHERE, Seen, Situation, wrap
from c2s_engine.dryrun.events.starts import SIGHT_HEIGHT
from c2s_engine.structure.facts import ContactFact, Course, Mark, Stay

EVERY = 2
"""Steps from one value of a course to the next."""
TALLER = 0.5
"""m: who is so much taller than what stands before it is seen above it."""
BEYOND = 60.0
"""m of an object's way before and behind what it drives on which marks are kept."""

TO_CROSSWALK = 1.0
"""m from a stop line to its crosswalk."""


def courses(situation: Situation) -> dict[str, Course]:
    """The course of every object by its name, up to its first contact."""
    lie = LaneRelations(situation)
    return {seen.name: _course(seen, situation, lie) for seen in situation.objects}


def _course(seen: Seen, situation: Situation, lie: "LaneRelations") -> Course:
    ego = situation.ego

    def kept(values: np.ndarray) -> tuple[float, ...]:
        return tuple(np.round(values[::EVERY], 2).tolist())

    own = seen.placed(seen) if seen.way is not None and seen.drives else (seen.travelled, np.zeros(len(seen.x)))
    of_ego = ego.placed(seen) if ego.way is not None else (np.zeros(0), np.zeros(0))
    return Course(
        every=EVERY * situation.step,
        along=kept(own[0]),
        aside=kept(own[1]),
        ego_along=kept(of_ego[0]),
        ego_aside=kept(of_ego[1]),
        stays=tuple(_stays(seen, situation, lie)),
        marks=tuple(_marks(seen, situation)) if seen.drives else (),
        sight=_sight(seen, situation) if seen is not ego else (),
    )


class LaneRelations:
    """How each lane lies to ego's way."""

    def __init__(self, situation: Situation) -> None:
        self.situation, index = situation, situation.index
        way = situation.ego.way
        self.own = set(way.lanes) if way else set()
        if self.own and situation.ego.start_lane is not None:
            self.own |= situation.chain(situation.ego.start_lane.index)
        self.left = self._beside("left")
        self.right = self._beside("right")
        self.oncoming = {o for i in self.own | self.left | self.right for o in index.lanes[i].opposite}
        self.junctions = {index.lanes[i].junction for i in self.own} - {None}
        self._known: dict[int, str] = {}

    def _beside(self, side: str) -> set[int]:
        found: set[int] = set()
        todo = set(self.own)
        while todo:
            todo = {n for i in todo for n in getattr(self.situation.index.lanes[i], side)} - found - self.own
            found |= todo
        return found

    def of(self, lane: int) -> str:
        if lane not in self._known:
            self._known[lane] = self._of(lane)
        return self._known[lane]

    def _of(self, lane: int) -> str:
        for name, lanes in (
            ("own", self.own), ("left", self.left), ("right", self.right), ("oncoming", self.oncoming)
        ):  # fmt: skip
            if lane in lanes:
                return name
        index = self.situation.index
        ahead = {index.lanes[i].junction for i in index.path(lane, index.lanes[lane].length + 1.0)} - {None}
        behind = {index.lanes[b].junction for b in index.previous.get(lane, ())} - {None}
        return "crossing" if self.junctions & (ahead | behind) else "other"


def _stays(seen: Seen, situation: Situation, lie: LaneRelations) -> list[Stay]:
    index, around = situation.index, beside(seen, situation)
    found = []
    for lane, first, last in seen.runs:
        time = round(first * situation.step, 2)
        if lane != NOWHERE:
            info = index.lanes[lane]
            turn = wrap(seen.heading[first] - info.heading_at(info.project(seen.x[first], seen.y[first])[0]))
            kind = "junction" if is_intersection(situation, info.junction) else "lane"
            against = bool(abs(turn) > np.pi / 2)
            found.append(Stay(time=time, lane=lane, kind=kind, to_ego=lie.of(lane), against=against))
            continue
        for junction, steps in groupby(range(first, last + 1), around.get):
            found.append(_off_lanes(seen, situation, next(steps), junction, lie))
    return found


def _off_lanes(seen: Seen, situation: Situation, step: int, junction: str | None, lie: LaneRelations) -> Stay:
    """What is under one on no lane from a step on; who rides past a junction's ways is in it."""
    index, time = situation.index, round(step * situation.step, 2)
    if is_intersection(situation, junction):
        return Stay(time=time, kind="junction", to_ego="crossing" if junction in lie.junctions else "other")
    point = shapely.Point(seen.x[step], seen.y[step])
    under = [int(i) for i in index.off_road.query(point, predicate="within")]
    shoulder = bool(under) and min(under) < len(index.network.shoulders)
    return Stay(time=time, kind="off" if not under else "shoulder" if shoulder else "sidewalk")


def _marks(seen: Seen, situation: Situation) -> list[Mark]:
    """Junctions with the lines before them, and crosswalks, on its own way."""
    way, index, extras = seen.way, situation.index, situation.extras
    if way is None:
        return []
    found: list[Mark] = []
    for k, lane in enumerate(way.lanes):
        info = index.lanes[lane]
        if not is_intersection(situation, info.junction):
            if info.junction is not None and 0 < k < len(way.lanes) - 1:  # where a ramp joins a road
                start, end = float(way.starts[k]) + info.length, float(way.starts[k + 1])
                end += index.lanes[way.lanes[k + 1]].length
                found.append(Mark(kind="merge", start=round(start, 2), end=round(end, 2), name=str(info.junction)))
            continue
        start, end = float(way.starts[k]), float(way.starts[k]) + info.length
        if found and found[-1].name == info.junction and found[-1].kind == "junction":
            found[-1] = found[-1].model_copy(update={"end": round(end, 2)})
            continue
        if k:
            road = index.lanes[way.lanes[k - 1]].road
            found.append(Mark(kind="line", start=round(start, 2), end=round(start, 2), name=f"{info.junction}/{road}",
                              control=_control(seen, situation, str(info.junction), road)))  # fmt: skip
        found.append(Mark(kind="junction", start=round(start, 2), end=round(end, 2), name=str(info.junction)))
    line = shapely.LineString(way.points)
    for crosswalk in extras.crosswalks if extras else ():
        shape = shapely.Polygon(crosswalk.polygon)
        if shape.intersects(line):
            at = [line.project(shapely.Point(p)) for p in shapely.get_coordinates(shape.intersection(line))]
            found.append(Mark(kind="crosswalk", start=round(min(at), 2), end=round(max(at), 2)))
    found = [_before_crosswalk(m, found) if m.kind == "line" else m for m in found]
    s, _ = seen.placed(seen)
    low, high = float(s.min()) - BEYOND, float(s.max()) + BEYOND
    return [m for m in found if m.end >= low and m.start <= high]


def _before_crosswalk(line: Mark, marks: list[Mark]) -> Mark:
    """The stop line where the junction begins, before the crosswalk that lies there."""
    there = [m.start for m in marks if m.kind == "crosswalk" and line.start - 12 < m.end < line.start + 1]
    at = round(min(there) - TO_CROSSWALK, 2) if there else line.start
    return line.model_copy(update={"start": at, "end": at})


def _control(seen: Seen, situation: Situation, junction: str, road: str) -> str:
    extras = situation.extras
    known = extras.control(int(junction), int(road)) if extras and junction.isdigit() and road.isdigit() else None
    if known is not None:
        return known
    inside = [k for k, lane in enumerate(seen.lanes.tolist()) if lane != NOWHERE
              and situation.index.lanes[lane].junction == junction]  # fmt: skip
    at = inside[0] if inside else len(seen.x) - 1
    return "stop" if stop_sign(seen, situation, junction, road, at) else ""


def _sight(seen: Seen, situation: Situation) -> tuple[tuple[float, bool], ...]:
    """When ego can see it: its middle, or half of its corners, past the boxes of all others."""
    ego = situation.ego
    steps = np.arange(0, min(len(ego.x), len(seen.x)), EVERY)
    eye = ego.xy[steps]
    sin, cos = np.sin(seen.heading[steps]), np.cos(seen.heading[steps])
    hidden = np.zeros((5, len(steps)), bool)
    for k, (fore, side) in enumerate(((0, 0), (0.5, 0.5), (0.5, -0.5), (-0.5, 0.5), (-0.5, -0.5))):
        fx, fy = fore * seen.path.length, side * seen.path.width
        aim = seen.xy[steps] + np.column_stack([-sin * fx + cos * fy, cos * fx + sin * fy])
        for other in situation.objects:
            low = other.path.height < max(SIGHT_HEIGHT, seen.path.height - TALLER)
            if other not in (seen, ego) and not low:
                hidden[k] |= _between(other, steps, eye, aim)
    visible = ~hidden[0] | ((~hidden[1:]).sum(axis=0) >= 2)
    changes = np.concatenate([[0], np.flatnonzero(np.diff(visible)) + 1])
    return tuple((round(float(steps[c]) * situation.step, 2), bool(visible[c])) for c in changes)


def _between(other: Seen, steps: np.ndarray, eye: np.ndarray, aim: np.ndarray) -> np.ndarray:
    """Whether the box of another cuts the line from the eye to the aim, at each step."""
    at = np.minimum(steps, len(other.path.x) - 1)
    sin, cos = np.sin(other.path.heading[at]), np.cos(other.path.heading[at])
    middle = other.path.xy[at]

    def inside(points: np.ndarray) -> np.ndarray:
        dx, dy = (points - middle).T
        return np.column_stack([-sin * dx + cos * dy, cos * dx + sin * dy])

    start, way = inside(eye), inside(aim) - inside(eye)
    half = np.array([other.path.length / 2, other.path.width / 2])
    with np.errstate(divide="ignore", invalid="ignore"):
        one, two = (-half - start) / way, (half - start) / way
    enters = np.nanmax(np.minimum(one, two), axis=1)
    leaves = np.nanmin(np.maximum(one, two), axis=1)
    return (enters <= leaves) & (leaves >= 0) & (enters <= 1)


def contacts(situation: Situation) -> tuple[ContactFact, ...]:
    """First contacts of pairs, with the parts that touch."""
    found = []
    for time, i, j in situation.recording.contacts:
        one, other = situation.objects[i].path, situation.objects[j].path
        at = min(situation.last, round(time / situation.step))
        before = max(0, at - 1)
        box = partial(_box, step=at)
        shared = shapely.intersection(box(one).buffer(0.15), box(other).buffer(0.15))
        point = shared.centroid if not shared.is_empty else shapely.Point(*(one.xy[at] + other.xy[at]) / 2)
        closing = float(np.hypot(one.vx[before] - other.vx[before], one.vy[before] - other.vy[before]))
        at_one, at_other = _seen_from(one, at, point), _seen_from(other, at, point)
        found.append(ContactFact(time=round(time, 2), one=one.name, other=other.name, closing=round(closing, 2),
                                 part_one=_part(one, at_one), part_other=_part(other, at_other),
                                 at_one=at_one, at_other=at_other))  # fmt: skip
    return tuple(found)


def _box(path, step: int) -> shapely.Polygon:  # type: ignore[no-untyped-def]
    return shapely.Polygon(corners(path.x[step], path.y[step], path.heading[step], path.length, path.width))


def _seen_from(path, step: int, point: shapely.Point) -> tuple[float, float]:  # type: ignore[no-untyped-def]
    """m by which a point is ahead of and to the left of the middle of a box."""
    dx, dy = point.x - path.x[step], point.y - path.y[step]
    sin, cos = np.sin(path.heading[step]), np.cos(path.heading[step])
    return round(float(-sin * dx + cos * dy), 2), round(float(-cos * dx - sin * dy), 2)


def _part(path, point: tuple[float, float]) -> str:  # type: ignore[no-untyped-def]
    """The side of a box that a point is nearest to."""
    ahead, aside = point
    if path.length / 2 - abs(ahead) <= path.width / 2 - abs(aside):
        return "front" if ahead > 0 else "rear"
    return "left" if aside > 0 else "right"
