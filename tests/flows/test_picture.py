"""The picture of the run: shown, stepped, played."""

import math
import threading

import pytest
from scripted_engine import CUT_IN, trajectories

from c2s_engine.structure.facts import ContactFact
from c2s_tui.look.themes import themes
from c2s_tui.picture import pixels
from c2s_tui.picture.draw import Canvas, View, arrow_of, draw, turned
from c2s_tui.picture.graphics import chosen
from c2s_tui.picture.timebar import line
from c2s_tui.prefs import Prefs


async def _shown(stage, pilot):
    await stage.say(pilot, CUT_IN)
    await pilot.press("f9")
    await stage.until(pilot, lambda: stage.bench.picture.has_focus)


def test_the_picture_at_the_start(stage, compare):
    async def flow(pilot):
        await _shown(stage, pilot)
        assert stage.bench.picture.frame == 0
        assert "O1" in str(stage.bench.picture.query_one("#frame").content)

    assert compare(flow)


def test_the_picture_after_steps(stage, compare):
    async def flow(pilot):
        await _shown(stage, pilot)
        await pilot.press("up", "up", "up", "up", "up", "right")
        assert stage.bench.picture.frame == 51
        caption = str(stage.bench.picture.query_one("#caption").content)
        assert "O1 cuts in ahead of E 4.2 s" in caption and "E 50 km/h" in caption

    assert compare(flow)


def test_the_picture_in_a_small_terminal(stage, compare):
    async def flow(pilot):
        await _shown(stage, pilot)
        await pilot.press("end")
        assert stage.bench.picture.frame == 100

    assert compare(flow, size=(80, 24))


async def test_the_picture_plays_and_stops_at_the_end(stage):
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        await _shown(stage, pilot)
        picture = stage.bench.picture
        await pilot.press("end")
        picture.go(95)
        await pilot.press("space")
        await stage.until(pilot, lambda: picture.frame == 100 and not picture.playing)
        await pilot.press("w", "plus", "escape")
        await stage.until(pilot, lambda: not picture.has_class("-on"))


async def test_without_a_run_there_is_no_picture(stage):
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        await pilot.press("f9")
        await pilot.pause()
        assert not stage.bench.picture.has_class("-on")


async def test_headings_the_contact_and_the_actor_that_is_followed(stage):
    stage.engine.collides = True
    async with stage.described() as pilot:
        await pilot.press("f9")
        await stage.until(pilot, lambda: stage.bench.picture.has_focus)
        picture = stage.bench.picture

        def shown() -> str:
            return str(picture.query_one("#frame").content)

        assert "E→" in shown() and "O1→" in shown() and "✸" not in shown()  # ego sets out to the right
        await pilot.press("c")  # the moment of contact
        assert picture.frame == 63
        assert "✸" in shown()
        await pilot.press("left")
        assert "✸" not in shown()
        before = shown()
        await pilot.press("f")
        assert picture.view.whom == "van" and shown() != before
        await pilot.press("f")
        assert picture.view.whom == "ego" and shown() == before


async def test_time_is_scrubbed_with_the_mouse(stage):
    async with stage.described() as pilot:
        await pilot.press("f9")
        await stage.until(pilot, lambda: stage.bench.picture.has_focus)
        picture = stage.bench.picture
        bar = picture.query_one("#time")
        await pilot.mouse_down("#time", offset=(bar.size.width // 2, 0))
        await stage.until(pilot, lambda: abs(picture.frame - 50) <= 2)
        await pilot.hover("#time", offset=(bar.size.width - 1, 0))
        await stage.until(pilot, lambda: picture.frame == 100)
        await pilot.mouse_up("#time", offset=(bar.size.width - 1, 0))
        await stage.until(pilot, lambda: stage.app.mouse_captured is None)
        await pilot.hover("#time", offset=(0, 0))
        assert picture.frame == 100


async def test_a_picture_that_is_asked_for_too_early_opens_with_the_run(stage):
    stage.engine.gate, stage.engine.gated_at = threading.Event(), "write"
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        await stage.say(pilot, CUT_IN, wait=False)
        await stage.until(pilot, lambda: stage.busy)
        await pilot.press("f9")
        assert not stage.bench.picture.has_class("-on")
        stage.engine.gate.set()
        await stage.until(pilot, lambda: stage.bench.picture.has_class("-on"))
        assert not stage.busy and "E→" in str(stage.bench.picture.query_one("#frame").content)


@pytest.mark.parametrize(
    ("environ", "theme", "colours", "wanted", "way"),
    [({"TERM": "xterm-kitty"}, "c2s-dark", "truecolor", "auto", "kitty"),
     ({"TERM": "xterm-256color", "KITTY_WINDOW_ID": "1"}, "c2s-dark", "truecolor", "auto", "kitty"),
     ({"TERM": "tmux-256color", "KITTY_WINDOW_ID": "1", "TMUX": "x"}, "c2s-dark", "truecolor", "auto", "blocks"),
     ({"TERM": "foot"}, "c2s-light", "truecolor", "auto", "sixel"),
     ({"TERM": "xterm-256color", "TERM_PROGRAM": "WezTerm"}, "c2s-dark", "truecolor", "auto", "sixel"),
     ({"TERM": "xterm-256color"}, "c2s-dark", "256", "auto", "blocks"),
     ({"TERM": "xterm-kitty"}, "c2s-mono", None, "auto", "text"),
     ({"TERM": "xterm"}, "c2s-ansi", "standard", "auto", "text"),
     ({"TERM": "xterm-kitty"}, "c2s-dark", "truecolor", "text", "text"),
     ({"TERM": "tmux-256color", "TMUX": "x"}, "c2s-dark", "256", "kitty", "kitty")],
)  # fmt: skip
def test_what_the_terminal_can_show(environ, theme, colours, wanted, way):
    assert chosen(wanted, theme, False, colours, environ) == way
    assert chosen("auto", theme, True, colours, environ) == "text"  # ASCII only


def _palette():
    dark = themes()[0]
    named = {n: str(getattr(dark, n)) for n in ("background", "foreground", "error")}
    return pixels.palette({**dark.variables, **named})


def test_pixels_and_blocks_have_lanes_arrows_and_actors():
    ways, north = turned(trajectories())
    assert north == "right" and ways.tracks[0].y == tuple(0.0 for _ in ways.tracks[0].y)
    arrow = ((23.0, -0.6), (20.0, 0.0), (20.0, -1.2))
    ways = ways.model_copy(update={"outline": {**ways.outline, "arrow": (arrow,)}})
    labels, view, colours = {"ego": "E", "van": "O1"}, View(1.0), _palette()
    hit = (ContactFact(time=1.0, one="ego", other="van", part_one="front", part_other="rear", closing=1.0),)
    small = pixels.paint(ways, 20, 60, 20, labels, view, colours, hit)
    words = pixels.blocks(small, ways, 20, labels, view, colours, hit)
    assert small.size == (60, 40) and len(words.plain.split("\n")) == 20
    assert "E→" in words.plain and "O1→" in words.plain and words.plain.count("→") == 3 and "✸" in words.plain
    assert {len(row) for row in words.plain.split("\n")} == {60}
    large = pixels.paint(ways, 20, 60, 20, labels, view, colours, hit, (10, 20), written=True)
    found = set(large.get_flattened_data())
    assert large.size == (600, 400) and {colours.roads["lane"], colours.border, colours.hit} <= found
    assert {colours.kinds["E"], colours.kinds["O"]} <= found
    plain = draw(ways, 20, 60, 20, labels, view).plain
    assert "E→" in plain and "░" in plain


@pytest.mark.parametrize("quarter", range(4))
def test_ego_sets_out_to_the_right_whatever_its_heading(quarter):
    ways = trajectories()
    ego = ways.tracks[0].model_copy(update={"heading": tuple(quarter * math.pi / 2 for _ in ways.tracks[0].x)})
    tracks, north = turned(ways.model_copy(update={"tracks": (ego, *ways.tracks[1:])}))
    assert arrow_of(tracks.tracks[0].heading[0]) == "→"
    assert north == ("right", "down", "left", "up")[quarter]  # ego heads north, west, south, east


async def test_kitty_is_sent_an_image_for_each_step(stage, monkeypatch):
    from textual_image.renderable import tgp

    sent = []
    monkeypatch.setattr(tgp, "_send_tgp_message", lambda **message: sent.append(message))
    async with stage.make(prefs=Prefs(welcomed=True, graphics="kitty")).run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        await _shown(stage, pilot)
        await stage.until(pilot, lambda: any(m.get("U") == 1 for m in sent))
        assert not stage.bench.picture.query_one("#frame").display
        before = len([m for m in sent if m.get("U") == 1])
        await pilot.press("right")
        await stage.until(pilot, lambda: len([m for m in sent if m.get("U") == 1]) > before)


def test_labels_do_not_cover_each_other():
    canvas = Canvas(20, 6, 0.0, 12.0, 1.0)
    for name in ("O1", "O2", "O3"):
        canvas.label(10.0, 6.0, name, "")
    rows = [line for line in canvas.content().plain.split("\n") if line.strip()]
    assert sorted(line.strip() for line in rows) == ["O1", "O2", "O3"]


def test_arrows_point_where_one_heads():
    quarter = 1.5707963
    assert [arrow_of(quarter * k) for k in (0, 1, 2, 3, -1)] == ["↑", "←", "↓", "→", "→"]
    bar = line(0.5, [0.25], [0.75], 21).plain
    assert (bar[5], bar[10], bar[15]) == ("•", "█", "✸") and line(0.0, [], [], 1).plain == ""
