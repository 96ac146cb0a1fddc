"""From a description to a program, streaming, cancelling, searching."""

import threading

from scripted_engine import CUT_IN, Script

from c2s_engine.structure.edits import SetField
from c2s_engine.structure.progress import Passage, Token


def test_describe_to_program(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        desk = stage.bench.desk
        assert desk.structure.ids == ("G", "R", "E", "O1", "T")
        assert desk.rewritten == ("G", "R", "E", "O1", "T")
        assert all(s.ok for s in desk.stages)
        assert stage.bench.code.area.text == desk.program.text == stage.bench.session.program.text
        assert {desk.state(c) for c in desk.structure.components} == {"clean"}
        assert stage.said[-1].startswith("G, R, E, O1, T written; runs; 3 of 3 requirements met")

    assert compare(flow)


def test_describe_to_program_80x24(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        assert stage.bench.has_class("-narrow")
        assert stage.bench.chat.display and not stage.bench.code.region.width

    assert compare(flow, size=(80, 24))


def test_narrow_panes_are_tabs(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        await pilot.press("f3")
        await stage.until(pilot, lambda: stage.bench.sheet.has_focus)
        assert stage.bench.sheet.region.width == 80
        assert stage.bench.room.current_pane == "sheet"

    assert compare(flow, size=(80, 24))


def test_what_is_not_understood_is_said(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, "lorem [bold]ipsum[/bold]")
        assert stage.said[0] == "lorem [bold]ipsum[/bold]"
        assert "not understood" in stage.said[1]
        assert stage.bench.desk.program.text == ""

    assert compare(flow)


def test_an_answer_streams_as_markdown(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, "What is a cut-in?")
        answer = stage.bench.query_one("Answer")
        assert answer.text.startswith("A **cut-in** is a lane change into ego's lane")
        assert stage.bench.desk.answer_tokens == 24

    assert compare(flow)


def test_an_answer_is_shown_while_it_streams(stage, compare):
    tokens = ("A **cut-in** is", " a lane change", " into ego's lane, and")
    stage.engine.scripts["Explain."] = Script(events=tuple(Token(text=t) for t in tokens))
    stage.engine.gate, stage.engine.gated_at = threading.Event(), "say"

    async def flow(pilot):
        await stage.say(pilot, "Explain.", wait=False)
        await stage.until(pilot, lambda: stage.bench.query("Answer") and stage.bench.query_one("Answer").text)
        await stage.until(pilot, lambda: stage.bench.query_one("Answer Markdown").source == "".join(tokens))
        assert stage.busy

    assert compare(flow)
    stage.engine.gate.set()


def test_escape_cancels_and_keeps_what_is_typed(stage, compare):
    stage.engine.scripts["Explain."] = Script(events=(Token(text="It begins "), Token(text="like this")))
    stage.engine.gate, stage.engine.gated_at = threading.Event(), "say"

    async def flow(pilot):
        await stage.say(pilot, CUT_IN, wait=False)
        await stage.until(pilot, lambda: any("van, cuts in" in line for line in stage.said))
        assert stage.busy
        stage.bench.chat.entry.put("the next thought")
        await pilot.press("escape")
        await stage.idle(pilot)
        assert stage.bench.chat.entry.text == "the next thought"
        assert stage.bench.desk.structure.text == "" and stage.bench.session.program.text == ""
        assert stage.said[-1].startswith("Cancelled")
        stage.engine.gate.set()

    assert compare(flow)


async def test_after_a_cancelled_turn_the_status_is_that_of_the_program_shown(stage):
    """Nothing where there is none; else its stages and what was required and seen."""

    def status():
        return stage.bench.query_one("#status").content.plain

    def ran():
        return not stage.bench.desk.stale and any(s.name == "run" for s in stage.bench.desk.stages)

    stage.engine.gate, stage.engine.gated_at = threading.Event(), "run"
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        await stage.say(pilot, CUT_IN, wait=False)
        await stage.until(pilot, ran)
        await pilot.press("escape")
        await stage.idle(pilot)
        stage.engine.gate.set()
        assert not stage.bench.desk.stages and "requirements" not in status()
        stage.engine.gate = None
        stage.bench.chat.entry.put("")
        await stage.say(pilot, CUT_IN)
        before = stage.bench.desk
        assert "3 of 3 requirements met" in status()
        stage.engine.gate = threading.Event()
        await stage.bench.turns.make_edits((SetField(component="O1", path="placement.gap", value=25.0),))
        await stage.until(pilot, lambda: ran() and not stage.bench.desk.results)
        await pilot.press("escape")
        await stage.idle(pilot)
        stage.engine.gate.set()
        assert (stage.bench.desk.stages, stage.bench.desk.results) == (before.stages, before.results)
        assert "3 of 3 requirements met" in status() and stage.bench.desk.program == before.program


async def test_what_was_cancelled_is_back_in_the_line(stage):
    stage.engine.gate, stage.engine.gated_at = threading.Event(), "say"
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        await stage.say(pilot, CUT_IN, wait=False)
        await stage.until(pilot, lambda: stage.busy)
        await pilot.press("escape")
        await stage.idle(pilot)
        assert stage.bench.chat.entry.text == CUT_IN and not stage.bench.session.history
        stage.engine.gate.set()


async def test_a_text_sent_while_a_turn_runs_stays_typed(stage):
    stage.engine.gate, stage.engine.gated_at = threading.Event(), "write"
    async with stage.make().run_test(size=(140, 45)) as pilot:
        await stage.ready(pilot)
        await stage.say(pilot, CUT_IN, wait=False)
        await stage.until(pilot, lambda: stage.busy)
        await stage.say(pilot, "What is a cut-in?", wait=False)
        await stage.until(pilot, lambda: stage.bench.chat.entry.text == "What is a cut-in?")
        stage.engine.gate.set()
        await stage.idle(pilot)
        assert stage.engine.calls[0] == ("say", CUT_IN) and ("say", "What is a cut-in?") not in stage.engine.calls


def test_a_failing_engine_is_one_sentence_in_the_chat(stage, compare):
    stage.engine.scripts["Fail."] = Script(fail="The model qwen3 is not there: pull it with /model\nTraceback...")

    async def flow(pilot):
        await stage.say(pilot, "Fail.")
        assert stage.said[-1] == "The model qwen3 is not there: pull it with /model"
        assert not stage.busy

    assert compare(flow)


def test_search_and_use_a_result(stage, compare):
    stage.engine.passages = [
        Passage(kind="doc", title="UN R157", clause="4.5", text=CUT_IN, score=0.9, source="un-r157.md"),
        Passage(kind="doc", title="UN R152", clause="6.5", text="A car [stands].", score=0.7, source="r152.md"),
    ]  # fmt: skip

    async def flow(pilot):
        await stage.say(pilot, "/search a vehicle cuts in")
        await stage.until(pilot, lambda: stage.bench.query("Sources"))
        assert ("search", "a vehicle cuts in") in stage.engine.calls
        await stage.say(pilot, "/use 9", wait=False)
        await stage.until(pilot, lambda: "Give a number: /use 1 to /use 2." in stage.said)
        await stage.say(pilot, "/use 1", wait=False)
        await stage.until(pilot, lambda: stage.bench.chat.entry.text == f"[UN R157, 4.5] {CUT_IN}")
        await pilot.press("enter")
        await stage.until(pilot, lambda: stage.bench.desk.program.text and not stage.busy)
        assert "O1" in stage.bench.desk.structure

    assert compare(flow)


def test_an_unknown_command_is_answered(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, "/modal")
        assert stage.said[-1].startswith("There is no command /modal. Did you mean /model")

    assert compare(flow, size=(80, 24))
