"""What hands are used to: borders moved with the mouse, the mouse left to the terminal, Vim's keys."""

import pytest

from c2s_tui.prefs import Prefs, load


async def test_a_border_is_moved_with_the_mouse_and_stays_there(stage):
    async with stage.described() as pilot:
        bench = stage.bench
        chat, sheet = (bench.query_one(name).region for name in ("#chat", "#sheet"))
        await pilot.mouse_down(offset=(chat.right, 10))
        await pilot.hover(offset=(chat.right + 12, 10))
        await pilot.mouse_up(offset=(chat.right + 12, 10))
        await stage.until(pilot, lambda: bench.query_one("#chat").region.width == chat.width + 12)
        assert bench.query_one("#sheet").region.width == sheet.width - 12
        await stage.until(pilot, lambda: stage.app.mouse_captured is None)
        assert load().widths == stage.app.prefs.widths == bench.app.prefs.widths != ""
        before = bench.query_one("#chat").region.width
        await pilot.hover(offset=(20, 10))
        await pilot.pause()
        assert bench.query_one("#chat").region.width == before  # let go


async def test_the_mouse_is_left_to_the_terminal_and_taken_back(stage, monkeypatch):
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        called = []
        for name in ("_disable_mouse_support", "_enable_mouse_support"):
            monkeypatch.setattr(stage.app._driver, name, lambda n=name: called.append(n), raising=False)
        await stage.bench.run_command("mouse")
        await stage.bench.run_command("mouse")
        assert called == ["_disable_mouse_support", "_enable_mouse_support"]


async def test_components_are_folded_and_any_edit_unfolds(stage):
    async with stage.described() as pilot:
        area, pane = stage.bench.code.area, stage.bench.code
        await pilot.press("f4")
        await stage.until(pilot, lambda: area.has_focus)
        text, spans = area.text, pane.side.spans
        ego, van = (next(s for s in spans if s.component == cid) for cid in ("E", "O1"))
        area.move_cursor((ego.first + 1, 0))
        await pilot.press("alt+o")
        assert area.cursor_location == (ego.first - 1, 0) and area.hidden == frozenset(range(ego.first, ego.last))
        assert area.virtual_size.height == area.document.line_count - (ego.last - ego.first)
        assert pane.side.line_at(ego.first - 1 - pane.side.top + 1) == ego.last + 1 and pane.side.folded(ego.first)
        await pilot.press("down")
        assert area.cursor_location[0] == ego.last  # over what is folded
        await pilot.press("up", "alt+o")
        assert not area.hidden and pane.side.rows is None
        await stage.bench.run_command("fold", "all")
        assert {s.component for s in spans if s.first in area.hidden} == {s.component for s in spans} - {"E"}
        pane.go_to_line(van.first + 2)
        await stage.until(pilot, lambda: not area.hidden)  # what is gone to is shown
        await stage.bench.run_command("fold", "O1")
        assert area.hidden == frozenset(range(van.first, van.last)) and area.text == text
        area.move_cursor((0, 0))
        await pilot.press("x")
        assert not area.hidden and area.text == f"x{text}"
        await stage.bench.run_command("fold", "O7")
        assert stage.said[-1].startswith("There is no component O7")


TEXT = "one two\n    three\nfour\n"
CASES = [  # keys in normal mode at the start of TEXT, the text then, the cursor then
    ("jj", TEXT, (2, 0)), ("G", TEXT, (3, 0)), ("2G", TEXT, (1, 0)), ("Ggg", TEXT, (0, 0)), ("2j", TEXT, (2, 0)),
    ("j^", TEXT, (1, 4)), ("$", TEXT, (0, 7)), ("x", TEXT[1:], (0, 0)), ("3x", TEXT[3:], (0, 0)),
    ("dd", "    three\nfour\n", (0, 0)), ("2dd", "four\n", (0, 0)), ("ddu", TEXT, (0, 0)),
    ("yyjp", "one two\n    three\none two\nfour\n", (2, 0)), ("jddP", TEXT, (1, 4)),
    ("dx", TEXT, (0, 0)), ("zq", TEXT, (0, 0)), ("D", "\n    three\nfour\n", (0, 0)),
    ("ihi", "hi" + TEXT, (0, 2)), ("jIa", "one two\n    athree\nfour\n", (1, 5)),
    ("A!", "one two!\n    three\nfour\n", (0, 8)), ("jox", "one two\n    three\n    x\nfour\n", (2, 5)),
    ("jOx", "one two\n    x\n    three\nfour\n", (1, 5)), ("jccx", "one two\n    x\nfour\n", (1, 5)),
]  # fmt: skip


async def test_vim_keys(stage):
    async with stage.make(prefs=Prefs(welcomed=True, vim=True)).run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        area, pane = stage.bench.code.area, stage.bench.code
        await pilot.press("f4")
        await stage.until(pilot, lambda: area.has_focus and area.vim)
        for keys, text, at in CASES:
            area.load_text(TEXT)
            area.move_cursor((0, 0))
            assert pane.border_title == "code: normal mode"
            await pilot.press(*keys)
            assert (keys, area.text, area.cursor_location) == (keys, text, at)
            await pilot.press("escape")
            assert area.text == text
        await stage.bench.run_command("vim")
        assert area.vim is None and pane.border_title == "code" and not stage.app.prefs.vim


@pytest.mark.parametrize("size", [(140, 45), (140, 20), (80, 24), (60, 20)])
async def test_the_code_begins_at_ego_after_a_restart(stage, size):
    async with stage.described(size):
        pass
    await stage.backends.pop().close()
    async with stage.make().run_test(size=size) as pilot:
        await stage.ready(pilot)
        await stage.until(pilot, lambda: stage.bench.desk.program.text)
        await pilot.press("f4")
        code = stage.bench.code
        first = next(s.first for s in stage.bench.desk.program.spans if s.component == "E")
        await stage.until(pilot, lambda: code.area.has_focus and code.area.size.height)
        await stage.until(pilot, lambda: code.area.cursor_location[0] == first - 1)
        top = round(code.area.scroll_y)
        assert top == min(first - 3, code.area.max_scroll_y) and top < first <= top + code.area.size.height


async def test_what_is_typed_is_there_again_after_a_text_that_was_sent_before(stage):
    async with stage.described() as pilot:
        chat = stage.bench.chat.entry
        stage.bench.room.go_to("chat")
        sent = chat.sent[-1]
        await pilot.press(*"draft")
        await pilot.press("up")
        assert chat.text == sent and "draft" in chat.draft  # what is kept of it
        await pilot.press("down")
        assert chat.text == "draft"
        await pilot.press("up", "end", "x", "down", "up")
        assert chat.text == f"{sent}x"  # also what was changed of another


async def test_the_results_give_way_to_the_pane_that_one_came_from(stage):
    async with stage.described() as pilot:
        stage.bench.room.go_to("chat")
        await pilot.press("f6")
        await stage.until(pilot, lambda: stage.bench.results.has_focus)
        await pilot.press("escape")
        await stage.until(pilot, lambda: stage.bench.chat.entry.has_focus)
