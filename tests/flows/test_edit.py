"""Edits of S and of the code, and back."""

import threading
from typing import get_args

from scripted_engine import CUT_IN
from textual.events import Key

from c2s_engine.structure.edits import AddObject, SetField
from c2s_engine.structure.specs import ObjectSpec, Placement
from c2s_engine.structure.vocabulary import Position


def test_edit_an_object_shows_its_reach_and_rewrites_only_that(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        before = stage.bench.desk.program
        await stage.editing(pilot, "E:speed")
        stage.app.focused.value = "60"
        await stage.until(pilot, lambda: stage.bench.sheet.reached)
        assert stage.bench.sheet.reached == {"E", "O1", "T"}
        await pilot.press("enter")
        await stage.idle(pilot)
        await stage.until(pilot, lambda: stage.bench.sheet.editor is None)
        desk = stage.bench.desk
        assert desk.structure["E"].spec.speed == 16.6667
        assert set(desk.rewritten) == {"E", "O1", "T"}
        assert desk.program.fragment("G") == before.fragment("G")
        assert desk.program.fragment("E") != before.fragment("E")

    assert compare(flow)


def test_edit_an_object_rewrites_it_and_what_reads_it(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        bus = ObjectSpec(name="bus", type="bus", placement=Placement(position="behind", of="O1", gap=10.0))
        await stage.bench.turns.make_edits((AddObject(spec=bus, description="A bus behind O1."),))
        await stage.until(pilot, lambda: "O2" in stage.bench.desk.structure and not stage.busy)
        before = stage.bench.desk.program
        await stage.editing(pilot, "O1:speed")
        stage.app.focused.value = "36"
        await stage.until(pilot, lambda: stage.bench.sheet.reached == {"O1", "O2"})
        await pilot.press("enter")
        await stage.until(pilot, lambda: stage.bench.desk.structure["O1"].spec.speed == 10.0 and not stage.busy)
        desk = stage.bench.desk
        assert set(desk.rewritten) == {"O1", "O2"}
        assert all(desk.program.fragment(c) == before.fragment(c) for c in ("G", "R", "E", "T"))

    assert compare(flow)


def test_the_reach_is_shown_before_the_edit_is_made(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        await stage.editing(pilot, "O1:type")
        stage.app.focused.value = "bus"
        await stage.until(pilot, lambda: stage.bench.sheet.reached)
        assert stage.bench.sheet.reached == {"O1"}
        assert stage.bench.desk.structure["O1"].spec.type == "van"

    assert compare(flow)


def test_a_refused_value_is_explained_at_the_field(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        await stage.to_row(pilot, "O1:type")
        await pilot.press("enter")
        await stage.type_over(pilot, "submarine")
        assert stage.bench.sheet.editor is not None
        assert stage.bench.desk.structure["O1"].spec.type == "van"

    assert compare(flow, size=(80, 24))


async def test_what_opens_at_the_lower_edge_is_in_view(stage):
    """At 80x24 each row is reached from above, so it is the last that is seen when its line opens below it."""
    async with stage.described(size=(80, 24)) as pilot:
        sheet = stage.bench.sheet

        def seen(widget):
            return sheet.region.contains_region(widget.region)

        def in_view():
            editor = sheet.editor
            return editor is not None and editor.size.height > 1 and seen(editor) and len(editor.query("Input")) == 1

        await stage.to_row(pilot, "O1")
        await pilot.press("space")
        await stage.until(pilot, lambda: any(row.key == "O1:placement.of" for row in sheet.rows))
        await stage.until(pilot, lambda: seen(sheet.views[sheet.cursor]) and seen(sheet.views[sheet.cursor + 3]))
        tried = 0
        await pilot.press("home")
        while tried < 3:
            await pilot.press("down")
            row = sheet.here
            if sheet.views[sheet.cursor].region.bottom < sheet.region.bottom - 1 or not (row.field and row.field.leaf):
                continue
            tried += 1
            await pilot.press("enter")
            await stage.until(pilot, in_view)
            await pilot.press("escape")
            await stage.until(pilot, lambda: sheet.editor is None)
            await stage.until(pilot, lambda: seen(sheet.views[sheet.cursor]))
        await pilot.press("end", "enter")
        await stage.until(pilot, lambda: sheet.query("#new-object") and seen(sheet.query_one("#new-object")))


def test_undo_and_redo(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        first = stage.bench.desk.program.text
        await stage.to_row(pilot, "O1:placement")
        await stage.bench.turns.make_edits((SetField(component="O1", path="placement.gap", value=25.0),))
        await stage.idle(pilot)
        second = stage.bench.desk.program.text
        assert "> 25.0" in second and second != first
        stage.bench.sheet.focus()
        await pilot.press("u")
        await stage.until(pilot, lambda: not stage.busy and stage.bench.code.area.text == first)
        await pilot.press("ctrl+y")
        await stage.until(pilot, lambda: not stage.busy and stage.bench.code.area.text == second)
        assert stage.bench.session.can_undo and not stage.bench.session.can_redo

    assert compare(flow)


async def test_what_is_typed_takes_the_place_of_the_old_value(stage):
    """The arrow keys keep it; a sentence is changed in places; the hint names every value."""
    async with stage.described() as pilot:
        await stage.editing(pilot, "O1:name")
        line = stage.bench.sheet.editor.query_one("Input")
        assert line.selected_text == "van"
        await pilot.press("end", "2")
        assert line.value == "van2"
        await pilot.press("escape")
        await stage.until(pilot, lambda: stage.bench.sheet.has_focus)
        await stage.editing(pilot, "O1:type")
        await pilot.press("b", "u", "s", "enter")
        await stage.until(pilot, lambda: stage.bench.desk.structure["O1"].spec.type == "bus" and not stage.busy)
        await stage.editing(pilot, "O1:sentence")
        assert not stage.bench.sheet.editor.query_one("Input").selected_text
        await pilot.press("escape")
        await pilot.press("space")
        await stage.until(pilot, lambda: any(row.key == "O1:placement.position" for row in stage.bench.sheet.rows))
        await stage.editing(pilot, "O1:placement.position")
        hint = stage.bench.sheet.editor._hint().plain
        assert all(position in hint for position in get_args(Position))


async def test_objects_are_added_moved_and_removed(stage):
    async with stage.described() as pilot:
        await stage.to_row(pilot, "add")
        await pilot.press("enter")
        await stage.type_over(pilot, "pedestrian")
        await stage.until(pilot, lambda: "O2" in stage.bench.desk.structure and not stage.busy)
        assert stage.bench.desk.structure["O2"].spec.type == "pedestrian"
        await stage.to_row(pilot, "O2")
        await pilot.press("K")
        await stage.until(pilot, lambda: stage.bench.desk.structure.ids == ("G", "R", "E", "O2", "O1", "T"))
        await stage.idle(pilot)
        await stage.to_row(pilot, "O2")
        await pilot.press("x")
        await stage.until(pilot, lambda: "O2" not in stage.bench.desk.structure and not stage.busy)
        assert stage.bench.desk.program.span_of("O2") is None


async def test_a_phase_is_added_and_removed(stage):
    async with stage.described() as pilot:
        await stage.to_row(pilot, "O1")
        await pilot.press("space")
        await stage.to_row(pilot, "O1:phases")
        await pilot.press("enter")
        await stage.type_over(pilot, "brake")
        phases = stage.bench.desk.structure["O1"].spec.phases
        assert [p.action for p in phases] == ["cut_in", "brake"]
        await stage.to_row(pilot, "O1:phases.0")
        await pilot.press("x")
        await stage.until(pilot, lambda: len(stage.bench.desk.structure["O1"].spec.phases) == 1)
        await stage.idle(pilot)


async def test_phases_are_added_from_a_phase_several_at_once(stage):
    async with stage.described() as pilot:
        await stage.to_row(pilot, "O1:phases.0")
        await pilot.press("a")
        await stage.until(pilot, lambda: stage.bench.sheet.editor)
        await pilot.press("w", "enter")  # no action, and too short to be the beginning of one
        assert len(stage.bench.desk.structure["O1"].spec.phases) == 1 and stage.bench.sheet.editor
        await stage.type_over(pilot, "brake, stop")
        await stage.idle(pilot)
        phases = stage.bench.desk.structure["O1"].spec.phases
        assert [p.action for p in phases] == ["cut_in", "brake", "stop"]


async def test_newer_edits_take_along_those_still_being_written(stage):
    async with stage.described() as pilot:
        stage.engine.gate, stage.engine.gated_at = threading.Event(), "write"
        await stage.bench.turns.make_edits((SetField(component="E", path="speed", value=20.0),))
        await stage.until(pilot, lambda: ("apply", ["field"]) in stage.engine.calls)
        await stage.bench.turns.make_edits((SetField(component="O1", path="type", value="bus"),))
        await stage.until(pilot, lambda: ("apply", ["field", "field"]) in stage.engine.calls)
        stage.engine.gate.set()
        await stage.idle(pilot)
        structure = stage.bench.session.structure
        assert structure["E"].spec.speed == 20.0 and structure["O1"].spec.type == "bus"
        assert len(stage.bench.session.history) == 2


async def test_the_panes_follow_each_other(stage):
    async with stage.described() as pilot:
        await stage.to_row(pilot, "O1")
        area, span = stage.bench.code.area, stage.bench.desk.program.span_of("O1")
        await stage.until(pilot, lambda: area.cursor_location[0] + 1 == span.first)
        await pilot.press("f4")
        await stage.until(pilot, lambda: area.has_focus)
        area.move_cursor((stage.bench.desk.program.span_of("E").first, 0))
        await stage.until(pilot, lambda: stage.bench.sheet.here.cid == "E")


async def test_what_is_typed_ahead_is_text_and_no_command(stage):
    async with stage.described() as pilot:
        await stage.to_row(pilot, "O1:name")
        for key in ("enter", "x", "a", "u"):  # all of it before the app has done any
            stage.app.post_message(Key(key, key if len(key) == 1 else "\r"))
        await stage.until(pilot, lambda: stage.bench.sheet.editor and stage.bench.sheet.editor.query("Input"))
        await stage.until(pilot, lambda: stage.bench.sheet.editor.query_one("Input").value == "xau")
        await pilot.press("escape")
        await stage.until(pilot, lambda: stage.bench.sheet.has_focus)
        for key in ("f2", "x", "a"):
            stage.app.post_message(Key(key, key if len(key) == 1 else None))
        await stage.until(pilot, lambda: stage.bench.chat.entry.text == "xa")
        for key in ("backspace", "left", "b", "right", "c"):
            stage.app.post_message(Key(key, key if len(key) == 1 else None))
        await stage.until(pilot, lambda: stage.bench.chat.entry.text == "bxc")
        assert len(stage.bench.session.history) == 1


async def test_the_words_of_the_text_follow_and_lead(stage):
    async with stage.described() as pilot:
        await stage.to_row(pilot, "O1")
        line = next(line for line in stage.bench.query("Line") if line.plain == CUT_IN)
        marked = [line.content.plain[s.start : s.end] for s in line.content.spans]
        assert marked[-1] == "A van in the left lane cuts in 15 m ahead"
        await pilot.click(line, offset=(4, 0))  # on "Ego drives"
        await stage.until(pilot, lambda: stage.bench.sheet.here.cid == "E" and stage.bench.here == "E")
        marked = [line.content.plain[s.start : s.end] for s in line.content.spans]
        assert marked[-1] == "Ego drives at 50 km/h"


def test_hand_edit_and_conflict(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        await pilot.press("f4")
        await stage.until(pilot, lambda: stage.bench.code.area.has_focus)
        stage.write("left of ego by 3.5", "left of ego by 4.0")
        await pilot.press("f5")
        await stage.until(pilot, lambda: stage.bench.session.structure["O1"].origin == "by_hand")
        await stage.idle(pilot)
        assert stage.bench.desk.state(stage.bench.desk.structure["O1"]) == "by_hand"
        assert "by 4.0" in stage.bench.session.program.text and not stage.bench.code.edited
        await stage.conflict(pilot)
        assert "by 4.0" in stage.bench.desk.program.text  # what was written by hand stands
        await stage.to_row(pilot, "O1:conflict")
        await pilot.press("enter")
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Conflict")

    assert compare(flow)


async def test_a_conflict_is_decided_either_way(stage):
    async with stage.described() as pilot:
        for key, expected in (("m", "by 4.0"), ("t", "by 3.5")):
            stage.write("left of ego by 3.5", "left of ego by 4.0")
            stage.bench.code.commit()
            await pilot.pause()
            await stage.idle(pilot)
            await stage.conflict(pilot, gap=stage.bench.desk.structure["O1"].spec.placement.gap + 5)
            await stage.bench.run_command("conflict")
            await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Conflict")
            await pilot.press(key)
            await stage.until(pilot, lambda: stage.bench.session.structure["O1"].conflict is None)
            await stage.idle(pilot)
            assert expected in stage.bench.desk.program.fragment("O1")


def test_compile_error_and_fix(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        await stage.misspell(pilot)

    assert compare(flow)


def test_the_offered_fix_is_taken(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        stage.write("with behavior VanBehavior", "with behavior VanBehaviour")
        await pilot.press("f5")
        await stage.until(pilot, lambda: stage.bench.desk.diagnostics and not stage.busy)
        assert stage.bench.desk.state(stage.bench.desk.structure["O1"]) == "failed"
        assert "fix: VanBehavior is defined above" in stage.said[-1]
        await pilot.press("f8")
        await pilot.press("ctrl+t")
        await stage.until(pilot, lambda: not stage.bench.desk.diagnostics and not stage.busy)
        assert "VanBehaviour" not in stage.bench.session.program.text

    assert compare(flow)


def test_compile_error_80x24(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        await stage.misspell(pilot)

    assert compare(flow, size=(80, 24))


def test_a_conflict_80x24(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        stage.write("left of ego by 3.5", "left of ego by 4.0")
        stage.bench.code.commit()
        await stage.until(pilot, lambda: stage.bench.session.structure["O1"].origin == "by_hand")
        await stage.idle(pilot)
        await stage.conflict(pilot)
        await stage.bench.run_command("conflict")
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Conflict")

    assert compare(flow, size=(80, 24))


async def test_keys_typed_at_once_change_a_field_in_their_order(stage):
    async with stage.described() as pilot:
        await stage.editing(pilot, "O1:name")
        for key in ("home", "right", "q", "right", "backspace", "r", "end", "left", "x"):
            stage.app.post_message(Key(key, key if len(key) == 1 else None))
        await stage.until(pilot, lambda: stage.bench.sheet.editor.query_one("Input").value == "vqrxn")


async def test_enter_after_a_key_to_another_pane_is_meant_for_that_pane(stage):
    async with stage.described() as pilot:
        await stage.to_row(pilot, "O1:name")
        stage.bench.room.go_to("chat")
        stage.bench.chat.entry.put("lo")
        for key in ("f3", "enter"):
            stage.app.post_message(Key(key, "\r" if key == "enter" else None))
        await stage.until(pilot, lambda: stage.bench.sheet.editor is not None)
        assert stage.bench.chat.entry.text == "lo" and len(stage.bench.session.history) == 1


async def test_going_back_to_s_goes_on_in_the_field_that_is_open(stage):
    async with stage.described() as pilot:
        await stage.editing(pilot, "O1:name")
        await pilot.press("f2")
        await stage.until(pilot, lambda: stage.bench.chat.entry.has_focus)
        await pilot.press("f3", "ctrl+u", "b")
        await stage.until(pilot, lambda: stage.bench.sheet.editor.query_one("Input").value == "b")


async def test_a_long_sentence_is_opened_at_its_beginning_with_the_whole_below(stage):
    async with stage.described((100, 30)) as pilot:
        await stage.editing(pilot, "O1:sentence")
        editor = stage.bench.sheet.editor
        line, text = editor.query_one("Input"), stage.bench.desk.structure["O1"].description
        await stage.until(pilot, lambda: line.cursor_position == 0 and len(text) > line.size.width > 0)
        assert line.scroll_offset.x == 0 and editor.query_one("Static").content.plain.startswith(f"{text}\n")
        await pilot.press("end", "!")
        await stage.until(pilot, lambda: editor.query_one("Static").content.plain.startswith(f"{text}!\n"))
        assert line.scroll_offset.x + line.size.width >= line.cursor_position


async def test_code_by_hand_against_its_fields_says_which_key_chooses(stage):
    async with stage.described() as pilot:
        stage.write("left of ego by 3.5", "left of ego by 4.0")
        stage.bench.code.commit()
        await stage.until(pilot, lambda: stage.bench.session.structure["O1"].origin == "by_hand")
        await stage.idle(pilot)
        await stage.conflict(pilot)
        await stage.until(
            pilot, lambda: "O1: code or fields? Alt+C chooses" in stage.bench.query_one("#status").content.plain
        )
        for focus in ("f2", "f3", "f4"):
            await pilot.press(focus, "alt+c")
            await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Conflict")
            await pilot.press("escape")
            await stage.until(pilot, lambda: stage.app.screen is stage.bench)
        await pilot.press("alt+c")
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Conflict")
        await pilot.press("t")
        await stage.until(pilot, lambda: stage.bench.session.structure["O1"].conflict is None)
        await stage.until(pilot, lambda: "code or fields?" not in stage.bench.query_one("#status").content.plain)
