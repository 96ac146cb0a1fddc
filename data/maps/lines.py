"""Roads as the plan draws them, their ends at junctions, and their lanes in OpenDRIVE."""

from dataclasses import dataclass, field
from typing import Any

from path import Piece, Pose, length_of
from scenariogeneration import xodr

CENTRE = xodr.RoadMark(xodr.RoadMarkType.broken, 0.15)
EDGE = xodr.RoadMark(xodr.RoadMarkType.solid, 0.15)


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


def road_lanes(line: Line, linked: bool) -> Any:
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


def connector_lanes(arm: Arm, lane: int, other: Arm, to: int, length: float, corner: bool) -> Any:
    """The lanes of a connecting road: one to drive in, drawn about its middle, and at corners what lies beside it."""
    first, last = arm.line.width(abs(lane)), other.line.width(abs(to))
    slope = (last - first) / length
    section = xodr.LaneSection(0, xodr.Lane(xodr.LaneType.none))
    way = xodr.Lane(xodr.LaneType.driving, a=first, b=slope)
    section.add_right_lane(way)
    way.add_link("predecessor", lane)
    way.add_link("successor", to)
    for kind, width in arm.line.beside() if corner else []:
        section.add_right_lane(xodr.Lane(xodr.LaneType.sidewalk if kind == "sidewalk" else xodr.LaneType.none, a=width))
    lanes = xodr.Lanes()
    lanes.add_lanesection(section)
    lanes.add_laneoffset(xodr.LaneOffset(0, a=first / 2, b=slope / 2))
    return lanes
