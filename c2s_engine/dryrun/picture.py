"""Top-down pictures of a run: SVG, PNG, and text (half blocks). No Scenic here: the front draws them.

The road comes with the trajectories (`outline`); north is up.
"""

import io
import math
from collections.abc import Iterator
from xml.sax.saxutils import escape

from c2s_engine.structure.facts import Track, Trajectories

Point = tuple[float, float]
FILLS = {"sidewalk": "#d9d4c7", "shoulder": "#b9bdb4", "junction": "#8f949b", "lane": "#9aa0a6", "crosswalk": "#eceff1",
         "arrow": "#c3c7cc"}  # fmt: skip
COLOURS = ("#d62728", "#1f77b4", "#2ca02c", "#9467bd", "#ff7f0e", "#8c564b", "#e377c2", "#17becf")
PROP = "#6b5b45"
GROUND = "#eef1ea"
MARGIN = 15.0


def colour_of(tracks: tuple[Track, ...], i: int) -> str:
    """ego is red, props are brown, the others take turns."""
    if tracks[i].kind == "prop":
        return PROP
    if tracks[i].name == "ego":
        return COLOURS[0]
    place = sum(1 for t in tracks[:i] if t.kind != "prop" and t.name != "ego")
    return COLOURS[1 + place % (len(COLOURS) - 1)]


def frames(ways: Trajectories) -> int:
    """How many steps there are to show."""
    return len(ways.tracks[0].x) if ways.tracks else 0


def corners(track: Track, frame: int) -> list[Point]:
    """The box of an object at a step."""
    x, y, heading = track.x[frame], track.y[frame], track.heading[frame]
    sin, cos = math.sin(heading), math.cos(heading)
    ahead = (-sin * track.length / 2, cos * track.length / 2)
    aside = (cos * track.width / 2, sin * track.width / 2)
    return [
        (x + a * ahead[0] + b * aside[0], y + a * ahead[1] + b * aside[1])
        for a, b in ((1, -1), (-1, -1), (-1, 1), (1, 1))
    ]


def bounds(ways: Trajectories) -> tuple[float, float, float, float]:
    """(west, south, east, north) of all that is seen, m."""
    xs = [v for t in ways.tracks for v in (min(t.x), max(t.x))]
    ys = [v for t in ways.tracks for v in (min(t.y), max(t.y))]
    west, south, east, north = min(xs) - MARGIN, min(ys) - MARGIN, max(xs) + MARGIN, max(ys) + MARGIN
    return west, south, max(east, west + 2 * MARGIN), max(north, south + 2 * MARGIN)


def svg_picture(ways: Trajectories, frame: int = -1, width: int = 900) -> str:
    """The run as SVG: roads, trails, boxes at one step (the last by default), names."""
    if not frames(ways):
        return f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="40"/>'
    frame = frame % frames(ways)
    west, south, east, north = bounds(ways)
    scale = width / (east - west)
    height = (north - south) * scale

    def at(points: list[Point] | tuple[Point, ...]) -> str:
        return " ".join(f"{(x - west) * scale:.1f},{(north - y) * scale:.1f}" for x, y in points)

    size = f'viewBox="0 0 {width} {height:.0f}" width="{width}" height="{height:.0f}"'
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size}>',
        f'<rect width="100%" height="100%" fill="{GROUND}"/>',
    ]
    for kind, rings in ways.outline.items():
        stroke = ' stroke="#ffffff" stroke-width="0.8"' if kind == "lane" else ""
        parts += [f'<polygon points="{at(ring)}" fill="{FILLS.get(kind, "#999999")}"{stroke}/>' for ring in rings]
    for i, track in enumerate(ways.tracks):
        colour = colour_of(ways.tracks, i)
        if track.kind != "prop":
            trail = at(list(zip(track.x[: frame + 1], track.y[: frame + 1], strict=True)))
            parts.append(f'<polyline points="{trail}" fill="none" stroke="{colour}" stroke-width="1.5" opacity="0.6"/>')
        box = corners(track, frame)
        parts.append(f'<polygon points="{at(box)}" fill="{colour}" stroke="#222222" stroke-width="0.6"/>')
        if track.kind not in ("prop", "walker"):
            nose = [box[0], box[3]]
            parts.append(f'<polyline points="{at(nose)}" stroke="#ffffff" stroke-width="1.5"/>')
        x, y = (track.x[frame] - west) * scale + 6, (north - track.y[frame]) * scale - 6
        parts.append(
            f'<text x="{x:.1f}" y="{y:.1f}" font-family="sans-serif" font-size="11">{escape(track.name)}</text>'
        )
    seconds = f"{frame * ways.step:.1f} s"
    parts += [
        f'<text x="6" y="16" font-family="sans-serif" font-size="12">{seconds}</text>',
        *_rule(scale, height),
        "</svg>",
    ]
    return "\n".join(parts)


def _rule(scale: float, height: float) -> list[str]:
    """A scale bar of 10, 20, 50 or 100 m."""
    metres = next((m for m in (10, 20, 50, 100, 200, 500) if m * scale >= 60), 500)
    y = height - 10
    return [
        f'<line x1="6" y1="{y:.0f}" x2="{6 + metres * scale:.0f}" y2="{y:.0f}" stroke="#222222" stroke-width="2"/>',
        f'<text x="6" y="{y - 5:.0f}" font-family="sans-serif" font-size="11">{metres} m</text>',
    ]


def png_picture(ways: Trajectories, frame: int = -1, width: int = 900) -> bytes:
    """The same as PNG."""
    from PIL import Image, ImageDraw

    if not frames(ways):
        ways = Trajectories(
            step=ways.step, tracks=(Track(name="", x=(0,), y=(0,), heading=(0,), speed=(0,), length=0, width=0),)
        )
    frame = frame % frames(ways)
    west, south, east, north = bounds(ways)
    scale = width / (east - west)
    image = Image.new("RGB", (width, max(1, round((north - south) * scale))), GROUND)
    draw = ImageDraw.Draw(image)

    def at(points: list[Point] | tuple[Point, ...]) -> list[Point]:
        return [((x - west) * scale, (north - y) * scale) for x, y in points]

    for kind, rings in ways.outline.items():
        for ring in rings:
            draw.polygon(at(ring), fill=FILLS.get(kind, "#999999"), outline="#ffffff" if kind == "lane" else None)
    for i, track in enumerate(ways.tracks):
        colour = colour_of(ways.tracks, i)
        if track.kind != "prop" and frame:
            draw.line(at(list(zip(track.x[: frame + 1], track.y[: frame + 1], strict=True))), fill=colour, width=2)
        draw.polygon(at(corners(track, frame)), fill=colour, outline="#222222")
        x, y = at([(track.x[frame], track.y[frame])])[0]
        draw.text((x + 6, y - 14), track.name, fill="#222222")
    draw.text((6, 4), f"{frame * ways.step:.1f} s", fill="#222222")
    data = io.BytesIO()
    image.save(data, "PNG")
    return data.getvalue()


def text_picture(ways: Trajectories, frame: int = -1, columns: int = 80, rows: int = 30) -> str:
    """The run at one step as text: roads in shades, trails as dots, each object by a letter, with a legend."""
    return "\n".join(line for line, _ in _text(ways, frame, columns, rows))


def text_frames(ways: Trajectories, columns: int = 80, rows: int = 30, every: float = 0.5) -> Iterator[str]:
    """Text pictures, one each `every` s."""
    for frame in range(0, frames(ways), max(1, round(every / ways.step))):
        yield text_picture(ways, frame, columns, rows)


def letters(tracks: tuple[Track, ...]) -> list[str]:
    """A letter for each object: E for ego, then A, B, C, ...; props are lower case."""
    found, count = [], 0
    names = "ABCDFGHIJKLMNOPQRSTUVWXYZ"
    for track in tracks:
        if track.name == "ego":
            found.append("E")
        else:
            letter = names[count % len(names)]
            found.append(letter.lower() if track.kind == "prop" else letter)
            count += 1
    return found


def _text(ways: Trajectories, frame: int, columns: int, rows: int) -> Iterator[tuple[str, int]]:
    if not frames(ways):
        yield "(nothing was recorded)", -1
        return
    frame = frame % frames(ways)
    legend = _legend(ways, frame, columns)
    rows = max(3, rows - len(legend))
    west, south, east, north = bounds(ways)
    cell = max((east - west) / columns, (north - south) / (2 * rows))
    middle = (west + east) / 2, (south + north) / 2
    left, top = middle[0] - cell * columns / 2, middle[1] + cell * rows
    grid = [[" "] * columns for _ in range(rows)]
    for kind, shade in (("sidewalk", "·"), ("shoulder", "·"), ("junction", "░"), ("lane", "░"), ("crosswalk", "▒")):
        for ring in ways.outline.get(kind, ()):
            _fill(grid, ring, shade, left, top, cell)
    for track in ways.tracks:
        if track.kind != "prop":
            for x, y in zip(track.x[: frame + 1], track.y[: frame + 1], strict=True):
                _put(grid, x, y, "•", left, top, cell)
    for letter, track in sorted(zip(letters(ways.tracks), ways.tracks, strict=True), key=lambda pair: pair[0] == "E"):
        shape = corners(track, frame)
        _fill(grid, tuple(shape), letter, left, top, cell)
        _put(grid, track.x[frame], track.y[frame], letter, left, top, cell)
    for i, row in enumerate(grid):
        yield "".join(row).rstrip(), i
    for line in legend:
        yield line, -1


def _legend(ways: Trajectories, frame: int, columns: int) -> list[str]:
    lines = [f"{frame * ways.step:.1f} s"]
    for letter, track in zip(letters(ways.tracks), ways.tracks, strict=True):
        entry = f"{letter} {track.name}"
        if track.kind != "prop":
            entry += f" {track.speed[frame] * 3.6:.0f} km/h"
        if len(lines[-1]) + len(entry) + 3 > columns:
            lines.append(entry)
        else:
            lines[-1] += f"   {entry}"
    return lines


def _put(grid: list[list[str]], x: float, y: float, mark: str, left: float, top: float, cell: float) -> None:
    column, row = int((x - left) / cell), int((top - y) / (2 * cell))
    if 0 <= row < len(grid) and 0 <= column < len(grid[0]):
        grid[row][column] = mark


def _fill(grid: list[list[str]], ring: tuple[Point, ...], mark: str, left: float, top: float, cell: float) -> None:
    """Fill the cells whose middle is in the polygon, row by row."""
    ys = [y for _, y in ring]
    first, last = int((top - max(ys)) / (2 * cell)), int((top - min(ys)) / (2 * cell))
    for row in range(max(0, first), min(len(grid) - 1, last) + 1):
        y = top - (row + 0.5) * 2 * cell
        cuts = []
        for (x1, y1), (x2, y2) in zip(ring, (*ring[1:], ring[0]), strict=True):
            if (y1 > y) != (y2 > y):
                cuts.append(x1 + (y - y1) * (x2 - x1) / (y2 - y1))
        cuts.sort()
        for start, end in zip(cuts[::2], cuts[1::2], strict=False):
            low, high = math.ceil((start - left) / cell - 0.5), math.floor((end - left) / cell - 0.5)
            for column in range(max(0, low), min(len(grid[0]) - 1, high) + 1):
                grid[row][column] = mark
