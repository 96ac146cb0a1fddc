"""The user's text in the app: nothing is lost, changed or applied unasked."""

import pytest
from scripted_engine import CUT_IN

from c2s_engine.structure.edits import SetField, SetProgram

OWN = '''"""
TITLE: Bypassing
"""
# Mine.
param map = localPath('town.xodr')
model scenic.simulators.carla.model

SPEED = 10


behavior Drive():
\tdo FollowLaneBehavior(SPEED)   # tabs, and no end of line at the end
ego = new Car with behavior Drive()'''

pytestmark = pytest.mark.full


async def opened(stage, pilot, text, name="mine.scenic"):
    file = stage.folder.parent / name
    file.write_bytes(text.encode())
    await stage.bench.run_command("open", str(file))
    await stage.until(pilot, lambda: stage.bench.session.program.text == text and not stage.busy)
    return file


ENDS = {"lf": OWN, "crlf": OWN.replace("\n", "\r\n"), "mixed": OWN + "\r\nX = 1\nY = 2\n"}


@pytest.mark.parametrize("text", ENDS.values(), ids=ENDS)
async def test_opened_looked_at_and_saved_is_the_same_file(stage, text):
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        file = await opened(stage, pilot, text)
        for key in ("f4", "f2", "f4", "f3"):
            await pilot.press(key)
        file.unlink()
        await stage.bench.run_command("save", str(file))
        await stage.until(pilot, file.exists)
        assert file.read_bytes() == text.encode() and not stage.bench.code.edited


async def test_what_was_applied_is_no_draft_any_more(stage):
    """Else a crash would bring back an older program as unapplied edits."""
    async with stage.described() as pilot:
        stage.write("left of ego by 3.5", "left of ego by 4.0")
        await pilot.pause()
        stage.bench.drafts.save()
        await stage.until(pilot, lambda: "by 4.0" in stage.bench.session.draft("code"))
        await pilot.press("f4", "f5")
        await stage.until(pilot, lambda: not stage.busy and not stage.bench.code.edited)
        await stage.until(pilot, lambda: stage.bench.session.draft("code") == "")
        assert "by 4.0" in stage.bench.session.program.text


async def test_what_is_written_of_what_was_applied_takes_its_place(stage):
    """A constant is read into S, and the comment beside it is written anew: nothing of that is unapplied."""
    apply = stage.engine.apply
    stage.engine.apply = lambda structure, edits, **options: apply(
        structure, [SetProgram(text=e.text.replace("by 4.0,", "by 4.0,  # m")) for e in edits], **options
    )
    async with stage.described() as pilot:
        stage.write("left of ego by 3.5", "left of ego by 4.0")
        await stage.until(pilot, lambda: "F5 applies" in str(stage.bench.code.border_subtitle))
        await pilot.press("f4", "f5")
        await stage.until(pilot, lambda: "by 4.0,  # m" in stage.bench.session.program.text and not stage.busy)
        assert stage.bench.code.text == stage.bench.session.program.text
        assert not stage.bench.code.border_subtitle


async def test_a_file_is_opened_in_a_session_of_its_own(stage):
    async with stage.described() as pilot:
        program, draft = stage.bench.session.program.text, stage.bench.session.name
        stage.write("left of ego by 3.5", "left of ego by 4.0")
        await opened(stage, pilot, OWN)
        assert stage.bench.session.name == "mine" and not stage.bench.code.edited
        await stage.bench.run_command("open", draft)
        await stage.until(pilot, lambda: stage.bench.session.name == draft)
        assert stage.bench.session.program.text == program
        await stage.until(pilot, lambda: "by 4.0" in stage.bench.code.text)  # a draft of its session


async def test_leaving_the_code_applies_nothing_and_esc_stays_there(stage):
    async with stage.described() as pilot:
        await pilot.press("f4")
        await stage.until(pilot, lambda: stage.bench.code.area.has_focus)
        stage.bench.code.area.move_cursor((0, 0))
        await pilot.press("x", "escape", "y")
        assert stage.bench.code.area.has_focus and stage.bench.code.area.text.startswith("xy")
        await pilot.press("f2")
        await pilot.pause()
        assert len(stage.bench.session.history) == 1 and stage.bench.code.edited
        assert stage.bench.code.area.text.startswith("xy")


async def test_a_comment_above_the_program_outlives_turns_and_nothing_freezes(stage):
    async with stage.described() as pilot:
        area = stage.bench.code.area
        area.text = "# Ours, 2026.\n" + area.text
        await pilot.press("f5")
        await stage.until(pilot, lambda: stage.bench.session.program.text.startswith("# Ours") and not stage.busy)
        await stage.editing(pilot, "O1:type")
        await stage.type_over(pilot, "bus")
        await stage.until(pilot, lambda: "new Bus" in area.text)
        assert area.text == stage.bench.session.program.text and area.text.startswith("# Ours, 2026.\n## G")
        file = stage.folder.parent / "out.scenic"
        await stage.bench.run_command("save", str(file))
        await stage.until(pilot, file.exists)
        assert file.read_text() == area.text


async def test_what_is_typed_during_a_turn_is_merged_with_it(stage):
    async with stage.described() as pilot:
        stage.write("terminate after 20 seconds", "terminate after 30 seconds")
        await stage.editing(pilot, "O1:type")
        await stage.type_over(pilot, "bus")
        await stage.until(pilot, lambda: "new Bus" in stage.bench.code.area.text)
        assert "after 30 seconds" in stage.bench.session.program.text, "edits of the code come before"
        stage.write("after 30 seconds", "after 40 seconds")
        await stage.bench.run_command("undo")
        await stage.until(pilot, lambda: "new Van" in stage.bench.code.area.text and not stage.busy)
        assert "after 40 seconds" in stage.bench.code.area.text and stage.bench.code.edited


async def test_a_fix_leaves_the_cursor_and_no_finding(stage):
    async with stage.described() as pilot:
        await stage.misspell(pilot)
        row = stage.bench.code.area.cursor_location[0]
        area = stage.bench.code.area
        await pilot.press("ctrl+t")
        await pilot.pause()
        assert area.cursor_location[0] == row and not stage.bench.code.diagnostics
        await pilot.press("ctrl+z")
        await stage.until(pilot, lambda: "VanBehaviour" in area.text)
        assert area.cursor_location[0] == row
        await pilot.press("ctrl+y")
        await stage.until(pilot, lambda: not stage.bench.code.edited)
        assert area.cursor_location[0] == row and not stage.bench.code.diagnostics


async def test_keys_undo_what_was_typed_and_no_turn(stage):
    async with stage.described() as pilot:
        await stage.bench.turns.make_edits((SetField(component="O1", path="placement.gap", value=25.0),))
        await stage.idle(pilot)
        written = stage.bench.desk.program.text
        area = stage.bench.code.area
        area.focus()
        await pilot.press("ctrl+home", "x")
        assert area.cursor_location == (0, 1) and stage.bench.code.edited
        await pilot.press("ctrl+z")
        assert area.text == written
        await pilot.press("ctrl+z")
        assert area.text == written and not stage.bench.code.edited
        await pilot.press("ctrl+end")
        assert area.cursor_location == area.document.end


async def test_a_new_line_of_code_begins_as_far_in_as_the_one_before(stage):
    async with stage.described() as pilot:
        area = stage.bench.code.area
        area.text = "behavior B():\n    do Stop(line)"
        area.focus()
        area.move_cursor((1, 17))
        await pilot.press("enter", "x")
        area.move_cursor((0, 13))
        await pilot.press("enter", "y")
        await stage.until(pilot, lambda: area.text == "behavior B():\n    y\n    do Stop(line)\n    x")


async def test_tab_leaves_a_field_or_takes_it(stage):
    async with stage.described() as pilot:
        await stage.editing(pilot, "O1:type")
        await pilot.press("tab")
        await stage.until(pilot, lambda: stage.bench.sheet.editor is None)
        assert stage.bench.sheet.has_focus and len(stage.bench.session.history) == 1
        await stage.editing(pilot, "O1:type")
        stage.app.focused.value = "tru"
        await pilot.press("tab")
        await stage.until(pilot, lambda: stage.bench.sheet.editor.query_one("Input").value == "truck")
        await pilot.press("tab")
        await stage.until(pilot, lambda: stage.bench.desk.structure["O1"].spec.type == "truck" and not stage.busy)
        assert stage.bench.sheet.editor is None


async def test_a_chat_turn_is_about_the_code_as_it_was_typed(stage):
    async with stage.described() as pilot:
        stage.write("left of ego by 3.5", "left of ego by 4.0")
        await stage.say(pilot, CUT_IN)
        assert [t.text for t in stage.bench.session.history][1:] == ["code edited by hand", CUT_IN]


async def test_an_empty_session_has_no_marks_of_the_one_before(stage):
    async with stage.described() as pilot:
        await stage.misspell(pilot)
        code, strip = stage.bench.code, stage.bench.code.query_one("#finding")
        assert code.side.spans and code.side.problems and strip.display and code.border_subtitle
        await stage.say(pilot, "/new fresh", wait=False)
        await stage.until(pilot, lambda: stage.bench.session.name == "fresh")
        assert (code.side.spans, code.side.changed, code.side.problems) == ((), frozenset(), {})
        assert not strip.display and not code.border_subtitle and not code.edited
        await pilot.press("f5")
        await stage.until(pilot, lambda: stage.said and stage.said[-1].startswith("There is no program yet"))
        assert not stage.bench.desk.results and not stage.bench.session.history
