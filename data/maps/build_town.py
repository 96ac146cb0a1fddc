"""Builds town.xodr from town_plan.yaml: `python data/maps/build_town.py [OUT]`. The same plan gives the same bytes.

Every junction gets one connecting road for each way of a lane through it. Right-turn connectors carry the sidewalk
round the corner. Signals stand on the approaches and are referred to from the connectors (where Scenic looks for
lights); stop and yield signs and crosswalks lie on the approaches only.
"""

import math
import re
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import yaml
from lines import Arm, Line, connector_lanes, road_lanes
from path import Piece, Pose, arc, between, length_of, turning_round
from scenariogeneration import xodr

HERE = Path(__file__).parent
SIGNS = {"signal": "1000001", "stop": "206", "yield": "205"}
CROSSWALK_AT, CROSSWALK_WIDTH, STOP_LINE_AT = 5.0, 3.5, 8.0
OVERSHOOT = 0.003
MIN_STRAIGHT = math.radians(25)
LEVER = 3.4
"""m by which a lane may lie aside of a ring's line for each radian that a piece of it turns: Scenic, which samples
pieces at 20 points and turns lanes' ends by half of a step, else leaves gaps of more than 9 cm from lane to way."""


class Town:
    """The town under construction."""

    def __init__(self, plan: dict[str, Any]) -> None:
        self.plan = plan
        self.drive = xodr.OpenDrive("town")
        self.lines: dict[int, Line] = {}
        self.arms: dict[int, list[Arm]] = {}
        self.groups: list[Any] = []
        self.next_road, self.next_mark = 1000, 1
        self.parts = [plan, plan["later"]]
        self.places = {j["id"]: j for part in self.parts for j in [*part["junctions"], *part["roundabouts"]]}

    def build(self) -> Any:
        """One part after the other, so that what comes later leaves the numbers of the earlier; the XML element."""
        for part in self.parts:
            self._part(part)
        element = self.drive.get_element()
        element.extend(group.get_element() for group in self.groups)
        return element

    def _part(self, part: dict[str, Any]) -> None:
        """Roads, then what joins them."""
        before = set(self.lines)
        for road in part["roads"]:
            self._add_line(self._line(road))
        for road, places in part.get("crosswalks", {}).items():
            for s in places:
                self._crosswalk(self.lines[road], s)
        for junction in part["junctions"]:
            self._junction(junction)
        for circle in part["roundabouts"]:
            self._roundabout(circle)
        for ramp in part.get("ramps", []):
            links = [(Arm(self.lines[a], True), la, Arm(self.lines[b], False), lb) for a, la, b, lb in ramp["links"]]
            self._connect(ramp["id"], ramp["name"], links, [])
        for line in self.lines.values():
            if line.id not in before:
                self.drive.add_road(line.road)

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
            line.id, plan["name"], line.start, line.pieces, road_lanes(line, linked=link is not None), -1
        )
        limit, unit = (*str(plan.get("limit", profile["limit"])).split(), "km/h")[:2]
        line.road.add_type(xodr.RoadType[profile["type"]], 0, country="DE", speed=float(limit), speed_unit=unit)
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
            view.add_fixed_geometry(shape, pose.x, pose.y, math.remainder(pose.heading, math.tau), s)
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
        crossing = xodr.Object(
            s,
            0,
            xodr.ObjectType.crosswalk,
            id=self._mark(),
            name="crosswalk",
            width=2 * half,
            length=2 * ahead,
            height=0,
        )
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
            s, -aside if arm.at_end else aside, "OpenDRIVE", SIGNS[control], "-1", id=mark, name=control,
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
            pieces = turning_round(start, end) if arm is other else between(start, _crossing(start, end))
            lanes = connector_lanes(arm, lane, other, to, length_of(pieces), index in corners)
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
        """A ring of one-way arcs, and a junction of its own for each arm. Lanes are joined from the outermost
        inwards; every lane of the ring leads on and out."""
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
            ring = Line({"id": plan["roads"] + number, "name": "ring", "profile": plan["ring"]}, profile, start, [])
            parts = max(1, math.ceil(ring.offset(ring.driving()[-1]) * sweep / LEVER))
            ring = replace(ring, pieces=arc(sweep / parts, radius) * parts)
            self._add_line(ring)
            rings.append(ring)
        group = xodr.JunctionGroup(plan["name"], plan["id"], xodr.JunctionGroupType.roundabout)
        for number, arm in enumerate(arms):
            jid = plan["id"] + 1 + number
            come, leave = Arm(rings[number - 1], True), Arm(rings[number], False)
            self._sign(arm, "yield")
            on, out, into = come.incoming(), arm.outgoing()[::-1], leave.outgoing()[::-1]
            links = [(come, lane, leave, lane) for lane in on]
            links += [(come, lane, arm, out[min(n, len(out) - 1)]) for n, lane in enumerate(reversed(on))]
            links += [(arm, lane, leave, to) for lane, to in zip(reversed(arm.incoming()), into, strict=False)]
            self._connect(jid, f"{plan['name']} {number + 1}", links, [])
            group.add_junction(jid)
        self.groups.append(group)


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


def _crossing(start: Pose, end: Pose) -> Pose:
    """The end of a way, a little beyond the lane's middle: the middles of ways that merge then cross, and Scenic, which
    looks for crossings, counts them as conflicts."""
    turn = math.remainder(end.heading - start.heading, math.tau)
    aside = math.sin(start.heading) * (start.x - end.x) - math.cos(start.heading) * (start.y - end.y)
    if abs(turn) < 1e-6 and abs(aside) < 1e-6:
        return end
    return end.moved(0, math.copysign(OVERSHOOT, aside if abs(turn) < 1e-6 else -turn))


def _ways(arm: Arm, other: Arm, turns: dict[int, float]) -> list[tuple[int, int]]:
    """Which lanes of an arm lead into which lanes of another."""
    into, out = arm.incoming(), other.outgoing()
    if not into or not out:
        return []
    if other is arm:
        divided = arm.line.profile["lanes"][0][0] == "median"
        return [(into[0], out[0] if divided else out[-1])] if len(into) > 1 else []
    turn = turns[other.line.id]
    if turn > MIN_STRAIGHT:
        return [(into[0], out[0])]
    if turn < -MIN_STRAIGHT:
        return [(into[-1], out[-1])]
    return [(lane, out[min(number, len(out) - 1)]) for number, lane in enumerate(into)]


def _rounded(text: str) -> str:
    """A number of more digits than the last bit of a platform's sine can change; other texts as they are."""
    if not re.fullmatch(r"-?[0-9]+\.[0-9]+(e-?[0-9]+)?", text):
        return text
    return f"{round(float(text), 8) + 0.0:.8f}".rstrip("0").rstrip(".")


def build(out: Path) -> None:
    """Writes the town; the header's date is fixed, so that the bytes depend on the plan alone."""
    plan = yaml.safe_load((HERE / "town_plan.yaml").read_text())
    element = Town(plan).build()
    header = element.find("header")
    header.set("date", "2026-01-01T00:00:00")
    for each in element.iter():
        for name, text in each.attrib.items():
            each.set(name, _rounded(text))
    xodr.ET.indent(element, "")
    out.write_bytes(xodr.ET.tostring(element, encoding="utf-8", xml_declaration=True) + b"\n")


if __name__ == "__main__":
    build(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "town.xodr")
