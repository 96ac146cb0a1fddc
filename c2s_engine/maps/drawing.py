"""A map as a picture (SVG), from its own file: an overview with what each junction is, and close views to scale."""

import math
from collections.abc import Iterable, Iterator
from html import escape

from c2s_engine.maps.extras import MapExtras, Point, RoadInfo
from c2s_engine.maps.opendrive import Road

Box = tuple[float, float, float, float]
"""Least x, least y, greatest x, greatest y in m."""

PAPER, INK = "#fbfaf6", "#2b2b2b"
SURFACES = {
    "driving": "#5c6169",
    "parking": "#8a8f98",
    "shoulder": "#9aa0a6",
    "sidewalk": "#d9d2c5",
    "median": "#b9d3a5",
}
ROADS = {"motorway": "#3b6ea8", "rural": "#7a9a4d", "town": "#5c6169", "one way": "#a8743b"}
DOTS = {
    "signal": "#e07b00", "stop": "#c62828", "yield": "#8e44ad", "uncontrolled": "#9aa0a6",
    "roundabout": "#00897b", "on-ramp, off-ramp": "#1565c0", "crosswalk": "#ffffff",
}  # fmt: skip


def overview(extras: MapExtras, width: int = 1200, widen: float = 3.0) -> str:
    """The whole map, `width` pixels wide, with roads drawn `widen` times as wide as they are, and a legend."""
    box = bounds(extras)
    scale = width / (box[2] - box[0])
    height = (box[3] - box[1]) * scale
    lines = [_head(width, height + 46)]
    for info in sorted(extras.roads.values(), key=lambda r: r.junction is None):
        road = extras.geometry[info.id]
        stroke = max(1.5, _wide(road) * widen * scale)
        points = _points(((x, y) for x, y, _ in _along(road)), box, scale)
        colour = ROADS[_style(info, extras)]
        lines.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="{stroke:.1f}"/>')
    for (x, y), kind in _dots(extras):
        px, py = (x - box[0]) * scale, (box[3] - y) * scale
        radius = 2.2 if kind == "crosswalk" else 5.5
        lines.append(f'<circle cx="{px:.1f}" cy="{py:.1f}" r="{radius}" fill="{DOTS[kind]}" stroke="{INK}"/>')
    lines += _legend(extras, width, height)
    return "\n".join([*lines, "</svg>"])


def close_up(extras: MapExtras, centre: Point, metres: float, pixels: int = 380) -> str:
    """A square of the map to scale: lanes, crosswalks, lights and signs."""
    half = metres / 2
    box = (centre[0] - half, centre[1] - half, centre[0] + half, centre[1] + half)
    scale = pixels / metres
    lines = [_head(pixels, pixels)]
    for way in (True, False):
        for info in extras.roads.values():
            road = extras.geometry[info.id]
            if (info.junction is not None) == way and _meets(road, box):
                lines += _surfaces(road, box, scale, marked=not way)
    for crosswalk in extras.crosswalks:
        if _inside(crosswalk.centre, box, 30):
            lines += _stripes(crosswalk.polygon, box, scale)
    for control in extras.controls:
        if _inside((control.x, control.y), box, 0):
            x, y = (control.x - box[0]) * scale, (box[3] - control.y) * scale
            lines.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{DOTS[control.kind]}" stroke="{INK}"/>')
    return "\n".join([*lines, "</svg>"])


def sheet(extras: MapExtras, views: Iterable[tuple[str, Point, float]], width: int = 1200) -> str:
    """The overview with close views (title, centre, metres across) in a row below it."""
    views = list(views)
    top = overview(extras, width)
    height = float(top.split('height="', 1)[1].split('"', 1)[0])
    size = (width - 10 * (len(views) - 1)) // max(1, len(views))
    lines = [_head(width, height + (size + 26 if views else 0)), top]
    for number, (title, centre, metres) in enumerate(views):
        x, inner = number * (size + 10), close_up(extras, centre, metres, size)
        lines.append(f'<g transform="translate({x} {height + 22:.0f})">{inner}</g>')
        lines.append(f'<text x="{x + 2}" y="{height + 16:.0f}" {_font(13)}>{escape(title)}</text>')
    return "\n".join([*lines, "</svg>"])


def bounds(extras: MapExtras) -> Box:
    """What the map covers, with a margin."""
    points = [(x, y) for road in extras.geometry.values() for x, y, _ in _along(road)]
    xs, ys = zip(*points, strict=True)
    margin = 0.02 * max(max(xs) - min(xs), max(ys) - min(ys), 50.0)
    return min(xs) - margin, min(ys) - margin, max(xs) + margin, max(ys) + margin


def _head(width: float, height: float) -> str:
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
        f'viewBox="0 0 {width:.0f} {height:.0f}"><rect width="100%" height="100%" fill="{PAPER}"/>'
    )


def _font(size: int) -> str:
    return f'font-family="sans-serif" font-size="{size}" fill="{INK}"'


def _along(road: Road) -> Iterator[tuple[float, float, float]]:
    """Points of the reference line with s, closer together where it bends."""
    for piece in road.pieces:
        count = 1 if piece.kind == "line" else max(2, math.ceil(piece.length / 6))
        for i in range(count):
            s = piece.s + piece.length * i / count
            x, y, _ = piece.at(s - piece.s)
            yield x, y, s
    x, y, _ = road.at(road.length)
    yield x, y, road.length


def _wide(road: Road) -> float:
    section = road.sections[0]
    return sum(lane.width(0.0) for lane in section.lanes if lane.type in ("driving", "median"))


def _style(info: RoadInfo, extras: MapExtras) -> str:
    if info.junction is not None:
        return "town"
    if info.motorway or info.type == "motorway":
        return "motorway"
    if info.type == "rural":
        return "rural"
    ring = any(info.id in j.incoming for j in extras.junctions.values() if j.kind == "roundabout")
    return "one way" if 0 in (info.left, info.right) and not ring else "town"


def _dots(extras: MapExtras) -> Iterator[tuple[Point, str]]:
    rings = [_centre(extras, j.id) for j in extras.junctions.values() if j.kind == "roundabout"]
    if rings:
        xs, ys = zip(*rings, strict=True)
        yield (sum(xs) / len(xs), sum(ys) / len(ys)), "roundabout"
    for crosswalk in extras.crosswalks:
        yield crosswalk.centre, "crosswalk"
    for junction in extras.junctions.values():
        if junction.kind == "intersection":
            kinds = [extras.control(junction.id, road) for road in junction.incoming]
            yield _centre(extras, junction.id), next((kind for kind in kinds if kind), None) or "uncontrolled"
        elif junction.kind in ("on_ramp", "off_ramp"):
            yield _centre(extras, junction.id), "on-ramp, off-ramp"


def _centre(extras: MapExtras, junction: int) -> Point:
    ways = [extras.geometry[i] for i, road in extras.roads.items() if road.junction == junction]
    points = [way.at(way.length / 2)[:2] for way in ways]
    return sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points)


def _legend(extras: MapExtras, width: int, height: float) -> list[str]:
    used = {kind for _, kind in _dots(extras)}
    styles = {_style(info, extras) for info in extras.roads.values() if info.junction is None}
    lines, x, y = [], 12, height + 14
    for name, colour in ROADS.items():
        if name in styles:
            lines.append(f'<rect x="{x}" y="{y - 3:.0f}" width="22" height="6" fill="{colour}"/>')
            lines.append(f'<text x="{x + 27}" y="{y + 4:.0f}" {_font(13)}>{name}</text>')
            x += 50 + 8 * len(name)
    for name, colour in DOTS.items():
        if name in used:
            lines.append(f'<circle cx="{x + 6}" cy="{y:.0f}" r="5" fill="{colour}" stroke="{INK}"/>')
            lines.append(f'<text x="{x + 16}" y="{y + 4:.0f}" {_font(13)}>{name}</text>')
            x += 36 + 8 * len(name)
    bar = _round_length(extras, width)
    pixels = bar * width / (bounds(extras)[2] - bounds(extras)[0])
    lines.append(f'<path d="M12 {y + 20:.0f}h{pixels:.0f}" stroke="{INK}" stroke-width="2"/>')
    return [*lines, f'<text x="{pixels + 20:.0f}" y="{y + 25:.0f}" {_font(12)}>{bar:.0f} m (roads drawn wider)</text>']


def _round_length(extras: MapExtras, width: int) -> float:
    box = bounds(extras)
    return 10 ** math.floor(math.log10((box[2] - box[0]) / 4))


def _points(points: Iterable[Point], box: Box, scale: float) -> str:
    return " ".join(f"{(x - box[0]) * scale:.1f},{(box[3] - y) * scale:.1f}" for x, y in points)


def _inside(point: Point, box: Box, margin: float) -> bool:
    return box[0] - margin < point[0] < box[2] + margin and box[1] - margin < point[1] < box[3] + margin


def _meets(road: Road, box: Box) -> bool:
    points = [(x, y) for x, y, _ in _along(road)]
    xs, ys = zip(*points, strict=True)
    return min(xs) < box[2] + 30 and max(xs) > box[0] - 30 and min(ys) < box[3] + 30 and max(ys) > box[1] - 30


def _surfaces(road: Road, box: Box, scale: float, marked: bool) -> Iterator[str]:
    for number, section in enumerate(road.sections):
        end = road.sections[number + 1].s if number + 1 < len(road.sections) else road.length
        steps = [s for _, _, s in _along(road) if section.s < s < end]
        steps = [section.s, *steps, max(section.s, end - 1e-6)]
        for lane in section.lanes:
            if lane.type not in SURFACES:
                continue
            edges = [(s, *road.edges(s, lane.id, section)) for s in steps]
            inner = [road.at(s, t)[:2] for s, t, _ in edges]
            outer = [road.at(s, t)[:2] for s, _, t in reversed(edges)]
            kept = _clipped([*inner, *outer], box)
            line = ' stroke="#ffffff" stroke-width="0.6"' if lane.type == "driving" and marked else ""
            if kept:
                yield f'<polygon points="{_points(kept, box, scale)}" fill="{SURFACES[lane.type]}"{line}/>'


def _clipped(points: list[Point], box: Box) -> list[Point]:
    """The part of a polygon inside the box, edge by edge of the box."""
    for axis, limit, sign in ((0, box[0], 1), (1, box[1], 1), (0, box[2], -1), (1, box[3], -1)):
        kept: list[Point] = []
        for before, point in zip([points[-1], *points[:-1]], points, strict=True) if points else ():
            inside, was = sign * (point[axis] - limit) >= 0, sign * (before[axis] - limit) >= 0
            if inside != was:
                share = (limit - before[axis]) / (point[axis] - before[axis])
                kept.append(_between(before, point, share))
            if inside:
                kept.append(point)
        points = kept
    return points


def _stripes(polygon: tuple[Point, ...], box: Box, scale: float) -> Iterator[str]:
    """A crosswalk with four corners as bars across its longer sides; any other as its outline."""
    if len(polygon) != 4:
        yield f'<polygon points="{_points(polygon, box, scale)}" fill="none" stroke="#ffffff"/>'
        return
    a, b, c, d = polygon
    if math.dist(a, b) > math.dist(b, c):
        a, b, c, d = b, c, d, a
    count = max(2, round(math.dist(b, c) / 1.0))
    for i in range(0, count, 2):
        low, high = i / count, min(1.0, (i + 1) / count)
        corners = [_between(a, d, low), _between(b, c, low), _between(b, c, high), _between(a, d, high)]
        corners = _clipped(corners, box)
        yield f'<polygon points="{_points(corners, box, scale)}" fill="#ffffff"/>'


def _between(a: Point, b: Point, share: float) -> Point:
    return a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share
