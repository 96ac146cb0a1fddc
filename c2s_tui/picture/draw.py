"""One frame of a run from above as text: roads in shades, trails, boxes that carry their component's id."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from textual.content import Content

from c2s_engine.dryrun.picture import Point, bounds, corners, frames
from c2s_engine.structure.event_words import USUAL, event_phrase
from c2s_engine.structure.facts import EGO, ContactFact, EventFact, RunFacts, Trajectories
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
BAR = 14
"""Columns of the bar that shows the scale, at most."""
LINES_TO = 1.3
"""m a column up to which the borders of lanes are drawn: farther off, a lane is two columns wide."""


@dataclass(frozen=True)
class View:
    """How one looks: metres a column with an actor in the middle (by its track's name), or the whole run."""

    scale: float = 1.0
    follow: bool = True
    whom: str = EGO


@dataclass
class Canvas:
    """Cells with styles; the origin is the upper left."""

    columns: int
    rows: int
    left: float
    top: float
    scale: float
    cells: list[list[tuple[str, str]]] = field(default_factory=list)
    labelled: set[tuple[int, int]] = field(default_factory=set)  # cells that a label has taken

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

    def label(self, x: float, y: float, text: str, style: str) -> None:
        """Write a label around a place, in the nearest row where it covers no other label."""
        column = int((x - self.left) // self.scale) - (len(text) - 1) // 2
        row = int((self.top - y) // (ASPECT * self.scale))
        if not (0 <= row < self.rows and -len(text) < column < self.columns):
            return
        for shift in (0, 1, -1, 2, -2, 3, -3):
            cells = {(row + shift, column + i) for i in range(len(text))}
            if 0 <= row + shift < self.rows and not cells & self.labelled:
                self.labelled |= cells
                self.write(row + shift, column, text, style)
                return

    def labels(self, ways: Trajectories, frame: int, names: Mapping[str, str]) -> None:
        """Write each actor's label and heading, ego's first."""
        for track in sorted(ways.tracks, key=lambda t: t.name != EGO):
            arrow = "" if track.kind == "prop" else arrow_of(track.heading[frame])
            label = names[track.name]
            self.label(track.x[frame], track.y[frame], f"{label[:6]}{arrow}", f"bold reverse {_style(label)}")

    def sees(self, ring: Sequence[Point]) -> bool:
        """Whether the box around a polygon touches the canvas."""
        right, bottom = self.left + self.scale * self.columns, self.top - ASPECT * self.scale * self.rows
        xs, ys = [x for x, _ in ring], [y for _, y in ring]
        return max(xs) >= self.left and min(xs) <= right and max(ys) >= bottom and min(ys) <= self.top

    def edge(self, ring: tuple[Point, ...], text: str, style: str) -> None:
        """Draw the border of a polygon."""
        for (x1, y1), (x2, y2) in zip(ring, (*ring[1:], ring[0]), strict=True):
            steps = max(1, round(max(abs(x2 - x1) / self.scale, abs(y2 - y1) / (ASPECT * self.scale))))
            if steps > 4 * (self.columns + self.rows):
                continue  # far longer than what is seen: its middle part would take too long
            for i in range(steps + 1):
                self.put(x1 + (x2 - x1) * i / steps, y1 + (y2 - y1) * i / steps, text, style)

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


def turned(ways: Trajectories) -> tuple[Trajectories, str]:
    """The run in quarter turns so that ego sets out to the right, where a terminal has most room; and where north then
    is: up, left, down or right."""
    ego = next((t for t in ways.tracks if t.name == EGO), None)
    quarters = 0 if ego is None or not ego.heading else round(-(ego.heading[0] + math.pi / 2) / (math.pi / 2)) % 4
    north = ("up", "left", "down", "right")[quarters]
    if not quarters:
        return ways, north
    cos, sin = ((1, 0), (0, 1), (-1, 0), (0, -1))[quarters]

    def ring(points: tuple[Point, ...]) -> tuple[Point, ...]:
        return tuple((cos * x - sin * y, sin * x + cos * y) for x, y in points)

    tracks = [
        t.model_copy(update={
            "x": tuple(cos * x - sin * y for x, y in zip(t.x, t.y, strict=True)),
            "y": tuple(sin * x + cos * y for x, y in zip(t.x, t.y, strict=True)),
            "heading": tuple(h + quarters * math.pi / 2 for h in t.heading),
        })
        for t in ways.tracks
    ]  # fmt: skip
    outline = {kind: tuple(ring(r) for r in rings) for kind, rings in ways.outline.items()}
    return ways.model_copy(update={"tracks": tuple(tracks), "outline": outline}), north


def names(facts: RunFacts | None, ways: Trajectories) -> dict[str, str]:
    """The component of each track: ego is E, the others as the facts say, else by their own name."""
    known = {o.name: o.component for o in facts.objects if o.component} if facts else {}
    return {t.name: "E" if t.name == EGO else known.get(t.name) or t.name for t in ways.tracks}


def draw(
    ways: Trajectories, frame: int, columns: int, rows: int, labels: Mapping[str, str], view: View = View(),
    contacts: Sequence[ContactFact] = (),
) -> Content:  # fmt: skip
    """The picture at a step; contacts that have been are marked where they were."""
    count = frames(ways)
    if not count or columns < 4 or rows < 2:
        return Content("")
    frame = max(0, min(frame, count - 1))
    canvas = canvas_of(ways, frame, columns, rows, view)
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
    canvas.labels(ways, frame, labels)
    for hit in contacts:
        if (place := where_of(ways, hit, frame)) is not None:
            canvas.put(*place, "X" if ascii_only() else "✸", "bold $text-error")
    return canvas.content()


def arrow_of(heading: float) -> str:
    """The arrow that points where somebody heads (rad, 0 is north, anticlockwise)."""
    arrows = "^\\</v\\>/" if ascii_only() else "↑↖←↙↓↘→↗"
    return arrows[round(heading / (math.pi / 4)) % 8]


def where_of(ways: Trajectories, hit: ContactFact, frame: int) -> Point | None:
    """Where a contact was (m); None before it was, or if one of the two has no track."""
    tracks = {t.name: t for t in ways.tracks}
    at = round(hit.time / ways.step)
    if at > frame or hit.one not in tracks or hit.other not in tracks:
        return None
    one, other = tracks[hit.one], tracks[hit.other]
    at = min(at, len(one.x) - 1, len(other.x) - 1)
    return (one.x[at] + other.x[at]) / 2, (one.y[at] + other.y[at]) / 2


def caption(
    ways: Trajectories, frame: int, labels: Mapping[str, str], view: View, facts: RunFacts | None, north: str = "up",
) -> Content:  # fmt: skip
    """Time, speeds, scale, where north is, and the events up to now."""
    time = frame * ways.step
    parts: list = [(f"{time:5.1f} s ", "bold")]
    for track in ways.tracks:
        if track.kind != "prop" and frame < len(track.speed):
            parts += [
                (f" {labels[track.name]}", f"bold {_style(labels[track.name])}"),
                f" {track.speed[frame] * 3.6:.0f} km/h",
            ]
    bar = max((m for m in (5, 10, 20, 50, 100) if m / view.scale <= BAR), default=5)
    parts.append((f"   {bar} m {('-' if ascii_only() else '─') * max(1, round(bar / view.scale))}", "$muted"))
    arrow = arrow_of({"up": 0.0, "left": 0.5, "down": 1.0, "right": 1.5}[north] * math.pi)
    parts.append((f"   north {arrow}\n", "$muted"))
    found = [(e.time, labels.get(o.name, o.name), e) for o in (facts.objects if facts else ()) for e in o.events]
    found = [f for f in found if f[2].event not in USUAL] or found
    for when, label, event in _latest(found, time):
        other = labels.get(event.other, event.other) if event.other else None
        words = event_phrase(EventFact(event=event.event, time=when, other=other))
        parts += [(label, f"bold {_style(label)}"), f" {words} ", (f"{when:.1f} s  ", "$muted")]
    if not found:
        parts.append((f"{mark('dash')} no events", "$muted"))
    return Content.assemble(*parts)


def _latest(found: list[tuple[float, str, EventFact]], time: float) -> list[tuple[float, str, EventFact]]:
    """The last events up to a time."""
    return sorted((f for f in found if f[0] <= time + 1e-6), key=lambda f: f[0])[-4:]


def canvas_of(ways: Trajectories, frame: int, columns: int, rows: int, view: View) -> Canvas:
    west, south, east, north = bounds(ways)
    if view.follow:
        whom = next((t for t in ways.tracks if t.name == view.whom), ways.tracks[0])
        x, y, scale = whom.x[frame], whom.y[frame], view.scale
    else:
        x, y = (west + east) / 2, (south + north) / 2
        scale = max((east - west) / columns, (north - south) / (ASPECT * rows))
    return Canvas(columns, rows, x - scale * columns / 2, y + ASPECT * scale * rows / 2, scale)


def _roads(canvas: Canvas, ways: Trajectories) -> None:
    for kind, shade, plain in ROADS:
        for ring in ways.outline.get(kind, ()):
            if canvas.sees(ring):
                canvas.fill(ring, plain if ascii_only() else shade, "$faint")
    for ring in ways.outline.get("lane", ()) if canvas.scale <= LINES_TO else ():
        if canvas.sees(ring):
            canvas.edge(ring, "." if ascii_only() else "·", "$muted")


def kind_of(label: str) -> str:
    """The letter of the component that a label names; what no component has is an object."""
    return label[0] if label[:1] in "GRETO" and (len(label) == 1 or label[1:].isdigit()) else "O"


def _style(label: str) -> str:
    return colour(kind_of(label))
