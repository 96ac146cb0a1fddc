"""Pictures of a run as PNG: the decisive moments from above, speeds and distances over time. Same run, same bytes."""

import io
import textwrap
from typing import Any

import numpy as np

from c2s_engine.dryrun.picture import FILLS, GROUND, colour_of, corners
from c2s_engine.report.moments import Moment
from c2s_engine.require.measures import pairs
from c2s_engine.structure.facts import EGO, Trajectories

PANEL = (7.2, 4.6)
"""Inches of one moment's picture, at DPI."""
DPI = 100
ROOM, LEAST, SIGHT = 12.0, 45.0, 80.0
"""m: around who is shown; the least that a picture spans; how far from ego others are shown."""


def moments_png(ways: Trajectories, found: list[Moment]) -> bytes:
    """One picture a moment, two in a row."""
    columns = min(2, len(found))
    rows = -(-len(found) // columns)
    figure, canvas = _figure((PANEL[0] * columns, PANEL[1] * rows))
    for number, moment in enumerate(found, 1):
        axes = figure.add_subplot(rows, columns, number)
        _draw(axes, ways, moment)
    top = 1 - 0.4 / (PANEL[1] * rows)
    figure.subplots_adjust(left=0.01, right=0.99, top=top, bottom=0.01, wspace=0.02, hspace=0.12)
    return _bytes(canvas)


def plots_png(ways: Trajectories, found: list[Moment]) -> bytes:
    """Speeds (km/h), and the gap of each other to ego (m), over time; the moments as thin lines."""
    figure, canvas = _figure((PANEL[0] * 2, PANEL[1]))
    speeds, gaps = figure.add_subplot(1, 2, 1), figure.add_subplot(1, 2, 2)
    for i, track in enumerate(ways.tracks):
        if track.kind != "prop":
            times = np.arange(len(track.speed)) * ways.step
            speeds.plot(times, np.asarray(track.speed) * 3.6, color=colour_of(ways.tracks, i), label=track.name)
    for pair in pairs(ways):
        i = next(n for n, t in enumerate(ways.tracks) if t is pair.other)
        times = np.arange(len(pair.gap)) * ways.step
        gaps.plot(times, pair.gap, color=colour_of(ways.tracks, i), label=f"ego to {pair.other.name}")
    for axes, title in ((speeds, "speed (km/h)"), (gaps, "gap between boxes (m)")):
        axes.set_title(title, fontsize=10)
        axes.set_xlabel("s", fontsize=9)
        axes.set_ylim(bottom=0)
        axes.grid(alpha=0.3)
        for moment in found:
            axes.axvline(moment.time, color="#555555", linewidth=0.6, linestyle=":")
        if axes.lines and axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=8)
    figure.subplots_adjust(left=0.05, right=0.99, top=0.92, bottom=0.11, wspace=0.12)
    return _bytes(canvas)


def _figure(size: tuple[float, float]) -> tuple[Any, Any]:
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, dpi=DPI, facecolor="white")
    return figure, FigureCanvasAgg(figure)


def _bytes(canvas: Any) -> bytes:
    data = io.BytesIO()
    canvas.print_png(data, metadata={"Software": None})
    return data.getvalue()


def _draw(axes: Any, ways: Trajectories, moment: Moment) -> None:
    from matplotlib.patches import Polygon

    frame = min(round(moment.time / ways.step), len(ways.tracks[0].x) - 1)
    view = _view(ways, frame, far=moment.what.startswith("start"))
    axes.set_facecolor(GROUND)
    for kind, rings in ways.outline.items():
        edge = "#ffffff" if kind == "lane" else "none"
        for ring in rings:
            axes.add_patch(Polygon(ring, facecolor=FILLS.get(kind, "#999999"), edgecolor=edge, linewidth=1))
    for i, track in enumerate(ways.tracks):
        colour = colour_of(ways.tracks, i)
        box = Polygon(corners(track, frame), facecolor=colour, edgecolor="#111111", linewidth=0.7, zorder=4)
        axes.add_patch(box)
        if track.kind != "prop":
            axes.plot(track.x[: frame + 1], track.y[: frame + 1], color=colour, linewidth=1.6, alpha=0.7, zorder=3)
            axes.plot(track.x[frame:], track.y[frame:], color=colour, linewidth=0.9, alpha=0.7, linestyle=":", zorder=3)
            _arrow(axes, track, frame, colour)
    _labels(axes, ways, frame, view)
    axes.set_xlim(view[0], view[2])
    axes.set_ylim(view[1], view[3])
    axes.set_aspect("equal", adjustable="box")
    axes.set_xticks([])
    axes.set_yticks([])
    axes.set_title(textwrap.fill(f"{moment.time:.1f} s  {moment.what}", 88), fontsize=10, loc="left")
    _rule(axes, view)


def _arrow(axes: Any, track: Any, frame: int, colour: str) -> None:
    """Where it heads: a line from its nose."""
    box = corners(track, frame)
    nose = ((box[0][0] + box[3][0]) / 2, (box[0][1] + box[3][1]) / 2)
    ahead = np.array([-np.sin(track.heading[frame]), np.cos(track.heading[frame])])
    tip = np.asarray(nose) + ahead * 3.5
    axes.annotate("", xy=tip, xytext=nose, arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 1.4}, zorder=5)


def _labels(axes: Any, ways: Trajectories, frame: int, view: tuple[float, ...]) -> None:
    """Names and speeds, one below the other where objects are near each other, with a thin line to whom they name."""
    width, height = view[2] - view[0], view[3] - view[1]
    inside = [
        (track.y[frame], i, track) for i, track in enumerate(ways.tracks)
        if view[0] <= track.x[frame] <= view[2] and view[1] <= track.y[frame] <= view[3]
    ]  # fmt: skip
    taken: list[tuple[float, float]] = []
    for y, i, track in sorted(inside, key=lambda entry: (-entry[0], entry[1])):
        x = min(track.x[frame] + 0.03 * width, view[2] - 0.2 * width)
        at = y + 0.05 * height
        while any(abs(at - v) < 0.055 * height and abs(x - u) < 0.2 * width for u, v in taken):
            at -= 0.01 * height
        taken.append((x, at))
        text = track.name if track.kind == "prop" else f"{track.name} {track.speed[frame] * 3.6:.0f} km/h"
        colour = colour_of(ways.tracks, i)
        box = {"boxstyle": "round,pad=0.15", "facecolor": "white", "edgecolor": colour, "alpha": 0.85, "linewidth": 0.8}
        axes.plot([track.x[frame], x], [y, at], color=colour, linewidth=0.6, zorder=5)
        axes.text(x, at, text, fontsize=8, bbox=box, zorder=6, verticalalignment="center")


def _view(ways: Trajectories, frame: int, far: bool) -> tuple[float, float, float, float]:
    """(west, south, east, north): ego and those within sight of it (`far`: twice as far), in a panel's shape; m."""
    ego = next((t for t in ways.tracks if t.name == EGO), ways.tracks[0])
    centre = np.array([ego.x[frame], ego.y[frame]])
    spots = [np.array([t.x[frame], t.y[frame]]) for t in ways.tracks]
    sight = 2 * SIGHT if far else SIGHT
    near = [s for s in spots if np.hypot(*(s - centre)) < sight] or [centre]
    low, high = np.min(near, axis=0) - ROOM, np.max(near, axis=0) + ROOM
    middle, span = (low + high) / 2, high - low
    width = max(span[0], span[1] * PANEL[0] / PANEL[1], LEAST)
    height = width * PANEL[1] / PANEL[0]
    return middle[0] - width / 2, middle[1] - height / 2, middle[0] + width / 2, middle[1] + height / 2


def _rule(axes: Any, view: tuple[float, ...]) -> None:
    """A bar of 10 m."""
    x, y = view[0] + 0.03 * (view[2] - view[0]), view[1] + 0.05 * (view[3] - view[1])
    axes.plot([x, x + 10], [y, y], color="#111111", linewidth=2.5, zorder=6)
    axes.text(x, y + 0.012 * (view[3] - view[1]), "10 m", fontsize=8, zorder=6)
