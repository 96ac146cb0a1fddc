"""Builds town.xodr from town_plan.yaml: `python data/maps/build_town.py [OUT]`. The same plan gives the same bytes.

Every junction gets one connecting road for each way of a lane through it. Right-turn connectors carry the sidewalk round
the corner. Signals stand on the approaches and are referred to from the connectors (where Scenic looks for lights);
stop and yield signs and crosswalks lie on the approaches only.
"""

import math
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml
from path import Piece, Pose, arc, between, length_of
from scenariogeneration import xodr

HERE = Path(__file__).parent
CENTRE = xodr.RoadMark(xodr.RoadMarkType.broken, 0.15)
EDGE = xodr.RoadMark(xodr.RoadMarkType.solid, 0.15)
SIGNS = {"signal": "1000001", "stop": "206", "yield": "205"}
CROSSWALK_AT, CROSSWALK_WIDTH, STOP_LINE_AT = 5.0, 3.5, 8.0
MIN_STRAIGHT = math.radians(25)


@dataclass(eq=False)
class Line:
    """A road of the plan: its profile, and where it lies."""

    plan: dict[str, Any]
    profile: dict[str, Any]
    start: Pose
    pieces: list[Piece]
    road: Any = None
    end: Pose = field(init=False)

    def __post_init__(self) -> None:
        self.end = self.start
        for piece in self.pieces:
            self.end = self.end.after(piece)

    @property
    def id(self) -> int:
        return self.plan["id"]

    @property
    def length(self) -> float:
        return length_of(self.pieces)

    @property
    def one_way(self) -> bool:
        return self.profile.get("one_way", False)

    def driving(self) -> list[int]:
        """Numbers (1, 2, ... from the middle) of the driving lanes of one direction."""
        return [i for i, (kind, _) in enumerate(self.profile["lanes"], 1) if kind == "driving"]

    def offset(self, number: int) -> float:
        """Distance of the middle of a lane from the reference line."""
        widths = [width for _, width in self.profile["lanes"]]
        return sum(widths[: number - 1]) + widths[number - 1] / 2

    def width(self, number: int) -> float:
        return self.profile["lanes"][number - 1][1]

    def beside(self) -> list[list[Any]]:
        """The lanes outside the driving lanes."""
        return self.profile["lanes"][self.driving()[-1] :]


@dataclass(frozen=True)
class Arm:
    """An end of a road at a junction. `out` is the pose there, seen from the junction."""

    line: Line
    at_end: bool

    @property
    def out(self) -> Pose:
        return self.line.end.reversed if self.at_end else self.line.start

    def incoming(self) -> list[int]:
        """Signed lane ids that lead into the junction, from the middle outwards."""
        sign = -1 if self.at_end else 1
        return [] if self.line.one_way and sign == 1 else [sign * n for n in self.line.driving()]

    def outgoing(self) -> list[int]:
        sign = 1 if self.at_end else -1
        return [] if self.line.one_way and sign == 1 else [sign * n for n in self.line.driving()]

    def pose(self, lane: int, inwards: bool) -> Pose:
        """Where a lane enters (leaves) the junction, with its direction of travel."""
        aside = self.line.offset(abs(lane))
        return self.out.moved(0, aside).reversed if inwards else self.out.moved(0, -aside)

    @property
    def contact(self) -> Any:
        return xodr.ContactPoint.end if self.at_end else xodr.ContactPoint.start


class Town:
    """The town under construction."""

    def __init__(self, plan: dict[str, Any]) -> None:
        self.plan = plan
        self.drive = xodr.OpenDrive("town")
        self.lines: dict[int, Line] = {}
        self.arms: dict[int, list[Arm]] = {}
        self.groups: list[Any] = []
        self.next_road, self.next_mark = 1000, 1
        self.places = {j["id"]: j for j in [*plan["junctions"], *plan["roundabouts"]]}

    def build(self) -> Any:
        """Roads, then what joins them; the XML element."""
        for road in self.plan["roads"]:
            self._add_line(self._line(road))
        for junction in self.plan["junctions"]:
            self._junction(junction)
        for circle in self.plan["roundabouts"]:
            self._roundabout(circle)
        for ramp in self.plan["ramps"]:
            links = [(Arm(self.lines[a], True), la, Arm(self.lines[b], False), lb) for a, la, b, lb in ramp["links"]]
            self._connect(ramp["id"], ramp["name"], links, [])
        for line in self.lines.values():
            self.drive.add_road(line.road)
        element = self.drive.get_element()
        element.extend(group.get_element() for group in self.groups)
        return element

    # roads

    def _line(self, plan: dict[str, Any]) -> Line:
        profile = self.plan["profiles"][plan["profile"]]
        if "after" in plan:
            return Line(plan, profile, self.lines[plan["after"]].end, _path(plan["path"]))
        origin, reach = self._end(plan["from"])
        if "path" in plan:
            start = Pose(*origin, math.radians(plan["heading"])).moved(reach)
            return Line(plan, profile, start, _path(plan["path"]))
        target, stop = self._end(plan["to"])
        heading = math.atan2(target[1] - origin[1], target[0] - origin[0])
        start = Pose(*origin, heading).moved(reach)
        return Line(plan, profile, start, [("line", math.dist(origin, target) - reach - stop, 0.0)])

    def _end(self, end: int | list[float]) -> tuple[list[float], float]:
        """A road's end: the point it is drawn towards, and how far before it the road stops."""
        if isinstance(end, list):
            return end, 0.0
        place = self.places[end]
        return place["at"], place.get("radius") if "reach" not in place else place["reach"]

    def _add_line(self, line: Line) -> None:
        plan, profile = line.plan, line.profile
        link = None
        if "after" in plan:
            link = self.lines[plan["after"]]
        line.road = self._road(
            line.id, plan["name"], line.start, line.pieces, _lanes(line, linked=link is not None), -1
        )
        line.road.add_type(xodr.RoadType[profile["type"]], 0, country="DE", speed=profile["limit"], speed_unit="km/h")
        if link:
            line.road.add_predecessor(xodr.ElementType.road, link.id, xodr.ContactPoint.end)
            link.road.add_successor(xodr.ElementType.road, line.id, xodr.ContactPoint.start)
            for section in link.road.lanes.lanesections:
                for lane in [*section.leftlanes, *section.rightlanes]:
                    lane.add_link("successor", lane.lane_id)
        self.lines[line.id] = line
        for s in plan.get("crosswalks", []):
            self._crosswalk(line, s)
        if isinstance(plan.get("from"), int):
            self.arms.setdefault(plan["from"], []).append(Arm(line, False))
        if isinstance(plan.get("to"), int):
            self.arms.setdefault(plan["to"], []).append(Arm(line, True))

    def _road(self, rid: int, name: str, start: Pose, pieces: list[Piece], lanes: Any, junction: int) -> Any:
        view = xodr.PlanView()
        s, pose = 0.0, start
        for piece in pieces:
            kind, length, curvature = piece
            shape = xodr.Line(length) if kind == "line" else xodr.Arc(curvature, length=length)
            view.add_fixed_geometry(shape, _r(pose.x), _r(pose.y), _r(math.remainder(pose.heading, math.tau)), s)
            s, pose = s + length, pose.after(piece)
        view.adjust_geometries()
        return xodr.Road(rid, view, lanes, road_type=junction, name=name)

    # what lies on roads

    def _mark(self) -> str:
        self.next_mark += 1
        return str(self.next_mark - 1)

    def _crosswalk(self, line: Line, s: float) -> None:
        kept = [width for kind, width in line.profile["lanes"] if kind != "sidewalk"]
        half, ahead = sum(kept) + 0.5, CROSSWALK_WIDTH / 2
        crossing = xodr.Object(s, 0, Type=xodr.ObjectType.crosswalk, id=self._mark(), name="crosswalk",
                               orientation=xodr.Orientation.none, width=2 * half, length=2 * ahead, height=0)  # fmt: skip
        outline = xodr.Outline(closed=True)
        for u, v in ((-ahead, -half), (ahead, -half), (ahead, half), (-ahead, half)):
            outline.add_corner(xodr.CornerLocal(u, v, 0, 0))
        crossing.add_outline(outline)
        line.road.objects.append(crossing)

    def _sign(self, arm: Arm, control: str) -> str | None:
        """Puts a light or sign at the stop line of an arm; the mark's id."""
        lanes = arm.incoming()
        if control == "none" or not lanes:
            return None
        line = arm.line
        s = line.length - STOP_LINE_AT if arm.at_end else STOP_LINE_AT
        edge = line.offset(abs(lanes[-1])) + line.width(abs(lanes[-1])) / 2
        aside = edge + sum(width for kind, width in line.beside() if kind != "sidewalk") + 0.5
        mark = self._mark()
        facing = xodr.Orientation.positive if arm.at_end else xodr.Orientation.negative
        signal = xodr.Signal(
            _r(s), _r(-aside if arm.at_end else aside), "OpenDRIVE", SIGNS[control], "-1", id=mark, name=control,
            dynamic=xodr.Dynamic.yes if control == "signal" else xodr.Dynamic.no,
            zOffset=5.0 if control == "signal" else 2.0, orientation=facing)  # fmt: skip
        signal.validity = xodr.Validity(min(lanes), max(lanes))
        line.road.signals.append(signal)
        return mark

    # junctions

    def _junction(self, plan: dict[str, Any]) -> None:
        arms = self.arms[plan["id"]]
        middle = plan["at"]
        signals: dict[int, str] = {}
        for arm in arms:
            if plan["crosswalks"] and any(kind == "sidewalk" for kind, _ in arm.line.profile["lanes"]):
                self._crosswalk(arm.line, arm.line.length - CROSSWALK_AT if arm.at_end else CROSSWALK_AT)
            if "signs" in plan and _compass(middle, arm.out) not in plan["signs"]:
                continue
            mark = self._sign(arm, plan["control"])
            if mark and plan["control"] == "signal":
                signals[arm.line.id] = mark
        links, corners = [], []
        for arm in arms:
            others = {other.line.id: _turn(arm, other) for other in arms if other is not arm}
            right_arm = any(turn < -MIN_STRAIGHT for turn in others.values())
            for other in arms:
                for number, (lane, to) in enumerate(_ways(arm, other, others)):
                    links.append((arm, lane, other, to))
                    turn = others.get(other.line.id, math.pi)
                    last = lane == arm.incoming()[-1]
                    outer = turn < -MIN_STRAIGHT or (abs(turn) <= MIN_STRAIGHT and not right_arm)
                    if last and outer and arm.line.beside() == other.line.beside() and number >= 0:
                        corners.append(len(links) - 1)
        self._connect(plan["id"], plan["name"], links, corners, signals)

    def _connect(self, jid: int, name: str, links: list[tuple[Arm, int, Arm, int]], corners: list[int],
                 signals: dict[int, str] | None = None) -> None:  # fmt: skip
        """A junction with a connecting road for each link (arm, lane, arm, lane); `corners` carry sidewalks along."""
        junction = xodr.Junction(name, jid)
        for arm in [end for a, _, b, _ in links for end in (a, b)]:
            if arm.at_end and arm.line.road.successor is None:
                arm.line.road.add_successor(xodr.ElementType.junction, jid)
            elif not arm.at_end and arm.line.road.predecessor is None:
                arm.line.road.add_predecessor(xodr.ElementType.junction, jid)
        for index, (arm, lane, other, to) in enumerate(links):
            rid = self.next_road
            self.next_road += 1
            start, end = arm.pose(lane, True), other.pose(to, False)
            pieces = between(start, end)
            lanes = _connector_lanes(arm, lane, other, to, length_of(pieces), index in corners)
            road = self._road(rid, "", start, pieces, lanes, jid)
            road.add_predecessor(xodr.ElementType.road, arm.line.id, arm.contact)
            road.add_successor(xodr.ElementType.road, other.line.id, other.contact)
            mark = (signals or {}).get(arm.line.id)
            if mark:
                road.signals.append(xodr.SignalReference(0, 0, id=mark, orientation=xodr.Orientation.positive))
            connection = xodr.Connection(arm.line.id, rid, xodr.ContactPoint.start)
            connection.add_lanelink(lane, -1)
            junction.add_connection(connection)
            self.drive.add_road(road)
        self.drive.add_junction(junction)

    def _roundabout(self, plan: dict[str, Any]) -> None:
        """A ring of one-way arcs, and a junction of its own for each arm."""
        x, y = plan["at"]
        profile = self.plan["profiles"][plan["ring"]]
        half = profile["lanes"][0][1] / 2
        gap = math.radians(30)
        arms = sorted(self.arms[plan["id"]], key=lambda arm: _bearing((x, y), arm.out))
        rings: list[Line] = []
        for number, arm in enumerate(arms):
            begin = _bearing((x, y), arm.out) + gap
            following = arms[(number + 1) % len(arms)]
            sweep = (_bearing((x, y), following.out) - gap - begin) % math.tau
            radius = plan["radius"] - half
            start = Pose(x + radius * math.cos(begin), y + radius * math.sin(begin), begin + math.pi / 2)
            ring = Line(
                {"id": plan["roads"] + number, "name": "ring", "profile": plan["ring"]},
                profile,
                start,
                arc(sweep, radius),
            )
            self._add_line(ring)
            rings.append(ring)
        group = xodr.JunctionGroup(plan["name"], plan["id"], xodr.JunctionGroupType.roundabout)
        for number, arm in enumerate(arms):
            jid = plan["id"] + 1 + number
            come, leave = Arm(rings[number - 1], True), Arm(rings[number], False)
            self._sign(arm, "yield")
            links = [(come, -1, leave, -1), (come, -1, arm, arm.outgoing()[0]), (arm, arm.incoming()[0], leave, -1)]
            self._connect(jid, f"{plan['name']} {number + 1}", links, [])
            group.add_junction(jid)
        self.groups.append(group)


def _r(value: float) -> float:
    return round(value, 6) + 0.0


def _path(plan: list[list[Any]]) -> list[Piece]:
    pieces: list[Piece] = []
    for kind, *numbers in plan:
        pieces += [("line", float(numbers[0]), 0.0)] if kind == "line" else arc(math.radians(numbers[0]), numbers[1])
    return pieces


def _bearing(middle: Any, pose: Pose) -> float:
    return math.atan2(pose.y - middle[1], pose.x - middle[0]) % math.tau


def _compass(middle: Any, pose: Pose) -> str:
    return "ENWS"[round(_bearing(middle, pose) / (math.pi / 2)) % 4]


def _turn(arm: Arm, other: Arm) -> float:
    """Change of heading on the way from arm to arm, left positive."""
    return math.remainder(other.out.heading - arm.out.heading - math.pi, math.tau)


def _ways(arm: Arm, other: Arm, turns: dict[int, float]) -> list[tuple[int, int]]:
    """Which lanes of an arm lead into which lanes of another."""
    into, out = arm.incoming(), other.outgoing()
    if not into or not out:
        return []
    if other is arm:
        return [(into[0], out[0])] if arm.line.profile["lanes"][0][0] == "median" else []
    turn = turns[other.line.id]
    if turn > MIN_STRAIGHT:
        return [(into[0], out[0])]
    if turn < -MIN_STRAIGHT:
        return [(into[-1], out[-1])]
    return [(lane, out[min(number, len(out) - 1)]) for number, lane in enumerate(into)]


def _lanes(line: Line, linked: bool) -> Any:
    section = xodr.LaneSection(0, _centre(line))
    for kind, width in line.profile["lanes"]:
        for add, sign in ((section.add_left_lane, 1), (section.add_right_lane, -1)):
            if sign == 1 and line.one_way:
                continue
            lane = xodr.Lane(xodr.LaneType[kind], a=width)
            lane.add_roadmark(CENTRE if kind == "driving" else EDGE)
            add(lane)
            if linked:
                lane.add_link("predecessor", lane.lane_id)
    lanes = xodr.Lanes()
    lanes.add_lanesection(section)
    return lanes


def _centre(line: Line) -> Any:
    lane = xodr.Lane(xodr.LaneType.none)
    lane.add_roadmark(EDGE if line.one_way else CENTRE)
    return lane


def _connector_lanes(arm: Arm, lane: int, other: Arm, to: int, length: float, corner: bool) -> Any:
    """The lanes of a connecting road: one to drive in, drawn about its middle, and at corners what lies beside it."""
    first, last = arm.line.width(abs(lane)), other.line.width(abs(to))
    slope = (last - first) / length
    section = xodr.LaneSection(0, xodr.Lane(xodr.LaneType.none))
    way = xodr.Lane(xodr.LaneType.driving, a=first, b=_r(slope))
    section.add_right_lane(way)
    way.add_link("predecessor", lane)
    way.add_link("successor", to)
    for kind, width in arm.line.beside() if corner else []:
        section.add_right_lane(xodr.Lane(xodr.LaneType.sidewalk if kind == "sidewalk" else xodr.LaneType.none, a=width))
    lanes = xodr.Lanes()
    lanes.add_lanesection(section)
    lanes.add_laneoffset(xodr.LaneOffset(0, a=first / 2, b=_r(slope / 2)))
    return lanes


def build(out: Path) -> None:
    """Writes the town; the header's date is fixed, so that the bytes depend on the plan alone."""
    plan = yaml.safe_load((HERE / "town_plan.yaml").read_text())
    element = Town(plan).build()
    header = element.find("header")
    header.set("date", "2026-01-01T00:00:00")
    xodr.ET.indent(element, "")
    out.write_bytes(xodr.ET.tostring(element, encoding="utf-8", xml_declaration=True) + b"\n")


if __name__ == "__main__":
    build(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "town.xodr")
