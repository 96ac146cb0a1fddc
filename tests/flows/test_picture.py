"""The picture of the run: shown, stepped, played."""

from scripted_engine import CUT_IN

from c2s_tui.picture.draw import Canvas, arrow_of
from c2s_tui.picture.timebar import line


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

        assert "E↑" in shown() and "O1↑" in shown() and "✸" not in shown()
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
