"""Traffic lights, stop and yield signs of a map: where they stand and which approaches they face."""

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal

from c2s_engine.maps.opendrive import Road, number

ControlKind = Literal["signal", "stop", "yield"]
TYPES: dict[str, ControlKind] = {
    "1000001": "signal", "1000009": "signal", "1000010": "signal", "1000011": "signal", "206": "stop", "205": "yield",
}  # fmt: skip
"""By the numbers of CARLA's maps and of the German catalogue that they follow."""


@dataclass(frozen=True)
class Link:
    """A way through a junction: from a road (its end or start) over a connecting road to a road (its start or end)."""

    junction: int
    source: int
    way: int
    forward: bool
    at_end: bool
    target: int | None
    target_start: bool


@dataclass(frozen=True)
class ControlPoint:
    """A traffic light, stop or yield sign: where it stands, which way the traffic goes that it faces, and whom.

    `x`, `y`, `s` (along `road`) in m, `heading` in rad; `lanes`: the signed ids of the lanes of `road` that it faces;
    `mark`: the signal's id in the file.
    """

    kind: ControlKind
    x: float
    y: float
    heading: float
    road: int
    lanes: tuple[int, ...]
    junction: int | None
    s: float
    mark: str = ""


def read_controls(elements: list[ET.Element], geometry: dict[int, Road], links: list[Link]) -> tuple[ControlPoint, ...]:
    """The controls of all <road> elements; what stands on or is referred to by a way counts for its approach."""
    reader = _Reader(geometry, links)
    placed: dict[str, tuple[ControlKind, float, float]] = {}
    for element in elements:
        for signal in element.findall("signals/signal"):
            kind = _kind(signal)
            if kind:
                x, y, _ = geometry[int(number(element, "id"))].at(number(signal, "s"), number(signal, "t", 0.0))
                placed[signal.get("id", "")] = (kind, x, y)
    found: dict[tuple[str, int, int | None], ControlPoint] = {}
    for element in elements:
        for signal in [*element.findall("signals/signal"), *element.findall("signals/signalReference")]:
            mark = signal.get("id", "")
            for point in reader.points(signal, int(number(element, "id")), *placed[mark]) if mark in placed else ():
                found.setdefault((mark, point.road, point.junction), replace(point, mark=mark))
    return tuple(found.values())


def _kind(signal: ET.Element) -> ControlKind | None:
    kind = TYPES.get(signal.get("type", ""))
    named = "stop" in (signal.get("name") or "").lower() and signal.get("dynamic") != "yes"
    return kind or ("stop" if named else None)


def _for_lanes(signal: ET.Element) -> bool:
    """Whether a signal is valid for any lane: one that is for lane 0 alone only stands there."""
    pairs = _validity(signal)
    return not pairs or any(pair != (0, 0) for pair in pairs)


def _validity(signal: ET.Element) -> list[tuple[float, float]]:
    return [(number(v, "fromLane"), number(v, "toLane")) for v in signal.findall("validity")]


class _Reader:
    """Finds the approaches that a signal faces."""

    def __init__(self, geometry: dict[int, Road], links: list[Link]) -> None:
        self.geometry = geometry
        self.junction_after = {(link.source, link.at_end): link.junction for link in links}
        self.link_of = {link.way: link for link in links}

    def points(self, signal: ET.Element, rid: int, kind: ControlKind, x: float, y: float) -> Iterator[ControlPoint]:
        """On a way through a junction: the road that leads into it; otherwise the road itself, as it is oriented."""
        link = self.link_of.get(rid)
        if link is not None:
            if link.source in self.geometry and _for_lanes(signal):
                s = self.geometry[link.source].length if link.at_end else 0.0
                yield from self._facing(signal, kind, x, y, link.source, s, link.at_end)
            return
        for facing, at_end in (("+", True), ("-", False)):
            valid = [v for pair in _validity(signal) for v in pair]
            meant = any(v < 0 if at_end else v > 0 for v in valid)  # CARLA's orientations say the opposite of the lanes
            if meant if valid else signal.get("orientation", "+") in (facing, "none"):
                yield from self._facing(signal, kind, x, y, rid, number(signal, "s"), at_end)

    def _facing(
        self, signal: ET.Element, kind: ControlKind, x: float, y: float, rid: int, s: float, at_end: bool
    ) -> Iterator[ControlPoint]:
        road = self.geometry[rid]
        lanes = tuple(lane.id for lane in road.section(s).driving(-1 if at_end else 1))
        validity = signal.find("validity")
        if validity is not None and rid not in self.link_of:
            low, high = sorted((number(validity, "fromLane"), number(validity, "toLane")))
            lanes = tuple(lane for lane in lanes if low <= lane <= high) or lanes
        if lanes:
            heading = road.at(s)[2] + (0.0 if at_end else math.pi)
            yield ControlPoint(kind, x, y, heading, rid, lanes, self.junction_after.get((rid, at_end)), s)
