"""Beginning, choosing, helping, looks, leaving."""

import signal
from pathlib import Path

import pytest
from scripted_engine import CUT_IN, Script

from c2s_engine.session.errors import SessionError
from c2s_engine.session.sessions import Sessions
from c2s_tui.prefs import Prefs, load


def test_first_run_opens_and_explains_the_example(stage, compare):
    async def flow(pilot):
        assert stage.bench.session.name == "example"
        assert stage.bench.desk.program.text and "O1" in stage.bench.desk.structure
        assert [line for line in stage.said if line.startswith("This is an example")]
        assert load().welcomed  # the next start opens what was open last

    assert compare(flow, session=None, prefs=Prefs())


def test_first_run_80x24(stage, compare):
    async def flow(pilot):
        assert stage.bench.session.name == "example"

    assert compare(flow, size=(80, 24), session=None, prefs=Prefs())


def test_model_missing(stage, compare):
    stage.engine.model_list = SessionError("No Ollama answers at http://127.0.0.1:11434. Start it with `ollama serve`.")

    async def flow(pilot):
        await stage.say(pilot, "/model", wait=False)
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Reading")
        assert "ollama serve" in str(stage.app.screen.body)

    assert compare(flow)


async def test_a_model_is_chosen_and_one_that_is_missing_is_pulled(stage):
    stage.engine.model_list = [
        {"name": "qwen3:8b", "size": 5_200_000_000, "parameters": "8B", "quantization": "Q4_K_M"}
    ]
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        for typed, expected in (("qwen3", "qwen3:8b"), ("llama3", "llama3")):
            await stage.say(pilot, "/model", wait=False)
            await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Chooser")
            await pilot.press(*typed)
            await pilot.press("enter")
            await stage.until(pilot, lambda expected=expected: stage.bench.choices.choice.model == expected)
            assert stage.engine.settings.model == expected and load().model == expected


def test_settings(stage, compare):
    async def flow(pilot):
        await pilot.press("f10")
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Chooser")
        assert [e.value for e in stage.app.screen.entries][:4] == ["method", "model", "map", "theme"]

    assert compare(flow)


def test_doctor(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, "/doctor", wait=False)
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Reading")
        assert "start it: ollama serve" in str(stage.app.screen.body)

    assert compare(flow)


async def test_method_and_map_are_chosen_by_name(stage):
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        await stage.say(pilot, "/method C7", wait=False)
        await stage.until(pilot, lambda: stage.bench.choices.choice.method == "chat2scenic:C7")
        await stage.say(pilot, "/map Town05", wait=False)
        await stage.until(pilot, lambda: stage.bench.choices.choice.map == "Town05")
        await stage.say(pilot, "/map Atlantis", wait=False)
        await stage.until(pilot, lambda: any("There is no map Atlantis" in line for line in stage.said))
        assert stage.bench.turns.options()["map"] == "Town05"
        assert any("The map of new scenarios, in any session: Town05." in line for line in stage.said)


async def test_the_map_of_a_session_with_a_program_is_a_field_of_it(stage):
    async with stage.described() as pilot:
        await stage.say(pilot, "/map Town05", wait=False)
        await stage.until(pilot, lambda: stage.bench.session.structure["G"].spec.map == "Town05" and not stage.busy)
        assert any("The map of this session is Town05" in line for line in stage.said)
        assert not stage.bench.choices.choice.map and stage.bench.turns.options()["map"] == "Town05"
        stage.bench.choices.choose(map="town")  # the default of other sessions
        assert stage.bench.turns.options()["map"] == "Town05"


def test_help_of_the_structure_pane(stage, compare):
    async def flow(pilot):
        await pilot.press("f3")
        await stage.until(pilot, lambda: stage.bench.sheet.has_focus)
        await pilot.press("f1")
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Reading")
        assert "Why is this here" in str(stage.app.screen.body)

    assert compare(flow)


def test_help_80x24(stage, compare):
    async def flow(pilot):
        await pilot.press("f1")
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Reading")

    assert compare(flow, size=(80, 24))


def test_light_theme(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        await stage.say(pilot, "/theme c2s-light", wait=False)
        await stage.until(pilot, lambda: stage.app.theme == "c2s-light")

    assert compare(flow)


def test_no_colour(stage, compare, monkeypatch):
    monkeypatch.setenv("NO_COLOR", "1")

    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        assert stage.app.no_color and stage.app.theme == "c2s-mono"

    assert compare(flow)


def test_sixteen_colours(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        assert stage.app.theme == "c2s-ansi"

    assert compare(flow, prefs=Prefs(welcomed=True, theme="c2s-ansi"))


def test_why_is_this_here(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        await stage.to_row(pilot, "O1")
        await pilot.press("w")
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Reading")
        assert "A van in the left lane cuts in 15 m ahead" in str(stage.app.screen.body)

    assert compare(flow)


async def test_leaving_with_unapplied_edits_asks_once(stage):
    async with stage.described() as pilot:
        stage.bench.code.area.text += "# more\n"
        await pilot.press("ctrl+q")
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Confirm")
        await pilot.press("b")
        await stage.until(pilot, lambda: stage.app.screen is stage.bench)
        await pilot.press("ctrl+q")
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Confirm")
        status = stage.bench.query_one("#status")
        await pilot.press("q")
    assert str(status.content) == "closing"
    assert stage.bench.session.draft("code").endswith("# more\n")


async def test_what_was_typed_comes_back(stage):
    async with stage.described() as pilot:
        stage.bench.chat.entry.put("half a thought")
        await pilot.pause()
        stage.bench.drafts.save(now=True)
        program = stage.bench.desk.program.text
        await stage.backends[-1].thread.do(stage.bench.session.close)
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        assert stage.bench.chat.entry.text == "half a thought"
        assert stage.bench.desk.program.text == program
        assert CUT_IN in stage.said
        came = stage.said[stage.said.index(CUT_IN) :]
        assert any(line.startswith("Added O1; ") and "3 of 3 requirements met" in line for line in came)


@pytest.mark.parametrize("times", [1, 2])
async def test_a_line_that_drops_while_a_draft_is_being_written_loses_nothing(stage, times, monkeypatch):
    """The signal comes on the thread that holds the lock of the drafts, and may come twice."""
    monkeypatch.setattr("c2s_tui.app.end_soon", lambda: None)  # it would end the tests
    async with stage.described() as pilot:
        stage.bench.chat.entry.put("half a thought")
        await pilot.pause()
        session = stage.bench.session
        with session._drafts._writing:
            for _ in range(times):
                signal.raise_signal(signal.SIGHUP)
        await stage.until(pilot, lambda: stage.app._exit)
    assert session.draft("chat") == "half a thought"


async def test_a_text_whose_reading_failed_comes_back(stage):
    text = "Unit 1 went north.\nUnit 2 did not."
    stage.engine.scripts[text] = Script(fail="c2s failed at this text")
    async with stage.described() as pilot:
        await stage.say(pilot, text)
        assert stage.said[-1] == "c2s failed at this text"
        await stage.backends[-1].thread.do(stage.bench.session.close)
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        assert stage.said[-2:] == [text, "c2s failed at this text"] and CUT_IN in stage.said
        await pilot.press("up")
        await stage.until(pilot, lambda: stage.bench.chat.entry.text == text)


async def test_few_colours_choose_the_terminals_own(stage, monkeypatch):
    monkeypatch.setenv("TERM", "screen")
    monkeypatch.delenv("COLORTERM", raising=False)
    monkeypatch.setattr("rich.console.Console.color_system", property(lambda _: "standard"))
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        assert stage.app.theme == "c2s-ansi"


async def test_keys_can_be_remapped(stage):
    async with stage.make(prefs=Prefs(welcomed=True, keys={"app.settings": "f12"})).run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        await pilot.press("f12")
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Chooser")


async def test_files_are_saved_and_changes_outside_noticed(stage, tmp_path: Path):
    async with stage.described() as pilot:
        target = tmp_path / "cut.scenic"
        await stage.say(pilot, f"/save {target}", wait=False)
        await stage.until(pilot, lambda: target.exists() and any("Saved" in line for line in stage.said))
        assert target.read_text() == stage.bench.desk.program.text
        assert stage.said[-2] == f"Saved cut.scenic, cut.s.json in {tmp_path}."
        target.write_text("ego = new Car\n")
        stage.bench.files.file_seen -= 1  # as if the clock had gone on
        told = []
        stage.app.notify = lambda text, **_: told.append(text)
        stage.bench.files.watch_file()
        stage.bench.files.watch_file()
        assert len(told) == 1 and "changed by another program" in told[0]
        await pilot.press("ctrl+s")
        await stage.until(pilot, lambda: type(stage.app.screen).__name__ == "Confirm")
        await pilot.press("down", "enter")
        await stage.until(
            pilot, lambda: stage.bench.desk.program.fragment("E") == "ego = new Car\n" and not stage.busy
        )


async def test_what_is_saved_has_its_map_beside_it_also_after_a_restart(stage, tmp_path: Path):
    """Where it is not at hand, that is said."""
    maps = tmp_path / "maps"
    maps.mkdir()
    (maps / "town.xodr").write_text("<OpenDRIVE/>")
    async with stage.described() as pilot:
        assert "localPath('town.xodr')" in stage.bench.session.program.text
        await stage.backends[-1].thread.do(stage.bench.session.close)
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        for name, said in (("a", "Put town.xodr beside it: the program needs it to run elsewhere."),
                           ("b", f"Saved cut.scenic, town.xodr, cut.s.json in {tmp_path / 'b'}.")):  # fmt: skip
            (tmp_path / name).mkdir()
            await stage.bench.run_command("save", str(tmp_path / name / "cut.scenic"))
            await stage.until(pilot, lambda said=said: said in stage.said)
            stage.engine.library.folder_of = lambda program: str(maps)
    (tmp_path / "b" / "cut.scenic").rename(tmp_path / "b" / "own.scenic")
    stage.engine.library.folder_of = lambda program: None
    async with stage.make(session="other", file=tmp_path / "b" / "own.scenic").run_test(size=(140, 45)) as pilot:
        await stage.until(pilot, lambda: stage.bench and stage.bench.session and stage.bench.files.file)
        await stage.until(pilot, lambda: "town.xodr" in stage.bench.session.program.text and not stage.busy)
        (tmp_path / "c").mkdir()
        await stage.bench.run_command("save", str(tmp_path / "c" / "own.scenic"))
        await stage.until(pilot, lambda: any("Saved own.scenic, town.xodr" in line for line in stage.said))


async def test_no_file_is_overwritten_unasked(stage, tmp_path: Path):
    """Neither one of somebody else's, nor that of the session before, nor one that was changed since."""
    other, first = tmp_path / "list.scenic", tmp_path / "first.scenic"
    other.write_text("my shopping list\n")

    def asked() -> bool:
        return type(stage.app.screen).__name__ == "Confirm"

    async with stage.described() as pilot:
        await stage.say(pilot, f"/save {other}", wait=False)
        await stage.until(pilot, asked)
        await pilot.press("o", "r", "enter")  # typed on
        await stage.until(pilot, lambda: not asked())
        assert other.read_text() == "my shopping list\n"
        await stage.say(pilot, f"/save {first}", wait=False)
        await stage.until(pilot, first.exists)
        saved = first.read_text()
        await stage.say(pilot, "/new second", wait=False)
        await stage.until(pilot, lambda: stage.bench.session.name == "second")
        assert stage.bench.files.file is None
        await stage.say(pilot, CUT_IN)
        await pilot.press("ctrl+s")
        await stage.until(pilot, lambda: stage.bench.chat.entry.text == "/save second.scenic")
        stage.bench.chat.entry.put("")
        await stage.say(pilot, f"/save {first}", wait=False)
        await stage.until(pilot, asked)
        await pilot.press("escape")
        await stage.until(pilot, lambda: not asked())
        assert first.read_text() == saved
        await stage.say(pilot, f"/save {first}", wait=False)
        await stage.until(pilot, asked)
        await pilot.press("down", "down", "enter")
        await stage.until(pilot, lambda: any("Saved" in line for line in stage.said[-2:]))
        await stage.say(pilot, "/save", wait=False)  # its own now
        await stage.until(pilot, lambda: sum("Saved" in line for line in stage.said) == 2)


async def test_a_resize_never_breaks(stage):
    async with stage.make().run_test(size=(200, 60)) as pilot:
        await stage.ready(pilot)
        await stage.say(pilot, CUT_IN)
        for size in ((80, 24), (40, 10), (20, 5), (140, 45), (99, 30), (100, 30)):
            await pilot.resize_terminal(*size)
            await pilot.pause()
        assert stage.bench.code.region.width and not stage.bench.has_class("-narrow")


async def test_a_session_that_is_just_being_closed_elsewhere_is_waited_for(stage):
    elsewhere = Sessions(stage.folder).open("demo", stage.engine)
    app = stage.make()
    async with app.run_test(size=(140, 45)) as pilot:
        await stage.until(pilot, lambda: stage.bench and any("waiting for it to close" in line for line in stage.said))
        elsewhere.close()
        await stage.ready(pilot)
        assert stage.bench.session.name == "demo"


async def test_a_session_that_stays_open_elsewhere_is_left_alone(stage, monkeypatch):
    monkeypatch.setattr("c2s_tui.sessions.GONE_SECONDS", -2.0)  # looks for 1 s
    elsewhere = Sessions(stage.folder).open("demo", stage.engine)
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        assert stage.bench.session.name == "demo-2"
    elsewhere.close()


async def test_ctrl_q_while_the_app_is_on_its_way_out_is_no_error(stage):
    async with stage.described():
        await stage.bench.remove_children()  # as the screen is taken down
        await stage.app.action_quit()
        assert stage.app.failed_by is None
