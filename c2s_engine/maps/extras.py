"""What Scenic's parser drops, read from the map's XML: crosswalks, limits, signs, lights, and what junctions are.

No Scenic here. Positions in m in map coordinates, headings in rad counterclockwise from the x axis, speeds in m/s.
"""

import math
import xml.etree.ElementTree as ET
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Literal

from c2s_engine.maps import opendrive
from c2s_engine.maps.opendrive import BrokenMap, number
from c2s_engine.maps.topology import JunctionInfo, Link, junction_infos

Point = tuple[float, float]
ControlKind = Literal["signal", "stop", "yield"]

UNITS = {"m/s": 1.0, "km/h": 1 / 3.6, "mph": 0.44704}
MOTORWAY_LIMIT = 24.0
"""m/s: a road of two lanes a direction with at least this limit counts as a motorway where types say nothing."""


@dataclass(frozen=True)
class Crosswalk:
    """A crosswalk: its outline, and where it crosses which road (`s`: distance of its middle from the road's start)."""

    road: int
    s: float
    polygon: tuple[Point, ...]

    @property
    def centre(self) -> Point:
        xs, ys = zip(*self.polygon, strict=True)
        return sum(xs) / len(xs), sum(ys) / len(ys)


@dataclass(frozen=True)
class ControlPoint:
    """A traffic light, stop or yield sign: where it stands, which way the traffic goes that it faces, and whom."""

    kind: ControlKind
    x: float
    y: float
    heading: float
    road: int
    lanes: tuple[int, ...]
    junction: int | None
    s: float


@dataclass(frozen=True)
class RoadInfo:
    """A road outside junctions (`junction` None) or a way through one; `left`, `right`: driving lanes each way."""

    id: int
    name: str
    length: float
    junction: int | None
    type: str
    limit: float | None
    left: int
    right: int

    @property
    def motorway(self) -> bool:
        fast = self.type == "motorway" or (self.limit or 0.0) >= MOTORWAY_LIMIT
        return fast and max(self.left, self.right) >= 2


@dataclass(frozen=True)
class MapExtras:
    """All that the XML says beyond Scenic's network."""

    roads: dict[int, RoadInfo]
    junctions: dict[int, JunctionInfo]
    crosswalks: tuple[Crosswalk, ...]
    controls: tuple[ControlPoint, ...]
    geometry: dict[int, opendrive.Road]
    approaches: frozenset[tuple[int, int, bool]]
    """(junction, road, whether the road's end meets it)"""

    def limit(self, road: int) -> float | None:
        """The posted limit on a road or on a junction's way (m/s), where the map has one."""
        info = self.roads.get(road)
        return info.limit if info else None

    def control(self, junction: int, road: int) -> ControlKind | None:
        """What regulates the approach from a road into a junction."""
        kinds = {c.kind for c in self.controls if c.junction == junction and c.road == road}
        for kind in ("signal", "stop", "yield"):
            if kind in kinds:
                return kind
        return None

    def of_kind(self, *kinds: str) -> set[int]:
        """Ids of the junctions of those kinds."""
        return {j.id for j in self.junctions.values() if j.kind in kinds}


def read_extras(path: str | Path) -> MapExtras:
    """The extras of a map file, kept in memory while the file does not change. Raises BrokenMap."""
    path = Path(path)
    try:
        state = path.stat()
    except OSError as error:
        raise BrokenMap(f"{path.name} cannot be read: {error.strerror or error}.") from None
    return _read(path, state.st_mtime_ns, state.st_size)


@lru_cache(maxsize=16)
def _read(path: Path, mtime: int, size: int) -> MapExtras:
    root = opendrive.parse(path)
    geometry: dict[int, opendrive.Road] = {}
    roads: dict[int, RoadInfo] = {}
    elements = root.findall("road")
    if not elements:
        raise BrokenMap(f"{path.name} has no roads.")
    for element in elements:
        road = opendrive.read_road(element)
        geometry[road.id] = road
        roads[road.id] = _road_info(element, road)
    connections = _connections(root)
    junctions = junction_infos(root, connections, {i: (r.left, r.right) for i, r in roads.items()}, geometry)
    crosswalks = tuple(c for e in elements for c in _crosswalks(e, geometry[int(number(e, "id"))]))
    approaches = frozenset((link.junction, link.source, link.at_end) for link in connections)
    return MapExtras(roads, junctions, crosswalks, tuple(_controls(elements, geometry, roads, connections)), geometry, approaches)


def _road_info(element: ET.Element, road: opendrive.Road) -> RoadInfo:
    kinds = element.findall("type")
    limit = None
    for kind in kinds:
        speed = kind.find("speed")
        if limit is None and speed is not None and speed.get("max") not in (None, "no limit", "undefined"):
            limit = number(speed, "max") * UNITS.get(speed.get("unit", "m/s"), 1.0)
    section = max(road.sections, key=lambda sec: len(sec.driving(1)) + len(sec.driving(-1)))
    junction = int(number(element, "junction", -1))
    return RoadInfo(
        road.id, element.get("name") or "", road.length, junction if junction >= 0 else None,
        kinds[0].get("type", "") if kinds else "", limit, len(section.driving(1)), len(section.driving(-1)),
    )  # fmt: skip


def _connections(root: ET.Element) -> list[Link]:
    """Every way through a junction, with the road that it comes from and the road that it leads to."""
    ends: dict[int, dict[str, ET.Element]] = {}
    for road in root.findall("road"):
        link = road.find("link")
        ends[int(number(road, "id"))] = {} if link is None else {child.tag: child for child in link}
    links = []
    for junction in root.findall("junction"):
        for connection in junction.findall("connection"):
            if connection.get("connectingRoad") is None:
                continue
            way, source = int(number(connection, "connectingRoad")), int(number(connection, "incomingRoad"))
            forward = connection.get("contactPoint", "start") == "start"
            begin = ends.get(way, {}).get("predecessor" if forward else "successor")
            end = ends.get(way, {}).get("successor" if forward else "predecessor")
            links.append(Link(
                junction=int(number(junction, "id")), source=source, way=way, forward=forward,
                at_end=begin is None or begin.get("contactPoint", "end") == "end",
                target=int(number(end, "elementId")) if end is not None and end.get("elementType") == "road" else None,
                target_start=end is None or end.get("contactPoint", "start") == "start"))  # fmt: skip
    return links


def _crosswalks(element: ET.Element, road: opendrive.Road) -> list[Crosswalk]:
    found = []
    for item in element.findall("objects/object"):
        if item.get("type") != "crosswalk":
            continue
        s, t, turn = number(item, "s"), number(item, "t"), number(item, "hdg", 0.0)
        x, y, heading = road.at(s, t)
        c, sn = math.cos(heading + turn), math.sin(heading + turn)
        corners = [(number(corner, "u"), number(corner, "v")) for corner in item.iter("cornerLocal")]
        points = [(x + u * c - v * sn, y + u * sn + v * c) for u, v in corners]
        points += [road.at(number(corner, "s"), number(corner, "t"))[:2] for corner in item.iter("cornerRoad")]
        if len(points) > 1 and math.dist(points[0], points[-1]) < 1e-6:
            points.pop()
        if len(points) < 3 and item.get("width") and item.get("length"):
            ahead, aside = number(item, "length") / 2, number(item, "width") / 2
            box = ((-ahead, -aside), (ahead, -aside), (ahead, aside), (-ahead, aside))
            points = [(x + u * c - v * sn, y + u * sn + v * c) for u, v in box]
        if len(points) >= 3:
            found.append(Crosswalk(road.id, s, tuple(points)))
    return found


def _kind(signal: ET.Element) -> ControlKind | None:
    """By the type numbers of CARLA's maps and the German catalogue that they follow."""
    number_, name = signal.get("type", ""), (signal.get("name") or "").lower()
    if number_ in ("1000001", "1000009", "1000010", "1000011"):
        return "signal"
    if number_ == "206" or "stop" in name and signal.get("dynamic") != "yes":
        return "stop"
    return "yield" if number_ == "205" else None


def _controls(elements: list[ET.Element], geometry: dict[int, opendrive.Road], roads: dict[int, RoadInfo],
              links: list[Link]) -> list[ControlPoint]:  # fmt: skip
    """Lights and signs on approaches, and those that ways through junctions refer to, as of their approaches."""
    found: dict[tuple[str, int, int | None, str], ControlPoint] = {}
    placed: dict[str, tuple[ControlKind, float, float]] = {}
    after = {(link.source, link.at_end): link.junction for link in links}
    way_of = {link.way: link for link in links}
    for element in elements:
        for signal in element.findall("signals/signal"):
            kind = _kind(signal)
            if kind:
                road = geometry[int(number(element, "id"))]
                x, y, _ = road.at(number(signal, "s"), number(signal, "t", 0.0))
                placed[signal.get("id", "")] = (kind, x, y)
    for element in elements:
        rid = int(number(element, "id"))
        for signal in [*element.findall("signals/signal"), *element.findall("signals/signalReference")]:
            mark = signal.get("id", "")
            if mark not in placed:
                continue
            kind, x, y = placed[mark]
            for point in _approaches(signal, rid, kind, x, y, geometry, roads, after, way_of):
                found.setdefault((kind, point.road, point.junction, mark), point)
    return list(found.values())


def _approaches(signal: ET.Element, rid: int, kind: ControlKind, x: float, y: float, geometry: dict[int, opendrive.Road],
                roads: dict[int, RoadInfo], after: dict[tuple[int, bool], int], way_of: dict[int, Link]) -> list[ControlPoint]:  # fmt: skip
    """The control as it faces an approach: of its own road, or of the road that leads into its way."""
    road, s = geometry[rid], number(signal, "s")
    validity = signal.find("validity")
    if roads[rid].junction is not None:
        link = way_of.get(rid)
        if link is None or link.source not in geometry:
            return []
        source = geometry[link.source]
        s = source.length if link.at_end else 0.0
        heading = source.at(s)[2] + (0.0 if link.at_end else math.pi)
        sign = -1 if link.at_end else 1
        lanes = tuple(lane.id for lane in source.section(s).driving(sign))
        return [ControlPoint(kind, x, y, heading, source.id, lanes, link.junction, s)]
    points = []
    for facing, sign in (("+", -1), ("-", 1)):
        if signal.get("orientation", "+") not in (facing, "none"):
            continue
        at_end = facing == "+"
        lanes = tuple(lane.id for lane in road.section(s).driving(sign))
        if validity is not None:
            low, high = sorted((number(validity, "fromLane"), number(validity, "toLane")))
            lanes = tuple(lane for lane in lanes if low <= lane <= high)
        heading = road.at(s)[2] + (0.0 if at_end else math.pi)
        if lanes:
            points.append(ControlPoint(kind, x, y, heading, rid, lanes, after.get((rid, at_end)), s))
    return points
