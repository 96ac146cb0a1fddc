"""A recording seen on its roads: which lane each object is in at each step, and the way that its lane leads.

All event functions look at this and at nothing else. Steps are indices; `until` is the last step that counts.
"""

from functools import cached_property

import numpy as np

from c2s_engine.dryrun.events.kinds import is_vehicle
from c2s_engine.dryrun.recording import Path, Recording
from c2s_engine.dryrun.roads import LaneInfo, RoadIndex, polyline, project
from c2s_engine.maps.extras import MapExtras

NOWHERE = -1
BEYOND = 100.0
"""m: how far a path is looked at beyond what is driven."""


def wrap(angle: np.ndarray | float) -> np.ndarray:
    """To -pi..pi."""
    return np.remainder(np.asarray(angle) + np.pi, 2 * np.pi) - np.pi


class Way:
    """A chain of lanes that an object's own lane leads along, as one line."""

    def __init__(self, index: RoadIndex, lanes: list[int]) -> None:
        self.index, self.lanes = index, lanes
        self.points = index.line(lanes)
        self.along, self.headings = polyline(self.points)
        lengths = [index.lanes[i].length for i in lanes]
        self.starts = np.concatenate([[0.0], np.cumsum(lengths)])[:-1]

    def place(self, xy: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(m along, m to the left) of points."""
        return project(self.points, self.along, np.atleast_2d(xy))

    def headings_at(self, s: np.ndarray) -> np.ndarray:
        """The line's direction (rad) at distances along it."""
        return self.headings[np.clip(np.searchsorted(self.along, s, side="right") - 1, 0, len(self.headings) - 1)]

    def heading_at(self, s: float) -> float:
        return float(self.headings_at(np.asarray(s)))


class Seen:
    """One object on the road."""

    def __init__(self, path: Path, until: int, situation: "Situation") -> None:
        self.path, self.until, self.situation = path, until, situation
        self.name, self.kind = path.name, path.kind
        n = until + 1
        self.x, self.y, self.heading = path.x[:n], path.y[:n], path.heading[:n]
        self.xy = np.column_stack([self.x, self.y])
        self.speed, self.forward = path.speed[:n], path.forward[:n]
        self.vx, self.vy = path.vx[:n], path.vy[:n]
        self.drives = is_vehicle(path)
        self._placed: dict[Seen, tuple[np.ndarray, np.ndarray]] = {}

    @cached_property
    def travelled(self) -> np.ndarray:
        """m of way behind it at each step."""
        return np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(self.x), np.diff(self.y)))])

    @cached_property
    def moves(self) -> bool:
        return bool(np.hypot(self.x - self.x[0], self.y - self.y[0]).max() > 0.5)

    @cached_property
    def lanes(self) -> np.ndarray:
        """The lane that its middle is in at each step (NOWHERE: in none)."""
        return self.situation.lanes_of(self)

    @cached_property
    def start_lane(self) -> LaneInfo | None:
        """The lane it starts in, or for a vehicle that starts beside the lanes, None."""
        return self.situation.index.lanes[self.lanes[0]] if self.lanes[0] != NOWHERE else None

    @cached_property
    def runs(self) -> list[tuple[int, int, int]]:
        """(lane, first step, last step) of each stay."""
        lanes = self.lanes
        cuts = np.flatnonzero(np.diff(lanes)) + 1
        first = [0, *cuts.tolist()]
        last = [*(c - 1 for c in cuts.tolist()), len(lanes) - 1]
        return [(int(lanes[a]), a, b) for a, b in zip(first, last, strict=True)]

    @cached_property
    def way(self) -> Way | None:
        """Where its own lane leads: the lane it starts in and what continues it, through junctions as it drives."""
        lane = next((int(i) for i in self.lanes if i != NOWHERE), None)
        return self.situation.way_from(lane, self) if lane is not None else None

    @cached_property
    def driven(self) -> list[int]:
        """The lanes it was in, in order, then what continues the last of them."""
        found = [lane for lane, _, _ in self.runs if lane != NOWHERE]
        if not found:
            return []
        return found + self.situation.index.path(found[-1], BEYOND + self.situation.index.lanes[found[-1]].length)[1:]

    def placed(self, other: "Seen") -> tuple[np.ndarray, np.ndarray]:
        """(m along, m to the left) of another, or of itself, on the way of its own lane at each step of that one."""
        assert self.way is not None
        if other not in self._placed:
            self._placed[other] = self.way.place(other.xy)
        return self._placed[other]

    def aside(self) -> np.ndarray:
        """m to the left of its own lane's line at each step (NaN without a lane)."""
        return self.placed(self)[1] if self.way else np.full(len(self.x), np.nan)


class Situation:
    """The whole run on its roads."""

    def __init__(self, recording: Recording, index: RoadIndex, extras: MapExtras | None) -> None:
        self.recording, self.index, self.extras = recording, index, extras
        self.step = recording.step
        last = recording.steps - 1
        until = [last] * len(recording.paths)
        self.touched: dict[frozenset[str], int] = {}
        """The step of the first contact of two, by their names."""
        for time, i, j in recording.contacts:
            at = min(last, int(time / self.step - 1e-6))
            until[i], until[j] = min(until[i], at), min(until[j], at)
            self.touched.setdefault(frozenset((recording.paths[i].name, recording.paths[j].name)), at)
        self.objects = [Seen(p, u, self) for p, u in zip(recording.paths, until, strict=True)]
        self.last = last

    @property
    def ego(self) -> Seen:
        """The object called ego, else the first."""
        return next((o for o in self.objects if o.name == "ego"), self.objects[0])

    @property
    def others(self) -> list[Seen]:
        return [o for o in self.objects if o is not self.ego]

    def at(self, seconds: float) -> int:
        """How many steps a time takes, at least 1."""
        return max(1, round(seconds / self.step))

    def lanes_of(self, seen: Seen) -> np.ndarray:
        """The lane of each step: where several hold the point, the chain of them that fits best."""
        if not seen.moves:
            lane = self.index.lane_at(seen.x[0], seen.y[0], float(seen.heading[0]) if seen.drives else None)
            return np.full(len(seen.x), NOWHERE if lane is None else lane)
        held = self.index.containing(seen.xy)
        lanes = np.full(len(held), NOWHERE)
        step = 0
        while step < len(held):
            if len(held[step]) < 2:
                lanes[step] = held[step][0] if held[step] else NOWHERE
                step += 1
                continue
            end = step
            while end < len(held) and len(held[end]) >= 2:
                end += 1
            lanes[step:end] = self._choose(seen, held, step, end, int(lanes[step - 1]) if step else NOWHERE)
            step = end
        return lanes

    def _choose(self, seen: Seen, held: list[list[int]], first: int, end: int, before: int) -> np.ndarray:
        """The cheapest chain of lanes over steps in which several are possible."""
        after = held[end][0] if end < len(held) and held[end] else NOWHERE
        costs: dict[int, float] = {NOWHERE if before == NOWHERE else before: 0.0}
        back: list[dict[int, int]] = []
        fits = self._fits(seen, held, first, end)
        for step in range(first, end):
            now: dict[int, float] = {}
            came: dict[int, int] = {}
            for lane in held[step]:
                best, source = min((cost + self._switch(other, lane), other) for other, cost in costs.items())
                now[lane], came[lane] = best + fits[lane, step], source
            costs = now
            back.append(came)
        lane = min(costs, key=lambda i: costs[i] + (self._switch(i, after) if after != NOWHERE else 0.0))
        chosen = []
        for came in reversed(back):
            chosen.append(lane)
            lane = came[lane]
        return np.array(chosen[::-1])

    def _fits(self, seen: Seen, held: list[list[int]], first: int, end: int) -> dict[tuple[int, int], float]:
        steps: dict[int, list[int]] = {}
        for step in range(first, end):
            for lane in held[step]:
                steps.setdefault(lane, []).append(step)
        found: dict[tuple[int, int], float] = {}
        for lane, at in steps.items():
            info = self.index.lanes[lane]
            s, d = info.project_many(seen.xy[at])
            segment = np.clip(np.searchsorted(info.along, s, side="right") - 1, 0, len(info.headings) - 1)
            turn = np.abs(wrap(seen.heading[at] - info.headings[segment]))
            cost = np.abs(d) + (2.0 * turn if seen.drives else 0.0)
            found.update(zip(((lane, step) for step in at), cost.tolist(), strict=True))
        return found

    def _switch(self, a: int, b: int) -> float:
        if a in (b, NOWHERE):
            return 0.0
        info = self.index.lanes[a]
        if b in info.next or a in self.index.lanes[b].next:
            return 0.1
        return 6.0

    def way_from(self, lane: int, seen: Seen) -> Way:
        """The line that a lane leads along, backwards a little and forwards past the end of what is driven."""
        index = self.index
        visited = {int(i) for i in seen.lanes}
        s = index.lanes[lane].project(seen.x[0], seen.y[0])[0]
        reach = float(seen.travelled[-1]) + BEYOND

        def choose(ways: tuple[int, ...]) -> int:
            for w in ways:
                if w in visited:
                    return w
            junction = index.lanes[ways[0]].junction
            aims = [v for v in visited if v != NOWHERE and junction and index.lanes[v].junction == junction]
            end = index.lanes[aims[0]].headings[-1] if aims else index.lanes[ways[0]].headings[0]
            return min(ways, key=lambda w: abs(float(wrap(index.lanes[w].headings[-1] - end))))

        lanes = index.path(lane, reach, choose, s)
        first = lane
        for _ in range(3):
            before = index.previous.get(first, ())
            if not before or s > 60.0:
                break
            first = min(
                before, key=lambda i: abs(float(wrap(index.lanes[i].headings[0] - index.lanes[lane].headings[0])))
            )
            if first in lanes:
                break
            lanes.insert(0, first)
            s += index.lanes[first].length
        return Way(index, lanes)

    def chain(self, lane: int) -> set[int]:
        """A lane, what leads into it and what continues it, as far as the road is the same way."""
        found = {lane}
        found.update(self.index.path(lane, self.index.lanes[lane].length + 300.0))
        at = lane
        for _ in range(4):
            before = self.index.previous.get(at, ())
            if len(before) != 1:
                break
            at = before[0]
            found.add(at)
        return found
