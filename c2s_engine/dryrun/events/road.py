"""The road on ego's path: lanes, intersections, bends, lights and signs, crosswalks."""

import numpy as np
import shapely

from c2s_engine.dryrun.events.junctions import arms_of_ring, faces, in_ring, is_intersection, state
from c2s_engine.dryrun.events.situation import NOWHERE, Seen, Situation
from c2s_engine.structure.facts import RoadFacts

AHEAD = 100.0
IN_FRONT = 6.0
"""m ahead of where ego comes to in the end that are on its path, however far that is: what it stands on."""
NEAR_LIGHT = 30.0
BESIDE = 10.0
"""m: what is so near to the path is on or beside it."""
ABREAST = 20.0
"""m: the widest carriageway, from the path to its far side."""


class EgoPath:
    """What ego drives, and at least 100 m of its lane's continuation from its start on."""

    def __init__(self, situation: Situation) -> None:
        self.situation, ego = situation, situation.ego
        self.ego = ego
        index = situation.index
        self.length = max(AHEAD, float(ego.travelled[-1]))
        start = int(ego.lanes[0])
        if start == NOWHERE:
            start = int(index.tree.nearest(shapely.Point(ego.x[0], ego.y[0])))
        self.start = start
        driven = [lane for lane, _, _ in ego.runs if lane != NOWHERE] or [start]
        last = index.lanes[driven[-1]]
        s = last.project(ego.x[-1], ego.y[-1])[0]
        rest = max(IN_FRONT, AHEAD - float(ego.travelled[-1]))
        onward = index.path(driven[-1], rest, start=s)
        self.lanes = list(dict.fromkeys(driven + onward[1:]))
        points = ego.xy[np.concatenate([[True], np.diff(ego.travelled) > 1e-3])]
        line = index.line(onward)
        step = np.hypot(*np.diff(line, axis=0).T)
        along = np.concatenate([[0.0], np.cumsum(step)])
        ss = np.append(np.arange(s + 1.0, min(s + rest, along[-1]), 1.0), min(s + rest, along[-1]))
        points = np.concatenate(
            [points, np.column_stack([np.interp(ss, along, line[:, 0]), np.interp(ss, along, line[:, 1])])]
        )
        self.points = points if len(points) > 1 else np.concatenate([points, points + 0.1])
        self.line = shapely.LineString(self.points)

    def facts(self) -> RoadFacts:
        """All of FORMAT.md's `road`."""
        situation, index = self.situation, self.situation.index
        crossing = self.first_intersection()
        lane = index.lanes[self.start]
        turn, before = self.turning()
        limit = situation.extras.limit(int(lane.road)) if situation.extras and lane.road.isdigit() else None
        return RoadFacts(
            lanes_same_direction=len(self.carriageway()),
            oncoming_lane=self._oncoming(),
            intersection=self._arms(crossing),
            signalized=crossing is not None and self._signalized(crossing),
            curve=bool(turn > np.radians(20)),
            straight=bool(before < np.radians(10)),
            speed_limit_kmh=None if limit is None else round(limit * 3.6, 1),
        )

    def carriageway(self) -> set[int]:
        """The lanes in ego's direction on its road, where it starts."""
        index = self.situation.index
        base = self.start
        if index.lanes[base].junction is not None and index.lanes[base].next:
            base = index.lanes[base].next[0]
        found, todo = {base}, [base]
        x, y = (float(self.ego.x[0]), float(self.ego.y[0])) if base == self.start else index.lanes[base].point_at(1.0)
        while todo:
            info = index.lanes[todo.pop()]
            s, _ = info.project(x, y)
            at = info.point_at(min(max(s, 0.5), info.length - 0.5))
            section = info.lane.sectionAt(at) if len(info.lane.sections) > 1 else info.lane.sections[0]
            for other in (section._laneToLeft, section._laneToRight) if section is not None else ():
                number = index.number.get(other.lane.uid) if other is not None else None
                if number is not None and other.isForward == section.isForward and number not in found:
                    found.add(number)
                    todo.append(number)
        return found

    def _oncoming(self) -> bool:
        index = self.situation.index
        ego = shapely.Point(self.ego.x[0], self.ego.y[0])
        mine = self.carriageway()
        for lane in mine:
            for other in index.lanes[lane].opposite:
                if index.lanes[lane].lane.polygon.distance(index.lanes[other].lane.polygon) < 0.7 \
                        and index.lanes[other].lane.polygon.distance(ego) < 25.0:  # fmt: skip
                    return True
        return False

    def first_intersection(self) -> str | None:
        """The first intersection on the path."""
        lanes = self.situation.index.lanes
        for lane in self.lanes:
            if is_intersection(self.situation, lanes[lane].junction) and lanes[lane].lane.polygon.intersects(self.line):
                return lanes[lane].junction
        return None

    def _arms(self, junction: str | None) -> str:
        if junction is None:
            return "none"
        extras = self.situation.extras
        if extras is not None and in_ring(self.situation, junction):
            arms = arms_of_ring(extras, int(junction))
            return "3way" if arms == 3 else "4way" if arms == 4 else "other"
        crossing = self.situation.index.junctions[junction]
        return "3way" if crossing.is3Way else "4way" if crossing.is4Way else "other"

    def _signalized(self, junction: str) -> bool:
        extras = self.situation.extras
        if extras is None:
            return bool(self.situation.index.junctions[junction].isSignalized)
        return any(c.kind == "signal" and str(c.junction) == junction for c in extras.controls)

    def turning(self) -> tuple[float, float]:
        """(rad that the path turns outside intersections, rad that it turns before any)."""
        lanes = self.situation.index.lanes
        most, before, seen_one = 0.0, 0.0, False
        headings: list[float] = []
        gone = 0.0
        for i, lane in enumerate(self.lanes):
            info = lanes[lane]
            if is_intersection(self.situation, info.junction):
                most, before = max(most, _spread(headings)), before if seen_one else max(before, _spread(headings))
                seen_one, headings = True, []
                gone += info.length
                continue
            low = info.project(self.ego.x[0], self.ego.y[0])[0] if i == 0 else 0.0
            high = low + max(0.0, self.length - gone)
            part = (info.along[:-1] < high) & (info.along[1:] > low)
            headings += info.headings[part].tolist()
            gone += max(0.0, info.length - low)
        most = max(most, _spread(headings))
        return most, before if seen_one else max(before, _spread(headings))

    def light(self) -> str | None:
        """What ego's light shows when it first comes within 30 m; "" where it never does; None without a light."""
        lanes, ego = self.situation.index.lanes, self.ego
        shown: str | None = None
        for one, two in zip(self.lanes, self.lanes[1:], strict=False):
            junction = lanes[two].junction
            if junction is None or state(self.situation, junction, lanes[one].road, 0) is None:
                continue
            end = lanes[one].points[-1]
            if self.line.distance(shapely.Point(end)) > 6.0:
                continue
            near = np.flatnonzero(np.hypot(ego.x - end[0], ego.y - end[1]) - ego.path.length / 2 <= NEAR_LIGHT)
            if len(near):
                acted = max(1, int(near[0]))  # a program sets lights in the first step
                return state(self.situation, junction, lanes[one].road, acted)
            shown = ""
        return shown

    def infrastructure(self) -> tuple[str, ...]:
        """traffic_light, stop_sign, yield_sign, crosswalk on the path."""
        found = set()
        extras, lanes = self.situation.extras, self.situation.index.lanes
        on_path = shapely.prepared.prep(self.line)
        names = {"signal": "traffic_light", "stop": "stop_sign", "yield": "yield_sign"}
        for lane in self.lanes:
            info = lanes[lane]
            if info.junction is not None or not extras:
                continue
            leads = {lanes[n].junction for n in info.next}
            for control in extras.controls:
                if str(control.road) == info.road and str(control.junction) in leads and self._reaches(info):
                    found.add(names[control.kind])
        for walk in extras.crosswalks if extras else ():
            if on_path.intersects(shapely.Polygon(walk.polygon)):
                found.add("crosswalk")
        for sign in self._signs():
            role = sign.path.role
            for name in ("stop_sign", "yield_sign", "crosswalk", "traffic_light"):
                if role.startswith(name):
                    found.add(name)
        return tuple(sorted(found))

    def _reaches(self, info) -> bool:  # type: ignore[no-untyped-def]
        return self.line.distance(shapely.Point(info.points[-1])) < 6.0

    def _signs(self) -> list[Seen]:
        """Props beside the path ahead of ego's start that face it."""
        found = []
        for seen in self.situation.others:
            if (
                seen.kind == "prop"
                and seen.path.role
                and self.line.distance(shapely.Point(seen.x[0], seen.y[0])) < BESIDE
            ):
                along = self.line.project(shapely.Point(seen.x[0], seen.y[0]))
                back = self.line.interpolate(max(0.0, along - 25.0))
                if along > 0.5 and faces(seen, back.x, back.y):
                    found.append(seen)
        return found

    def abreast(self, x: float, y: float) -> bool:
        """Whether a point lies beside the path or just beyond its end, and not before its start."""
        point = shapely.Point(x, y)
        return self.line.project(point) > 0.0 and self.line.distance(point) <= ABREAST

    def limits(self) -> tuple[float, ...]:
        """km/h: the map's for ego's road, those on sign props, and a scene parameter `speed_limit` (km/h)."""
        found = []
        posted = self.facts().speed_limit_kmh
        if posted is not None:
            found.append(posted)
        for sign in self._signs():
            name, _, value = sign.path.role.partition(":")
            if name.startswith("speed_sign") and value.replace(".", "", 1).isdigit():
                found.append(float(value))
        for name in ("speed_limit", "speed_limit_kmh"):
            limit = self.situation.recording.params.get(name)
            if isinstance(limit, int | float):
                found.append(float(limit))
        return tuple(dict.fromkeys(found))


def _spread(headings: list[float]) -> float:
    if len(headings) < 2:
        return 0.0
    unwrapped = np.unwrap(headings)
    return float(unwrapped.max() - unwrapped.min())
