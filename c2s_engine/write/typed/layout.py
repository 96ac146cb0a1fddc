"""Where everything starts, as boxes on tracks: who would start inside whom, and how much of each lane they take.

`s` runs along a track in its driving direction: "road" (all lanes of ego's road, its oncoming lanes and its edges) from
ego's start, the lanes that end at a junction or merge from that end (s < 0), "exit" from the junction; `y` to the left
of ego's lane, or of the track's. Lanes are taken as 3.5 m wide, and edges as near as S lets them be. Lengths in m.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import combinations, product

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import high, low
from c2s_engine.structure.specs import EgoSpec, ObjectSpec
from c2s_engine.write.typed import stations
from c2s_engine.write.typed.hiding import aside, faces_ego
from c2s_engine.write.typed.lanes import pulls_out
from c2s_engine.write.typed.place import approach_name
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import APPROACH_ANGLE, LANE_WIDTH, LENGTH, MOVES_OFF_ROAD, WIDTH, WORKS
from c2s_engine.write.typed.usual import at_corner, has_marking, right_behind, row_step, turn_of, uses_crosswalk

DRAWS = 12
_GOLDEN = 0.618
_CONES = ((-1.4, -6), (-0.5, -4), (0.5, -2), (1.4, 0), (1.4, 4), (1.4, 8))


@dataclass(frozen=True)
class Box:
    """A body on its track."""

    track: str
    s: float
    y: float
    length: float
    width: float

    def meets(self, other: "Box", room: float = 0.0) -> bool:
        """Whether it overlaps another, or comes closer to it lengthwise than `room`."""
        return (
            self.track == other.track
            and abs(self.s - other.s) < (self.length + other.length) / 2 + room
            and abs(self.y - other.y) < (self.width + other.width) / 2
        )


@dataclass(frozen=True)
class _Start:
    """The first member of a row: `raw` is what its constant says (before it is kept on the lane), `ahead` +1 where it
    looks along the track, `onward` +1 where the row goes on along it."""

    track: str
    s: float
    y: float
    raw: float = 0.0
    ahead: int = 1
    onward: int = 1


class Draw:
    """One drawing of all ranges: the same for whoever reads them, different from draw to draw."""

    def __init__(self, number: int, of: int) -> None:
        self.number, self.of, self.keys = number, of, list[str]()

    def __call__(self, key: str, value: float | tuple[float, float]) -> float:
        if key not in self.keys:
            self.keys.append(key)
        share = ((self.number + 0.5) / self.of + self.keys.index(key) * _GOLDEN) % 1
        return low(value) + share * (high(value) - low(value))


def draws(structure: Structure, plan: Plan) -> list[dict[str, list[Box]]]:
    """The boxes of all parties in evenly spread drawings of the ranges: one where there are none."""
    specs = [c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)]
    open_ = any(isinstance(s.placement.gap, tuple | list) for s in specs) or isinstance(plan.distance, tuple | list)
    number = DRAWS if open_ else 1
    return [boxes(structure, plan, Draw(i, number)) for i in range(number)]


def boxes(structure: Structure, plan: Plan, draw: Draw) -> dict[str, list[Box]]:
    """The boxes of ego and each object."""
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    starts = {"ego": _Start("road", 0.0, -(LANE_WIDTH / 2 + 1.4) if pulls_out(ego) else 0.0)}
    found = {"ego": [Box("road", 0.0, starts["ego"].y, LENGTH[ego.type], WIDTH[ego.type])]}
    for component in structure.objects:
        cid, spec = component.id, component.spec
        assert isinstance(spec, ObjectSpec)
        starts[cid] = start = _start(structure, cid, spec, plan, draw, starts, found)
        found[cid] = list(_works(spec, start) if spec.type in WORKS else _row(spec, start, plan))
    return found


def _start(
    structure: Structure,
    cid: str,
    spec: ObjectSpec,
    plan: Plan,
    draw: Draw,
    starts: dict[str, _Start],
    found: dict[str, list[Box]],
) -> _Start:
    placement = spec.placement
    position, sign = placement.position, stations.along(spec)
    if right_behind(spec):
        by = placement.hidden_by or "ego"
        hider, last = starts[by], _ends(structure, by, found)[1]
        beyond = (last.length + LENGTH[spec.type]) / 2 + stations.RIGHT_BEHIND + stations.past_others(structure, cid)
        to = stations.past_last(structure, spec) if stations.between(structure, spec) else beyond
        ahead = -hider.ahead if faces_ego(structure, by) else hider.ahead
        return replace(hider, s=last.s + ahead * to, y=last.y, onward=ahead)
    if stations.at_door(structure, spec):
        car = starts[placement.of]
        return replace(car, y=car.y + car.ahead * stations.from_door(structure, spec))
    if stations.in_line(structure, spec, plan):
        return _in_line(structure, cid, spec, plan, draw, starts[placement.of], found)
    if position in APPROACH_ANGLE:
        to = draw(cid, stations.to_junction(cid, spec, plan))
        passes = structure[plan.pocketed[cid]].spec if cid in plan.pocketed else spec
        assert isinstance(passes, ObjectSpec)
        beside = 0.0 if passes is spec else LANE_WIDTH
        return _Start(approach_name(plan, position, turn_of(passes.phases)), -to, beside, to, onward=-1)
    if position == "on_ramp":
        to = stations.to_merge(spec, plan)
        return _Start("place.ramp", -to, 0.0, to, onward=-1)
    if position == "intersection_exit":
        at = draw(cid, stations.exit_gap(spec, plan))
        y = LANE_WIDTH / 2 + stations.outwards(spec) if stations.near_exit(spec) else 0.0
        return _Start("exit", at, y if placement.side == "left" else -y, at)
    base, gap, half = stations.from_base(structure, spec, plan, 1 if position == "oncoming_lane" else sign or 1)
    at = starts[base].raw if base in starts else 0.0
    if position in MOVES_OFF_ROAD:
        return _beside(structure, cid, spec, plan, draw, at, sign * (draw(cid, gap) + half))
    if position == "oncoming_lane":
        at += draw(cid, gap) + half
        return _Start("road", at, LANE_WIDTH * (max(plan.offsets) + 1), at, -1)
    at += sign * (draw(cid, gap) + half) if sign else draw(cid, placement.gap or 0.0)
    y = LANE_WIDTH * (plan.lane_of[cid] or 0) + aside(structure, cid, plan)
    return _Start("road", at, y, at, -1 if placement.facing == "against" else 1, sign or 1)


def _beside(
    structure: Structure, cid: str, spec: ObjectSpec, plan: Plan, draw: Draw, base: float, offset: float
) -> _Start:
    left, of = spec.placement.side == "left", spec.placement.of
    edge = LANE_WIDTH / 2 + stations.outwards(spec) + stations.set_back(structure, cid, plan)
    if stations.parked_in_way(structure, cid):
        edge = (LANE_WIDTH + WIDTH[spec.type]) / 2 - stations.INTO_LANE
    if spec.placement.lateral is not None and of == "ego":
        edge = stations.from_lane(structure, spec)
        return _Start("road", base + offset, edge if left else -edge, base + offset)
    y = LANE_WIDTH * min(plan.offsets) - edge
    if left:
        y = LANE_WIDTH * (max(plan.offsets) + stations.two_way(plan)) + edge
    at = base + offset
    if has_marking(plan.place) and uses_crosswalk(spec):
        at = draw("ego", plan.distance or 0.0) + stations.next_to(structure, cid)
    elif at_corner(spec, plan.place):
        at = draw("ego", plan.distance or 0.0) - stations.CORNER - LENGTH[spec.type] / 2
    elif not offset and stations.stands_there(structure, of):
        at = base + stations.clear_of(structure, spec)
    return _Start("road", at, y, at, -1 if spec.placement.facing == "against" else 1, stations.along(spec) or 1)


def _in_line(
    structure: Structure,
    cid: str,
    spec: ObjectSpec,
    plan: Plan,
    draw: Draw,
    parent: _Start,
    found: dict[str, list[Box]],
) -> _Start:
    other = structure[spec.placement.of].spec
    assert isinstance(other, ObjectSpec)
    behind = stations.along(spec) < 0
    position = structure[stations.first_in_line(structure, cid, plan)].spec.placement.position  # type: ignore[union-attr]
    gap = draw(cid, stations.gap(spec, plan))
    to = gap + stations.bodies(spec, other, behind)
    if position in stations.FROM_END:
        raw = parent.raw + (to if behind else -to)
        return replace(parent, s=-raw if behind else -max(1.0, raw), raw=raw)
    if position in ("oncoming_lane", "intersection_exit"):
        raw = parent.raw + (to if behind == (position == "oncoming_lane") else -to)
        return replace(
            parent, s=max(1.0, raw) if position == "intersection_exit" else raw, raw=raw, y=_on(parent, plan)
        )
    last = _ends(structure, spec.placement.of, found)[not behind]
    away = gap + (last.length + LENGTH[spec.type]) / 2
    onward = -parent.ahead if behind else parent.ahead
    s = last.s + away * onward
    return replace(parent, s=s, raw=s, onward=onward)


def _ends(structure: Structure, cid: str, found: dict[str, list[Box]]) -> tuple[Box, Box]:
    """The first and the last member of a row; of works the first and the last cone."""
    row = found[cid]
    works = cid != "ego" and getattr(structure[cid].spec, "type", "") in WORKS
    return row[0], row[len(_CONES) - 1] if works else row[-1]


def _on(parent: _Start, plan: Plan) -> float:
    """On the lane itself, not at its edge."""
    return 0.0 if parent.track == "exit" else LANE_WIDTH * (max(plan.offsets) + 1)


def _row(spec: ObjectSpec, start: _Start, plan: Plan) -> Iterator[Box]:
    """The members; where the lanes meet at a ramp's end, none is beyond that."""
    length, width = LENGTH[spec.type], WIDTH[spec.type]
    if spec.placement.facing == "across":
        length, width = width, length
    end = plan.distance if plan.place.kind == "on_ramp" and start.track == "road" and start.y > LANE_WIDTH / 2 else None
    in_file = has_marking(plan.place) and uses_crosswalk(spec)  # one behind the other before the crosswalk
    for i in range(spec.count):
        s = start.s if in_file else start.s + start.onward * row_step(spec) * i
        y = start.y + (stations.IN_FILE * i if start.y > 0 else -stations.IN_FILE * i) * in_file
        yield Box(start.track, s if end is None else min(s, high(end) - 1), y, length, width)


def _works(spec: ObjectSpec, start: _Start) -> Iterator[Box]:
    """The cones, the barrier and the sign that stand for works."""

    def piece(right: float, on: float, length: float, width: float) -> Box:
        return Box(start.track, start.s + start.ahead * on, start.y - start.ahead * right, length, width)

    size = 0.4 if spec.type == "construction_zone" else 0.9
    yield from (piece(x, y, size, size) for x, y in _CONES)
    yield piece(0, 5, 0.4, 1.3)
    if spec.type == "construction_zone":
        yield piece(0.4, -9, 2.4, 2.9)


def clashes(drawn: list[dict[str, list[Box]]], room: float = 0.0) -> dict[tuple[str, str], float]:
    """The pairs of parties that start inside each other, or the members of one row, and in what share of the draws."""
    found: dict[tuple[str, str], float] = {}
    for one in drawn:
        for a, b in combinations(one, 2):
            if any(p.meets(q, room) for p, q in product(one[a], one[b])):
                found[a, b] = found.get((a, b), 0) + 1 / len(drawn)
        for a, row in one.items():
            if any(p.meets(q) for p, q in combinations(row, 2)):
                found[a, a] = found.get((a, a), 0) + 1 / len(drawn)
    return found


def extents(drawn: list[dict[str, list[Box]]]) -> dict[str, float]:
    """How far objects reach: ahead of ego, back from the end of a lane that has several, behind the junction."""
    found: dict[str, float] = {}
    for one in drawn:
        bodies = [box for cid, row in one.items() if cid != "ego" for box in row]
        for box in bodies:
            back = box.track not in ("road", "exit")
            if back and sum(other.track == box.track for other in bodies) < 2:
                continue  # one that is too far back starts where its lane does
            reached = (-box.s if back else box.s) + box.length / 2
            found[box.track] = max(found.get(box.track, 0.0), reached)
    return found
