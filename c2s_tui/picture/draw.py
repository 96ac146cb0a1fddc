"""One frame of a run from above as text: roads in shades, trails, boxes that carry their component's id."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from textual.content import Content

from c2s_engine.dryrun.picture import Point, bounds, corners, frames
from c2s_engine.structure.facts import EGO, RunFacts, Trajectories
from c2s_tui.look.kinds import ascii_only, colour, mark

ROADS = (
    ("sidewalk", "·", "."),
    ("shoulder", "·", "."),
    ("lane", "░", ":"),
    ("junction", "░", ":"),
    ("crosswalk", "▒", "#"),
)
ASPECT = 2.0
"""A cell is twice as high as it is wide."""
TRAIL_SECONDS = 6.0


@dataclass(frozen=True)
class View:
    """How one looks: metres a column with ego in the middle, or the whole run."""

    scale: float = 1.0
    follow: bool = True


@dataclass
class Canvas:
    """Cells with styles; the origin is the upper left."""

    columns: int
    rows: int
    left: float
    top: float
    scale: float
    cells: list[list[tuple[str, str]]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.cells = [[(" ", "")] * self.columns for _ in range(self.rows)]

    def put(self, x: float, y: float, text: str, style: str) -> None:
        """Write a text from a place on, where it is within the canvas."""
        column, row = int((x - self.left) // self.scale), int((self.top - y) // (ASPECT * self.scale))
        self.write(row, column, text, style)

    def write(self, row: int, column: int, text: str, style: str) -> None:
        for i, letter in enumerate(text):
            if 0 <= row < self.rows and 0 <= column + i < self.columns:
                self.cells[row][column + i] = (letter, style)

    def fill(self, ring: tuple[Point, ...] | list[Point], text: str, style: str) -> list[tuple[int, int]]:
        """Fill the cells whose middle lies in a polygon; those cells."""
        ys = [y for _, y in ring]
        step = ASPECT * self.scale
        first, last = int((self.top - max(ys)) // step), int((self.top - min(ys)) // step)
        filled = []
        for row in range(max(0, first), min(self.rows - 1, last) + 1):
            y = self.top - (row + 0.5) * step
            cuts = sorted(
                x1 + (y - y1) * (x2 - x1) / (y2 - y1)
                for (x1, y1), (x2, y2) in zip(ring, (*ring[1:], ring[0]), strict=True)
                if (y1 > y) != (y2 > y)
            )
            for start, end in zip(cuts[::2], cuts[1::2], strict=False):
                low = math.ceil((start - self.left) / self.scale - 0.5)
                high = math.floor((end - self.left) / self.scale - 0.5)
                for column in range(max(0, low), min(self.columns - 1, high) + 1):
                    self.cells[row][column] = (text, style)
                    filled.append((row, column))
        return filled

    def content(self) -> Content:
        lines = []
        for row in self.cells:
            runs: list[tuple[str, str]] = []
            for letter, style in row:
                if runs and runs[-1][1] == style:
                    runs[-1] = (runs[-1][0] + letter, style)
                else:
                    runs.append((letter, style))
            lines.append(Content.assemble(*runs))
        return Content("\n").join(lines)


def fitting(ways: Trajectories, columns: int, rows: int) -> float:
    """Metres a column at which every moving object of the first step is seen when ego is in the middle."""
    if not frames(ways):
        return 1.0
    ego = next((t for t in ways.tracks if t.name == EGO), ways.tracks[0])
    wanted = max(
        max(2 * (abs(t.x[0] - ego.x[0]) + 6) / max(columns, 1) for t in ways.tracks),
        max(2 * (abs(t.y[0] - ego.y[0]) + 6) / (ASPECT * max(rows, 1)) for t in ways.tracks),
    )
    return min(max(wanted, 0.5), 4.0)


def names(facts: RunFacts | None, ways: Trajectories) -> dict[str, str]:
    """The component of each track: ego is E, the others as the facts say, else by their own name."""
    known = {o.name: o.component for o in facts.objects if o.component} if facts else {}
    return {t.name: "E" if t.name == EGO else known.get(t.name) or t.name for t in ways.tracks}


def draw(
    ways: Trajectories, frame: int, columns: int, rows: int, labels: Mapping[str, str], view: View = View()
) -> Content:
    """The picture at a step."""
    count = frames(ways)
    if not count or columns < 4 or rows < 2:
        return Content("")
    frame = max(0, min(frame, count - 1))
    canvas = _canvas(ways, frame, columns, rows, view)
    _roads(canvas, ways)
    first = max(0, frame - int(TRAIL_SECONDS / ways.step))
    for track in ways.tracks:
        style = _style(labels[track.name])
        if track.kind != "prop":
            for i in range(first, frame + 1):
                canvas.put(track.x[i], track.y[i], "." if ascii_only() else "·", style)
    for track in sorted(ways.tracks, key=lambda t: t.name == EGO):
        label = labels[track.name]
        style = f"bold reverse {_style(label)}"
        canvas.fill(corners(track, frame), " ", style)
        column = int((track.x[frame] - canvas.left) // canvas.scale) - (len(label) - 1) // 2
        row = int((canvas.top - track.y[frame]) // (ASPECT * canvas.scale))
        canvas.write(row, column, label[:6], style)
    return canvas.content()


def caption(ways: Trajectories, frame: int, labels: Mapping[str, str], view: View, facts: RunFacts | None) -> Content:
    """Time, speeds, scale, and the events up to now."""
    time = frame * ways.step
    parts: list = [(f"{time:5.1f} s ", "bold")]
    for track in ways.tracks:
        if track.kind != "prop" and frame < len(track.speed):
            parts += [
                (f" {labels[track.name]}", f"bold {_style(labels[track.name])}"),
                f" {track.speed[frame] * 3.6:.0f} km/h",
            ]
    bar = 10 if view.scale < 2 else 50
    parts.append((f"   {bar} m {('-' if ascii_only() else '─') * max(1, round(bar / view.scale))}\n", "$muted"))
    found = [(e.time, labels.get(o.name, o.name), e) for o in (facts.objects if facts else ()) for e in o.events]
    for when, label, event in sorted(found, key=lambda f: f[0])[-4:]:
        if when <= time:
            other = f" {labels.get(event.other, event.other)}" if event.other else ""
            parts += [
                (label, f"bold {_style(label)}"),
                f" {event.event.replace('_', ' ')}{other} ",
                (f"{when:.1f} s  ", "$muted"),
            ]
    if not found:
        parts.append((f"{mark('dash')} no events", "$muted"))
    return Content.assemble(*parts)


def _canvas(ways: Trajectories, frame: int, columns: int, rows: int, view: View) -> Canvas:
    west, south, east, north = bounds(ways)
    if view.follow:
        ego = next((t for t in ways.tracks if t.name == EGO), ways.tracks[0])
        x, y, scale = ego.x[frame], ego.y[frame], view.scale
    else:
        x, y = (west + east) / 2, (south + north) / 2
        scale = max((east - west) / columns, (north - south) / (ASPECT * rows))
    return Canvas(columns, rows, x - scale * columns / 2, y + ASPECT * scale * rows / 2, scale)


def _roads(canvas: Canvas, ways: Trajectories) -> None:
    right, bottom = canvas.left + canvas.scale * canvas.columns, canvas.top - ASPECT * canvas.scale * canvas.rows
    for kind, shade, plain in ROADS:
        for ring in ways.outline.get(kind, ()):
            xs, ys = [x for x, _ in ring], [y for _, y in ring]
            if max(xs) >= canvas.left and min(xs) <= right and max(ys) >= bottom and min(ys) <= canvas.top:
                canvas.fill(ring, plain if ascii_only() else shade, "$faint")


def _style(label: str) -> str:
    return colour(label) if label[:1] in "GRETO" and (len(label) == 1 or label[1:].isdigit()) else colour("O")
