"""One frame of a run from above as an image, and that image as half blocks with the labels written over it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from PIL import Image, ImageDraw, ImageFont
from textual.color import Color
from textual.content import Content

from c2s_engine.dryrun.picture import Point, corners
from c2s_engine.structure.facts import EGO, ContactFact, Track, Trajectories
from c2s_tui.picture.draw import TRAIL_SECONDS, Canvas, View, arrow_of, canvas_of, kind_of, where_of

FINER = 3
"""The image is drawn so many times larger and then made smaller, so that slanted borders are smooth."""
ROADS = ("sidewalk", "shoulder", "junction", "lane", "crosswalk")
BORDERS_TO = 1.6
"""m a column up to which the borders of lanes are drawn."""
ARROWS_TO = 3.0
"""m a column up to which the arrows of lanes are drawn."""


@dataclass(frozen=True)
class Palette:
    """Colours (red, green, blue) of road parts (by kind), borders, contacts, and of components (by letter)."""

    ground: tuple[int, int, int]
    border: tuple[int, int, int]
    hit: tuple[int, int, int]
    roads: Mapping[str, tuple[int, int, int]]
    kinds: Mapping[str, tuple[int, int, int]]


def palette(colours: Mapping[str, str]) -> Palette:
    """From the variables of a theme."""
    ground, ink = Color.parse(colours["background"]), Color.parse(colours["foreground"])
    shares = {"sidewalk": 0.14, "shoulder": 0.10, "junction": 0.24, "lane": 0.24, "crosswalk": 0.5}
    return Palette(
        ground=ground.rgb, border=ground.blend(ink, 0.5).rgb, hit=Color.parse(colours["error"]).rgb,
        roads={kind: ground.blend(ink, share).rgb for kind, share in shares.items()},
        kinds={letter: Color.parse(colours[f"kind-{letter.lower()}"]).rgb for letter in "GRETO"},
    )  # fmt: skip


def paint(
    ways: Trajectories, frame: int, columns: int, rows: int, labels: Mapping[str, str], view: View, colours: Palette,
    contacts: Sequence[ContactFact] = (), cell: tuple[int, int] = (1, 2), written: bool = False,
) -> Image.Image:  # fmt: skip
    """An image of (columns x cell width, rows x cell height) pixels; `written`: with the labels in it."""
    canvas = canvas_of(ways, frame, columns, rows, view)
    size = columns * cell[0], rows * cell[1]
    finer = FINER if cell[0] < 4 else 1
    image = Image.new("RGB", (size[0] * finer, size[1] * finer), colours.ground)
    draw = ImageDraw.Draw(image)
    a_metre = cell[0] * finer / canvas.scale

    def at(points: Sequence[Point]) -> list[Point]:
        return [((x - canvas.left) * a_metre, (canvas.top - y) * a_metre) for x, y in points]

    _roads(draw, ways, canvas, at, colours, max(1, round(a_metre * 0.15)))
    for arrow in ways.outline.get("arrow", ()) if written else ():
        draw.polygon(at(arrow), fill=colours.border)
    first = max(0, frame - int(TRAIL_SECONDS / ways.step))
    for track in sorted(ways.tracks, key=lambda t: t.name == EGO):
        colour = colours.kinds[kind_of(labels[track.name])]
        trail = at([(track.x[i], track.y[i]) for i in range(first, frame + 1)])
        if track.kind != "prop" and len(trail) > 1:
            draw.line(trail, fill=_between(colour, colours.roads["lane"], 0.5), width=max(1, round(a_metre * 0.4)))
        _box(draw, at, track, frame, colour, colours.ground, a_metre)
    for hit in contacts:
        if (place := where_of(ways, hit, frame)) is not None:
            (x, y), reach = at([place])[0], max(1.2 * a_metre, finer)
            draw.ellipse((x - reach, y - reach, x + reach, y + reach), outline=colours.hit, width=max(1, finer))
    if written:
        _names(draw, at, ways, frame, labels, colours, a_metre)
    return image.resize(size, Image.Resampling.BOX) if finer > 1 else image


def blocks(
    image: Image.Image, ways: Trajectories, frame: int, labels: Mapping[str, str], view: View, colours: Palette,
    contacts: Sequence[ContactFact] = (),
) -> Content:  # fmt: skip
    """Two pixels a cell (upper half block), and over them the labels, headings, contacts and arrows of the lanes."""
    columns, rows = image.width, image.height // 2
    canvas = canvas_of(ways, frame, columns, rows, view)
    pixels = image.load()
    if canvas.scale <= ARROWS_TO:
        for tip, *base in ways.outline.get("arrow", ()):
            middle = base[0][0] / 2 + base[1][0] / 2, base[0][1] / 2 + base[1][1] / 2
            canvas.put(*tip, arrow_of(_heading(middle, tip)), "arrow")
    canvas.labels(ways, frame, labels)
    for hit in contacts:
        if (place := where_of(ways, hit, frame)) is not None:
            canvas.put(*place, "✸", "hit")
    parts: list[tuple[str, str]] = []
    for row in range(rows):
        for column in range(columns):
            upper, lower = pixels[column, 2 * row], pixels[column, 2 * row + 1]  # type: ignore[index]
            letter, style = canvas.cells[row][column]
            if letter == " ":
                same = upper == lower
                letter, style = " " if same else "▀", f"{'' if same else _hex(upper)} on {_hex(lower)}"
            elif style in ("arrow", "hit"):
                ink = colours.border if style == "arrow" else colours.hit
                style = f"{_hex(ink)} on {_hex(_between(upper, lower, 0.5))}"
            if parts and parts[-1][1] == style:
                parts[-1] = (parts[-1][0] + letter, style)
            else:
                parts.append((letter, style))
        parts.append(("\n", ""))
    return Content.assemble(*parts[:-1])


def _roads(draw, ways: Trajectories, canvas: Canvas, at, colours: Palette, width: int) -> None:
    for kind in ROADS:
        for ring in ways.outline.get(kind, ()):
            if canvas.sees(ring):
                draw.polygon(at(ring), fill=colours.roads[kind])
    if canvas.scale <= BORDERS_TO:
        for ring in ways.outline.get("lane", ()):
            if canvas.sees(ring):
                draw.line(at([*ring, ring[0]]), fill=_between(colours.border, colours.roads["lane"], 0.5), width=width)


def _box(draw, at, track: Track, frame: int, colour, ground, a_metre: float) -> None:
    """An actor, at least a pixel large, with its front in another shade."""
    box = corners(track, frame)
    draw.polygon(at(box), fill=colour)
    if track.kind not in ("prop", "walker") and a_metre * track.width > 6:
        draw.line(at([box[0], box[3]]), fill=ground, width=max(2, round(a_metre * 0.4)))


def _names(draw, at, ways: Trajectories, frame: int, labels: Mapping[str, str], colours: Palette, a_metre: float):
    """Labels beside their actors, none over another."""
    taken: list[tuple[float, float, float, float]] = []
    size = max(11, min(18, round(2.2 * a_metre)))
    font = ImageFont.load_default(size)
    for track in sorted(ways.tracks, key=lambda t: t.name != EGO):
        name = labels[track.name][:6]
        x, y = at([(track.x[frame], track.y[frame])])[0]
        for shift in (0, 1, -1, 2, -2, 3, -3):
            place = x + a_metre * (track.length / 2 + 1), y + shift * size
            left, top, right, bottom = draw.textbbox(place, name, font=font, anchor="lm")
            if all(right < a or left > c or bottom < b or top > d for a, b, c, d in taken):
                taken.append((left, top, right, bottom))
                draw.text((left, (top + bottom) / 2), name, font=font, anchor="lm", fill=colours.kinds[kind_of(name)])
                break


def _heading(start: Point, end: Point) -> float:
    """rad, 0 is north, anticlockwise."""
    import math

    return math.atan2(start[0] - end[0], end[1] - start[1])


def _between(one, other, share: float) -> tuple[int, int, int]:
    return tuple(round(a * share + b * (1 - share)) for a, b in zip(one, other, strict=True))  # type: ignore[return-value]


def _hex(colour) -> str:
    return f"#{colour[0]:02x}{colour[1]:02x}{colour[2]:02x}"
