"""Where crosswalks cross the lanes that cars drive in, from the map's own file."""

import math

from c2s_engine.maps.extras import Crosswalk, MapExtras
from c2s_engine.maps.opendrive import Lane, Road, Section
from c2s_engine.structure.specs import PlaceSpec

MID_BLOCK = 40.0
"""m between a crosswalk and the road's ends from which on it lies between junctions."""
AT_STOP_LINE = 12.0
"""m between the end of an approach and the middle of the crosswalk across it."""
AHEAD = 30.0
"""m of lane that a spot needs behind the crosswalk."""
LIMIT_TOLERANCE = 0.55  # m/s


def has_room_crosswalk(extras: MapExtras, crosswalk: Crosswalk) -> bool:
    """Whether a crosswalk lies mid-block."""
    road = extras.roads.get(crosswalk.road)
    return road is not None and road.junction is None and MID_BLOCK < crosswalk.s < road.length - MID_BLOCK


def approaches_with_crosswalk(extras: MapExtras) -> set[tuple[int, int]]:
    """(junction, road) of the approaches at whose stop line a crosswalk lies, whatever road the map hangs it on."""
    centres = [crosswalk.centre for crosswalk in extras.crosswalks]
    found = set()
    for junction, road, at_end in extras.approaches:
        end = extras.approach_end(road, at_end) if road in extras.geometry else None
        if end and any(math.dist(end, centre) < AT_STOP_LINE for centre in centres):
            found.add((junction, road))
    return found


def crosswalk_spots(extras: MapExtras, spec: PlaceSpec, before: float) -> list[tuple[float, float]]:
    """Middles of lanes at mid-block crosswalks that fit a spec, with so much lane (m) before them."""
    spots: list[tuple[float, float]] = []
    for crosswalk in extras.crosswalks:
        if not has_room_crosswalk(extras, crosswalk):
            continue
        info, road = extras.roads[crosswalk.road], extras.geometry[crosswalk.road]
        if spec.speed_limit is not None and abs((info.limit or 0.0) - spec.speed_limit) > LIMIT_TOLERANCE:
            continue
        section = road.section(crosswalk.s)
        for sign in (-1, 1):
            behind = crosswalk.s if sign < 0 else road.length - crosswalk.s
            if behind < max(before, MID_BLOCK) or road.length - behind < AHEAD or not _fits(spec, section, sign):
                continue
            spots += [_middle(road, crosswalk.s, lane) for lane in _chosen(spec, section.driving(sign))]
    return spots


def _fits(spec: PlaceSpec, section: Section, sign: int) -> bool:
    lanes = section.driving(sign)
    types = {lane.type for lane in section.side(sign)}
    other = section.side(-sign)
    adjoins = bool(lanes and other) and lanes[0].id == sign and other[0] in section.driving(-sign)
    return (
        len(lanes) >= (spec.lanes or 1)
        and (spec.oncoming is None or spec.oncoming == adjoins)
        and (spec.sidewalk is None or spec.sidewalk == ("sidewalk" in types))
        and (spec.shoulder is None or spec.shoulder == bool(types & {"shoulder", "parking", "stop", "border"}))
    )


def _chosen(spec: PlaceSpec, lanes: list[Lane]) -> list[Lane]:
    """The lanes (from the middle outwards) that `ego_lane` means."""
    cut = {"leftmost": slice(0, 1), "rightmost": slice(-1, None), "middle": slice(1, -1)}
    return lanes[cut[spec.ego_lane]] if spec.ego_lane else lanes


def _middle(road: Road, s: float, lane: Lane) -> tuple[float, float]:
    inner, outer = road.edges(s, lane.id)
    x, y, _ = road.at(s, (inner + outer) / 2)
    return x, y
