"""The picture of the run: shown, stepped, played."""

from scripted_engine import CUT_IN


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
        assert "O1 cut in E 4.2 s" in caption and "E 50 km/h" in caption

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
