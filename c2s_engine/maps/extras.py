"""What Scenic's parser drops, read from the map's XML: crosswalks, limits, signs, lights, and what junctions are.

No Scenic here. Positions in m in map coordinates, headings in rad counterclockwise from the x axis, speeds in m/s.
"""

import math
import os
import xml.etree.ElementTree as ET
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from c2s_engine.maps import opendrive
from c2s_engine.maps.controls import ControlKind, ControlPoint, Link, read_controls
from c2s_engine.maps.opendrive import BrokenMap, number
from c2s_engine.maps.topology import JunctionInfo, junction_infos

Point = tuple[float, float]

LIGHT = "1000001"
"""The type of signal that stock Scenic takes for a traffic light."""
UNITS = {"m/s": 1.0, "km/h": 1 / 3.6, "mph": 0.44704}
MOTORWAY_LIMIT = 24.0
"""m/s: a one-way or divided road of two lanes or more without a sidewalk and with at least this limit counts as a
motorway where types say nothing (CARLA's towns post 55 mph on city streets too)."""


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
class RoadInfo:
    """A road outside junctions (`junction` None) or a way through one; `left`, `right`: driving lanes each way;
    `divided`: something lies between those."""

    id: int
    name: str
    length: float
    junction: int | None
    type: str
    limit: float | None
    left: int
    right: int
    sidewalk: bool
    divided: bool = False

    @property
    def motorway(self) -> bool:
        apart = (self.divided or 0 in (self.left, self.right)) and not self.sidewalk
        fast = self.type == "motorway" or (apart and (self.limit or 0.0) >= MOTORWAY_LIMIT)
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
    stretches: tuple[tuple[float, int], ...] = ()
    """(m, driving lanes in one direction at most) of all roads that lead to one another without a junction"""
    signs_on_ways: bool = False
    """Whether ways through junctions refer to more than lights: stock Scenic then calls any sign signalised."""

    def longest(self, lanes: int = 1) -> float:
        """How long (m) no stretch of road without a junction is, with so many lanes in one direction."""
        return max((1.1 * length for length, most in self.stretches if most >= lanes), default=0.0)

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

    def ramps(self, kind: str) -> set[int]:
        """The roads that are ramps: on to others ("on_ramp") or off them ("off_ramp")."""
        return {r for j in self.junctions.values() for r in (j.on_ramps if kind == "on_ramp" else j.off_ramps)}


def read_extras(path: str | Path) -> MapExtras:
    """The extras of a map file, kept in memory while the file does not change. Raises BrokenMap."""
    path = Path(path)
    try:
        state = path.stat()
    except OSError as error:
        raise BrokenMap(f"{path.name} cannot be read: {error.strerror or error}.") from None
    return _read(Path(os.path.realpath(path)), state.st_mtime_ns, state.st_size)


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
    controls = read_controls(elements, geometry, connections)
    stretches = _stretches(elements, roads)
    return MapExtras(roads, junctions, crosswalks, controls, geometry, approaches, stretches, _signs_on_ways(elements))


def _stretches(elements: list[ET.Element], roads: dict[int, RoadInfo]) -> tuple[tuple[float, int], ...]:
    """Of each component of roads that are linked to one another."""
    part = {i: {i} for i, road in roads.items() if road.junction is None}
    for element in elements:
        for end in element.findall("link/*[@elementType='road']"):
            one, other = int(number(element, "id")), int(number(end, "elementId"))
            if one in part and other in part and part[one] is not part[other]:
                part[one] |= part[other]
                part.update(dict.fromkeys(part[other], part[one]))
    found = [[roads[i] for i in members] for members in {id(members): members for members in part.values()}.values()]
    return tuple((sum(r.length for r in each), max(max(r.left, r.right) for r in each)) for each in found)


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
        any(lane.type == "sidewalk" for lane in section.lanes), _divided(section),
    )  # fmt: skip


def _divided(section: opendrive.Section) -> bool:
    """Whether something lies between the lanes of the two directions."""
    left, right = section.driving(1), section.driving(-1)
    return bool(left and right) and left[0].id - right[0].id > 2


def _signs_on_ways(elements: list[ET.Element]) -> bool:
    types = {each.get("id"): each.get("type") for element in elements for each in element.findall("signals/signal")}
    ways = [element for element in elements if number(element, "junction", -1) >= 0]
    marks = [mark.get("id") for way in ways for signals in way.findall("signals") for mark in signals]
    return any(types.get(mark, LIGHT) != LIGHT for mark in marks)


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
