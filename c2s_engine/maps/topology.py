"""What a junction is, from its roads and ways alone: an intersection, a part of a roundabout, a merge or a diverge."""

import math
import xml.etree.ElementTree as ET
from collections import defaultdict
from dataclasses import dataclass
from typing import Literal

from c2s_engine.maps.controls import Link
from c2s_engine.maps.opendrive import Road, number

JunctionKind = Literal["intersection", "roundabout", "on_ramp", "off_ramp", "transition"]
GENTLE = math.radians(25)
"""Ways of merges and diverges turn by less, or by less than 60 degrees in a bend of a WIDE radius."""
WIDE = 40.0  # m


@dataclass(frozen=True)
class JunctionInfo:
    """A junction: its kind, the roads that lead into it and out of it, and those of them that are ramps."""

    id: int
    name: str
    kind: JunctionKind
    incoming: tuple[int, ...]
    outgoing: tuple[int, ...]
    on_ramps: tuple[int, ...] = ()
    off_ramps: tuple[int, ...] = ()


def junction_infos(
    root: ET.Element, links: list[Link], lanes: dict[int, tuple[int, int]], geometry: dict[int, Road]
) -> dict[int, JunctionInfo]:
    """Every junction with ways through it. `lanes`: driving lanes (left, right) of each road."""
    ways: dict[int, list[Link]] = defaultdict(list)
    for link in links:
        if link.way in geometry and link.source in geometry:
            ways[link.junction].append(link)
    names = {int(number(j, "id")): j.get("name") or "" for j in root.findall("junction")}
    marked = {
        int(number(reference, "junction"))
        for group in root.findall("junctionGroup")
        if group.get("type") == "roundabout"
        for reference in group.findall("junctionReference")
    }
    rings = marked or _rings(ways, lanes, geometry)
    return {
        jid: _info(jid, names.get(jid, ""), found, jid in rings, lanes, geometry)
        for jid, found in ways.items()
        if found
    }


def _info(
    jid: int, name: str, links: list[Link], ring: bool, lanes: dict[int, tuple[int, int]], geometry: dict[int, Road]
) -> JunctionInfo:
    incoming = tuple(dict.fromkeys(link.source for link in links))
    outgoing = tuple(dict.fromkeys(link.target for link in links if link.target is not None))
    if ring:
        return JunctionInfo(jid, name, "roundabout", incoming, outgoing)
    driven = [link for link in links if any(lanes[link.way])]
    if any(_bends(geometry[link.way]) for link in driven):
        return JunctionInfo(jid, name, "intersection", incoming, outgoing)
    streams = _streams(driven)

    def ramp(roads: set[int]) -> list[int]:
        one_way = [r for r in roads if r in lanes and 0 in lanes[r]]
        return sorted(one_way, key=lambda r: (sum(lanes[r]), r))[:1]

    on_ramps = tuple(r for into, out in streams if len(into) > 1 and len(out) == 1 for r in ramp(into))
    off_ramps = tuple(r for into, out in streams if len(into) == 1 and len(out) > 1 for r in ramp(out))
    if on_ramps or off_ramps:
        kind: JunctionKind = "on_ramp" if on_ramps else "off_ramp"
        return JunctionInfo(jid, name, kind, incoming, outgoing, on_ramps, off_ramps)
    through = all(len(into) == len(out) == 1 for into, out in streams)
    return JunctionInfo(jid, name, "transition" if through else "intersection", incoming, outgoing)


def _streams(links: list[Link]) -> list[tuple[set[int], set[int]]]:
    """The ways of a junction by what they have in common, each stream of traffic with the roads that it comes from and
    goes to: the two directions of a road are streams of their own."""
    streams: list[tuple[set[tuple[int, bool]], set[tuple[int | None, bool]]]] = []
    for link in links:
        into, out = {(link.source, link.at_end)}, {(link.target, link.target_start)}
        for other in [s for s in streams if s[0] & into or s[1] & out]:
            streams.remove(other)
            into, out = into | other[0], out | other[1]
        streams.append((into, out))
    return [({r for r, _ in into}, {r for r, _ in out if r is not None}) for into, out in streams]


def _bends(way: Road) -> bool:
    """Whether a way turns off, as no way of a merge or diverge does."""
    turned = abs(turn(way))
    return turned > math.radians(60) or turned > GENTLE and way.length < WIDE * turned


def turn(road: Road) -> float:
    """Change of heading from a road's start to its end, left positive."""
    return math.remainder(road.at(road.length)[2] - road.at(0.0)[2], math.tau)


def _rings(ways: dict[int, list[Link]], lanes: dict[int, tuple[int, int]], geometry: dict[int, Road]) -> set[int]:
    """Junctions on a circle of one-way roads that bend to the left, for maps that do not mark roundabouts."""
    into = {(link.source, link.at_end): junction for junction, found in ways.items() for link in found}
    following: dict[int, set[int]] = defaultdict(set)
    for junction, found in ways.items():
        for link in found:
            if link.target not in geometry or 0 not in lanes[link.target]:
                continue
            bend = turn(geometry[link.target]) * (1 if link.target_start else -1)
            after = into.get((link.target, link.target_start))
            if after is not None and after != junction and math.radians(8) < bend < math.radians(200):
                following[junction].add(after)
    found_rings: set[int] = set()
    for start in tuple(following):
        path = [start]
        while len(path) <= 10 and len(following[path[-1]]) == 1:
            (step,) = following[path[-1]]
            if step == start:
                if len(path) >= 3:
                    found_rings.update(path)
                break
            if step in path:
                break
            path.append(step)
    return found_rings
