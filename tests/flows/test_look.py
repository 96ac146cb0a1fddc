"""The themes in terminals with fewer colours, and the row of keys."""

import pytest
from rich.color import Color, ColorSystem

from c2s_tui.keys import row
from c2s_tui.look.themes import themes
from c2s_tui.sheet.editor import FieldEditor
from c2s_tui.sheet.rows import SENTENCE, Row


@pytest.mark.parametrize("theme", [t for t in themes() if not t.ansi], ids=lambda t: t.name)
def test_cursor_and_dialogs_stand_out_with_256_colours(theme):
    """tmux and ssh often pass on no more: with equal colours the cursor of the structure pane cannot be seen."""
    shades = [theme.background, theme.surface, theme.panel]
    numbers = {Color.parse(str(shade)).downgrade(ColorSystem.EIGHT_BIT).number for shade in shades}
    assert len(numbers) == 3


def test_the_row_of_keys_is_that_of_the_open_editor():
    words = row(FieldEditor(Row("E:sentence", SENTENCE, "E", "Ego drives."), None), {}, 140).plain
    assert "Esc keep as it was" in words and "edit" not in words and words.startswith("F1 help")


async def test_in_the_code_its_keys_are_named(stage):
    async with stage.described() as pilot:
        await pilot.press("f4")
        await stage.until(pilot, lambda: stage.bench.code.area.has_focus)
        words = row(stage.app.focused, {}, 140).plain
        assert "F5 apply and run" in words and "Ctrl+F find" in words
        assert stage.bench.code.area.cursor_location[0] + 1 == next(
            s.first for s in stage.bench.code.side.spans if s.component == "E"
        )  # the code opens at ego


async def test_one_word_of_the_glossary_is_answered_in_the_chat(stage):
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        await stage.say(pilot, "/glossary PET")
        assert stage.said[-1].startswith("PET: Post-encroachment time")
        await stage.say(pilot, "/glossary flux")
        assert stage.said[-1] == "The glossary has no word flux; /glossary lists all of them."
        assert len(stage.app.screen_stack) == 2
