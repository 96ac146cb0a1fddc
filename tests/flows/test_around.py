"""Around the panes: the row of keys, zoom, room, find, findings, turns and sessions as lists."""

import asyncio
import threading
from random import Random

import pytest
from scripted_engine import CUT_IN
from textual.events import Key
from textual.widgets import OptionList, Tabs

from c2s_tui.code.finder import found
from c2s_tui.columns import Columns
from c2s_tui.keys import row, written
from c2s_tui.room import TABS


def keys(stage) -> str:
    return stage.bench.query_one("#keys").content.plain


async def test_the_row_of_keys_follows_the_focus_and_the_question_mark_helps(stage):
    async with stage.described() as pilot:
        assert "F1 help" in keys(stage) and "F6 results" in keys(stage)
        await pilot.press("f3")
        await stage.until(pilot, lambda: "Enter edit" in keys(stage) and "a add" in keys(stage))
        await pilot.press("f9")
        await stage.until(pilot, lambda: "Space play" in keys(stage))
        await pilot.press("f3")
        await stage.until(pilot, lambda: stage.bench.sheet.has_focus)
        await pilot.press("question_mark")
        await stage.until(pilot, lambda: len(stage.app.screen_stack) == 3)
        assert stage.app.screen.heading == "Help: the structure S"


async def test_the_row_of_keys_keeps_to_its_width_and_to_remapped_keys(stage):
    async with stage.described():
        focused, keymap = stage.bench.focused, {"app.help": "f12"}
        for width in (20, 60, 140):
            words = row(focused, keymap, width)
            assert words.cell_length <= width and words.plain.startswith("F12 help")
    assert written("ctrl+t,left_square_bracket,K,pageup") == "Ctrl+T, [, K, Pageup"


async def test_pane_keys_in_one_go_end_in_the_pane_asked_for_last(stage, monkeypatch):
    """However many come before the app has done any: each moves once, and pane, tab and focus agree in the end."""
    orders, draw = [["f3", "f4"], ["f4", "f3", "f4"], ["f6", "f3"], ["f9", "f2"]], Random(7)
    orders += [draw.choices(["f2", "f3", "f4", "f6", "f9"], k=draw.randint(2, 6)) for _ in range(12)]
    last = {"f2": "chat", "f3": "sheet", "f4": "code"}
    async with stage.described(size=(80, 24)) as pilot:
        room, moved = stage.bench.room, []
        go_to = room.go_to
        monkeypatch.setattr(room, "go_to", lambda name: (moved.append(name), go_to(name)))
        for keys_pressed in orders:
            moved.clear()
            for key in keys_pressed:
                stage.app.post_message(Key(key, None))
            await stage.until(pilot, lambda count=len(keys_pressed): len(moved) >= count)
            for _ in range(5):
                await pilot.pause()
            assert len(moved) == len(keys_pressed), (keys_pressed, moved)
            current = last.get(keys_pressed[-1], moved[-1])
            assert room.current_pane == room.pane_of_focus() == current, (keys_pressed, moved)
            assert stage.bench.query_one(Tabs).active == f"tab-{current}"


async def test_a_tab_that_is_clicked_brings_its_pane(stage):
    async with stage.described(size=(80, 24)) as pilot:
        for name in [*TABS, "chat"]:
            await pilot.click(f"#tab-{name}")
            await stage.until(pilot, lambda name=name: stage.bench.room.current_pane == name)
            await stage.until(pilot, lambda name=name: stage.bench.room.pane_of_focus() == name)


async def test_zoom_shows_the_focused_pane_alone(stage):
    async with stage.described() as pilot:
        await pilot.press("f3", "f7")
        await stage.until(pilot, lambda: stage.bench.sheet.size.width > 130)
        assert not stage.bench.chat.display and not stage.bench.query_one("#right").display
        await pilot.press("f4")  # another pane takes its place
        await stage.until(pilot, lambda: stage.bench.code.size.width > 130 and stage.bench.code.area.has_focus)
        await pilot.press("f7")
        await stage.until(pilot, lambda: stage.bench.chat.display and stage.bench.sheet.display)


async def test_room_is_given_by_key_and_kept(stage):
    async with stage.described() as pilot:
        before = stage.bench.chat.size.width
        stage.bench.chat.entry.put("")
        await pilot.press("alt+right", "alt+right")  # in the line to type in, where no letter must come of it
        await stage.until(pilot, lambda: stage.bench.chat.size.width > before)
        assert stage.app.prefs.widths == "48 46 58" and stage.bench.chat.entry.text == ""
        await pilot.press(*["alt+left"] * 8)
        await stage.until(pilot, lambda: stage.bench.chat.size.width < before)
        assert stage.app.prefs.widths == "12 46 58"
        stage.app.prefs.widths = "no numbers"
        assert list(stage.bench.query_one(Columns).shares.values()) == [36, 46, 58]


async def test_find_goes_from_place_to_place_and_to_lines(stage):
    async with stage.described() as pilot:
        await pilot.press("f4", "ctrl+f")
        await stage.until(pilot, lambda: stage.bench.code.finder.line.has_focus)
        area = stage.bench.code.area
        places = found(area.text, "van")
        await pilot.press(*"van")
        await stage.until(pilot, lambda: area.selected_text.lower() == "van")
        assert area.selection.start in places
        first = area.selection.start
        await pilot.press("enter")
        await stage.until(pilot, lambda: area.selection.start == places[(places.index(first) + 1) % len(places)])
        await pilot.press("up")
        await stage.until(pilot, lambda: area.selection.start == first)
        stage.bench.code.finder.line.value = "12"
        await stage.until(pilot, lambda: area.cursor_location == (11, 0))
        await pilot.press("enter")
        await stage.until(pilot, lambda: area.has_focus and not stage.bench.code.finder.has_class("-on"))
        await stage.say(pilot, "/find nowhere to be found", wait=False)
        await stage.until(pilot, lambda: "not found" in str(stage.bench.code.finder.query_one("Static").content))


async def test_what_is_typed_after_the_key_of_find_is_what_is_found(stage):
    async with stage.described() as pilot:
        code = stage.bench.code
        await pilot.press("f4")
        await stage.until(pilot, lambda: code.area.has_focus)
        before = code.area.text
        for key in ("ctrl+f", "v", "a", "n"):  # all of it before the app has done any
            stage.app.post_message(Key(key, key if len(key) == 1 else None))
        await stage.until(pilot, lambda: code.area.selected_text.lower() == "van")
        assert code.finder.line.value == "van" and code.area.text == before


@pytest.mark.parametrize(
    ("wanted", "places"), [("ego", [(0, 0), (1, 4)]), ("Ego", [(0, 0)]), ("", []), ("(x", [(1, 8)])]
)
def test_what_is_found(wanted, places):
    assert found("Ego\nthe ego (x)", wanted) == places


async def test_findings_are_a_list(stage):
    async with stage.described() as pilot:
        await stage.misspell(pilot)
        stage.bench.room.go_to("chat")
        await pilot.press("alt+p")
        await stage.until(pilot, lambda: len(stage.app.screen_stack) == 3)
        assert "VanBehaviour" in str(stage.app.screen.query_one(OptionList).get_option_at_index(0).prompt)
        await pilot.press("enter")
        await stage.until(pilot, lambda: stage.bench.code.area.has_focus and stage.bench.code.finding is not None)


async def test_turns_are_a_list_to_go_back_and_forward_in(stage):
    async with stage.described() as pilot:
        first = stage.bench.desk.program.text
        await stage.editing(pilot, "E:speed")
        await stage.type_over(pilot, "60")
        second = stage.bench.desk.program.text
        assert second != first and [t.index for t in stage.bench.session.history] == [0, 1]
        stage.bench.room.go_to("chat")
        await pilot.press("alt+u")
        await stage.until(pilot, lambda: len(stage.app.screen_stack) == 3)
        await pilot.press("down", "enter")
        await stage.until(pilot, lambda: stage.bench.desk.program.text == first and not stage.busy)
        assert [t.index for t in stage.bench.session.undone] == [1]
        await pilot.press("alt+u")
        await stage.until(pilot, lambda: len(stage.app.screen_stack) == 3)
        assert "undone" in str(stage.app.screen.query_one(OptionList).get_option_at_index(0).prompt)
        await pilot.press("up", "enter")
        await stage.until(pilot, lambda: stage.bench.desk.program.text == second and not stage.busy)
        assert not stage.bench.session.undone


async def test_a_list_on_a_small_screen_keeps_the_line_that_says_what_enter_does(stage):
    async with stage.described(size=(80, 24)) as pilot:
        await stage.say(pilot, "/gallery", wait=False)
        await stage.until(pilot, lambda: stage.app.screen.query(".foot"))
        await pilot.pause()
        box, foot = stage.app.screen.query_one(".dialog").region, stage.app.screen.query_one(".foot").region
        assert foot.height and foot.bottom < box.bottom <= 24


async def test_an_example_of_the_gallery_comes_into_the_line_to_type_in(stage):
    async with stage.described() as pilot:
        await stage.say(pilot, "/gallery night", wait=False)
        await stage.until(pilot, lambda: stage.bench.chat.entry.text.startswith("At night in the rain ego drives"))
        await stage.say(pilot, "/gallery nothing")
        assert stage.said[-1].startswith("There is no example nothing; there are cut-in, ")
        await stage.say(pilot, "/gallery", wait=False)
        await stage.until(pilot, lambda: len(stage.app.screen_stack) == 3)
        assert stage.app.screen.query_one(OptionList).option_count == 10
        await pilot.press(*"police", "enter")
        await stage.until(pilot, lambda: stage.bench.chat.entry.text.startswith("Vehicle 1 was travelling"))


async def test_sessions_are_renamed_and_deleted(stage):
    async with stage.described() as pilot:
        await stage.say(pilot, "/rename evening")
        assert stage.said[-1] == "The session demo is now called evening."
        assert stage.bench.chat.border_subtitle == "evening" and stage.app.prefs.session == "evening"
        await stage.say(pilot, "/delete evening")
        assert stage.said[-1] == "That session is open: /open another one first."
        await stage.say(pilot, "/delete morning")
        assert stage.said[-1] == "There is no session morning; /open lists them."
        await stage.say(pilot, "/open evenin", wait=False)
        said = "There is no session and no file evenin. Did you mean evening? /new evenin makes a new session."
        await stage.until(pilot, lambda: stage.said[-1] == said)
        await stage.say(pilot, "/open x/y", wait=False)
        await stage.until(pilot, lambda: "There are evening; /open lists all." in stage.said[-1])
        assert [s.name for s in stage.backends[0].sessions.list()] == ["evening"]
        await stage.say(pilot, "/new night", wait=False)
        await stage.until(pilot, lambda: stage.bench.session.name == "night")
        await stage.say(pilot, "/delete evening", wait=False)
        await stage.until(pilot, lambda: len(stage.app.screen_stack) == 3)
        await pilot.press(*"do", "enter")  # what was meant for the chat line deletes nothing
        await stage.until(pilot, lambda: len(stage.app.screen_stack) == 2)
        assert {s.name for s in stage.backends[0].sessions.list()} == {"night", "evening"}
        await stage.say(pilot, "/delete evening", wait=False)
        await stage.until(pilot, lambda: len(stage.app.screen_stack) == 3)
        await pilot.press("down", "enter")
        await stage.until(pilot, lambda: stage.said and stage.said[-1] == "The session evening is deleted.")
        assert [s.name for s in stage.backends[0].sessions.list()] == ["night"]


async def test_a_new_session_is_said_to_be_made_or_to_be_there(stage):
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        for said in ("Session evening made.", "evening is there already: opened."):
            await stage.bench.run_command("new", "evening")
            await stage.until(pilot, lambda said=said: stage.said[-1:] == [said])
            await stage.bench.run_command("new", "morning")
            await stage.until(pilot, lambda: stage.bench.session.name == "morning")


@pytest.mark.parametrize("send", [False, True])
async def test_what_is_typed_while_another_session_is_being_opened_is_for_that_one(stage, monkeypatch, send):
    async with stage.described() as pilot:
        entry, sessions, gate = stage.bench.chat.entry, stage.bench.sessions, asyncio.Event()
        opened, first = sessions._opened, stage.bench.session.name

        async def slowly(name):
            await gate.wait()
            return await opened(name)

        monkeypatch.setattr(sessions, "_opened", slowly)
        entry.focus()
        await pilot.press(*"/new", "space", *"fresh", "enter", *"half")
        stage.bench.drafts.save(now=True)
        assert stage.bench.session.name == first and stage.bench.session.draft("chat") == "" and entry.text == "half"
        if send:
            await stage.say(pilot, CUT_IN, wait=False)
            await stage.until(pilot, lambda: stage.said[-1:] == [f"Waiting until the session is open: “{CUT_IN}”"])
        gate.set()
        await stage.until(pilot, lambda: stage.bench.session.name == "fresh")
        if send:
            await stage.until(pilot, lambda: stage.bench.session.structure.text == CUT_IN and not stage.busy)
            return
        await pilot.press(*"way")
        assert entry.text == "halfway"
        assert sessions.left is None


async def test_a_draft_stays_in_its_session_where_no_typed_command_opens_another(stage):
    async with stage.described() as pilot:
        first = stage.bench.session.name
        stage.bench.chat.entry.focus()
        await pilot.press(*"half")
        await stage.bench.run_command("new", "fresh")
        await stage.until(pilot, lambda: stage.bench.session.name == "fresh")
        assert stage.bench.chat.entry.text == ""
        await stage.bench.run_command("open", first)
        await stage.until(pilot, lambda: stage.bench.chat.entry.text == "half")


async def test_what_is_sent_before_the_session_is_open_waits_for_it(stage):
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.until(pilot, lambda: stage.bench is not None)
        await stage.ready(pilot)
        session, stage.bench.session = stage.bench.session, None  # as it is while another is still being opened
        for text in ("/map town", CUT_IN, "What is a cut-in?"):
            await stage.say(pilot, text, wait=False)
            said = f"Waiting until the session is open: “{text}”"
            await stage.until(pilot, lambda said=said: stage.said[-1:] == [said])
        stage.bench.session = session
        await stage.bench.turns.say_early(opened=True)
        await stage.until(pilot, lambda: stage.bench.desk.structure.text == CUT_IN and not stage.busy)
        await stage.until(pilot, lambda: stage.bench.choices.choice.map == "town")
        assert stage.bench.chat.entry.text == "What is a cut-in?"


async def test_what_could_not_be_sent_is_not_sent_with_what_is_typed_next(stage):
    async with stage.described() as pilot:
        stage.engine.gate, stage.engine.gated_at = threading.Event(), "say"
        entry, kept = stage.bench.chat.entry, "make it 12 m"
        await stage.say(pilot, "What is a cut-in?", wait=False)
        await stage.until(pilot, lambda: stage.busy)
        await stage.say(pilot, kept, wait=False)
        await stage.until(pilot, lambda: entry.text == kept)
        await pilot.press("n", "o")
        assert entry.text == "no" and entry.draft == f"{kept}\nno"
        await pilot.press("enter")
        await stage.until(pilot, lambda: entry.kept == [kept, "no"] and entry.text == kept)
        await pilot.press("backspace")
        await stage.until(pilot, lambda: entry.kept == ["no"] and not entry.text)
        stage.engine.gate.set()
        await stage.idle(pilot)


async def test_page_up_in_the_line_scrolls_the_chat(stage):
    async with stage.described(size=(80, 24)) as pilot:
        chat = stage.bench.chat
        for i in range(40):
            await chat.note(f"line {i}")
        await stage.until(pilot, lambda: chat.conversation.scroll_y == chat.conversation.max_scroll_y > 0)
        chat.entry.focus()
        await pilot.press("pageup")
        await stage.until(pilot, lambda: chat.conversation.scroll_y < chat.conversation.max_scroll_y)
        assert chat.entry.has_focus
        await pilot.press("pagedown")
        await stage.until(pilot, lambda: chat.conversation.scroll_y == chat.conversation.max_scroll_y)
