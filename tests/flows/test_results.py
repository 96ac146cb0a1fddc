"""The outcome of a run in sight: in status, chat and S, and in the results pane with a series of seeds."""

import asyncio
import threading
from dataclasses import replace

from scripted_engine import CUT_IN, Script

from c2s_engine.structure.components import Assumption, Component, Structure, Unmet
from c2s_engine.structure.diagnostics import StageResult
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import EgoSpec, ObjectSpec
from c2s_tui.desk import Desk, begun
from c2s_tui.results.plot import Curve, plot
from c2s_tui.summary import summary


def report(stage) -> str:
    """What the results pane shows, as plain text."""
    return stage.bench.results.query_one("#report").content.plain


async def test_a_collision_that_nobody_asked_for_is_said_everywhere(stage):
    stage.engine.collides = True
    said = "COLLISION ego-van at 6.3 s, not in the text"
    async with stage.described() as pilot:
        assert stage.said[-1].startswith(said)
        assert said in stage.bench.query_one("#status").content.plain
        hits = [row for row in stage.bench.sheet.rows if row.kind == "hit"]
        assert [(r.cid, r.text) for r in hits] == [
            ("E", "COLLISION with van at 6.3 s, not in the text"),
            ("O1", "COLLISION with ego at 6.3 s, not in the text"),
        ]
        await pilot.press("f6")
        await stage.until(pilot, lambda: "Gaps to ego" in report(stage))
        assert said in report(stage) and "Requirements that are not met: 1" in report(stage)


async def test_results_are_those_of_the_program_on_the_screen(stage):
    stage.engine.scripts["Unreadable."] = Script(fail="c2s failed at this text")
    async with stage.described() as pilot:
        await pilot.press("f6")
        await stage.until(pilot, lambda: "3 of 3 requirements met" in report(stage))
        await stage.say(pilot, "Unreadable.")
        assert "3 of 3 requirements met" in report(stage)  # nothing was changed: they still are
        await stage.bench.run_command("results", "close")
        await stage.bench.run_command("new", "other")
        await stage.until(pilot, lambda: stage.bench.session.name == "other")
        assert "requirements met" not in stage.bench.query_one("#status").content.plain
        stage.engine.gate, stage.engine.gated_at = threading.Event(), "write"
        await stage.say(pilot, CUT_IN, wait=False)
        await stage.until(pilot, lambda: stage.bench.desk.structure.text)
        await stage.bench.run_command("results", "")
        assert "requirements met" not in report(stage)
        await stage.until(pilot, lambda: "A new program is being made" in report(stage))
        assert "requirements met" not in stage.bench.query_one("#status").content.plain
        stage.engine.gate.set()
        await stage.idle(pilot)
        await stage.until(pilot, lambda: "3 of 3 requirements met" in report(stage))


async def test_another_run_is_shown_from_its_outcome_on(stage):
    async with stage.described((140, 24)) as pilot:
        await pilot.press("f6")
        await stage.until(pilot, lambda: "Gaps to ego" in report(stage) and stage.bench.results.max_scroll_y > 0)
        await pilot.press("end")
        await stage.until(pilot, lambda: stage.bench.results.scroll_y > 0)
        await pilot.press("f5")
        await stage.until(pilot, lambda: not stage.busy and stage.bench.results.scroll_y == 0)


def test_the_results_of_a_run(stage, compare):
    async def flow(pilot):
        await stage.say(pilot, CUT_IN)
        await pilot.press("f6")  # in the chat's line, whose F6 would select a line
        await stage.until(pilot, lambda: "Gaps to ego" in report(stage))
        shown = report(stage)
        assert "no collision" in shown and "bumper to bumper" in shown and "cuts in ahead of ego" in shown
        assert "Requirements that are met: 3" in shown

    assert compare(flow)


def test_seeds_fill_a_table_and_a_cancelled_series_keeps_its_rows(stage, compare):
    async def flow(pilot):
        stage.engine.gate, stage.engine.gated_at = asyncio.Event(), "seeds"
        await stage.say(pilot, CUT_IN)
        await stage.say(pilot, "/seeds 6", wait=False)
        await stage.until(pilot, lambda: "Seeds: 2 of 6 run, 2 passed" in report(stage))
        await pilot.press("escape")
        await stage.until(pilot, lambda: not stage.busy)
        assert len(stage.bench.desk.seeds) == 2 and stage.bench.results.has_class("-on")
        stage.engine.gate.set()
        await pilot.press("s")
        await stage.until(pilot, lambda: len(stage.bench.desk.seeds) == 20 and not stage.busy)
        assert "Seeds: 20 of 20 run, 14 passed, 6 failed" in report(stage)
        assert any("14 of 20 seeds passed" in line for line in stage.said)

    assert compare(flow, size=(100, 40))


async def test_no_number_of_seeds_is_one_sentence(stage):
    async with stage.described() as pilot:
        await stage.say(pilot, "/seeds many")
        assert stage.said[-1].startswith("many is not a number of seeds: give 20")
        await stage.say(pilot, "/seeds 0")
        assert stage.said[-1] == "A series has 1 to 500 seeds, not 0."


async def test_words_that_make_no_difference_are_named_once(stage):
    stage.engine.idle = (Unmet(text="red", reason="S would be the same without it", span=(2, 5)),)
    async with stage.described() as pilot:
        of = "Of “Ego drives at 50 km/h in the right lane of a two-lane road ...”"
        await stage.until(pilot, lambda: f"{of}: Nothing in S says: “red”." in stage.said)
        await stage.say(pilot, "/seeds 1")
        assert sum("Nothing in S says" in line for line in stage.said) == 1


async def test_a_clause_that_makes_no_difference_is_counted_in_the_line_that_closed_the_turn(stage):
    sentence = CUT_IN.split(". ")[1]
    span = (CUT_IN.index(sentence), len(CUT_IN))
    stage.engine.idle = (Unmet(text=sentence, reason="S would be the same without it", span=span),)
    async with stage.described() as pilot:
        lost = "1 clause of the text is not fully in S"
        await stage.until(pilot, lambda: any("3 of 3 requirements met" in line and lost in line for line in stage.said))
        assert "3 of 3 requirements met; 1 clause lost" in stage.bench.query_one("#status").content.plain


async def test_words_of_a_turn_before_are_not_named_below_a_newer_one(stage):
    looked = asyncio.Event()

    async def without_effect(text, structure, before=None):
        while not looked.is_set():  # set from another thread's loop
            await asyncio.sleep(0.01)
        return (Unmet(text="red", reason="S would be the same without it", span=(2, 5)),)

    stage.engine.without_effect = without_effect
    async with stage.described() as pilot:
        await stage.say(pilot, "What is a cut-in?")
        looked.set()
        await stage.until(pilot, lambda: not any(w.group == "no_effect" for w in stage.bench.workers))
        assert not any("would be the same" in line for line in stage.said)


async def test_escape_closes_the_results_first_and_lets_the_turn_go_on(stage):
    async with stage.described() as pilot:
        await pilot.press("f6")
        await stage.until(pilot, lambda: stage.bench.results.has_focus)
        stage.engine.gate, stage.engine.gated_at = threading.Event(), "say"
        await stage.say(pilot, "What is a cut-in?", wait=False)
        await stage.until(pilot, lambda: stage.busy)
        stage.bench.results.focus()
        await pilot.press("escape")
        await stage.until(pilot, lambda: not stage.bench.results.has_class("-on"))
        assert stage.busy
        stage.engine.gate.set()
        await stage.idle(pilot)
        assert not any(line.startswith("Cancelled") for line in stage.said)


async def test_what_contradicts_is_said_where_not_all_is_shown(stage):
    async with stage.described() as pilot:
        await stage.say(pilot, "/contradictions")
        assert stage.said[-1] == "All requirements were met: nothing contradicts."
    stage.engine.collides = True
    async with stage.described() as pilot:
        await stage.say(pilot, "/contradictions")
        await stage.until(pilot, lambda: "Any one of these changes resolves it" in stage.said[-1])
        assert "E speed 50 km/h, O1 gap 5 m" in stage.said[-1]
        stage.engine.gate, stage.engine.gated_at = asyncio.Event(), "contradictions"
        await stage.say(pilot, "/contradictions", wait=False)
        await stage.until(pilot, lambda: "1 found" in stage.bench.query_one("#status").content.plain)
        await pilot.press("escape")
        await stage.until(pilot, lambda: not stage.bench.turns.busy)


def test_a_plot_has_its_greatest_value_on_top_and_joins_its_dots():
    drawn = plot([Curve([0.0, 5.0, 10.0], "red")], 2.0, 26, 4, "m").plain.split("\n")
    assert drawn[0].startswith("   10 ") and drawn[-1].endswith("2.0 s")
    columns = [any(line[i : i + 1] not in ("", " ") for line in drawn[:-1]) for i in range(6, 26)]
    assert all(columns), "every column has a dot"
    assert plot([], 2.0, 26, 4, "m").plain == "" and plot([Curve([1, 2], "red")], 2, 10, 4, "m").plain == ""


def test_what_was_given_up_stands_beside_the_requirements():
    notes = (Assumption(field="speed", value="91 km/h", reason="the roads have no more room", was="130 km/h"),
             Assumption(field="reaction", value="brake", reason="the text does not say"))  # fmt: skip
    structure = Structure(ego=Component(id="E", spec=EgoSpec(), assumed=notes))
    ran = StageResult(name="run", ok=True)
    met = (Result(requirement="1", holds=True, robustness=1.0),)
    desk = Desk(structure=structure, stages=(ran,), results=met, rewritten=("E",))
    said, kind = summary(desk)
    assert said == "E written; runs; 1 of 1 requirements met; changed from the text: E speed 130 km/h -> 91 km/h"
    assert kind == "warning"


def test_requirements_that_are_no_longer_made_are_told():
    def asked(*components: str) -> tuple[Requirement, ...]:
        return tuple(Requirement(id=f"{c}.{i}", kind="phase", component=c, text="c", check="shown")
                     for i, c in enumerate(components))  # fmt: skip

    structure = Structure(objects=(Component(id="O1", spec=ObjectSpec(name="van"), origin="by_hand"),))
    met = (Result(requirement="O1.0", holds=True, robustness=1.0),)
    before = asked("O1", "O1", "E", "O2")
    desk = Desk(structure=structure, results=met, requirements=asked("O1"), required_before=before)
    said, _ = summary(desk)
    assert "1 of 1 requirements met (1 fewer of E, 1 fewer of O1 than before; of O1, by hand, only what is" in said
    more = replace(desk, required_before=(), requirements=asked("O1", "E"))
    assert "fewer" not in summary(more)[0]
    assert "fewer" not in summary(replace(desk, text_before="Another description."))[0]
    failed = replace(begun(replace(desk, requirements=before)), requirements=())  # its program did not parse
    assert "1 fewer of E" in summary(replace(begun(failed), requirements=asked("O1"), stale=False))[0]


async def test_f6_brings_results_that_are_behind_another_pane(stage):
    async with stage.described(size=(80, 24)) as pilot:
        await pilot.press("f6")
        await stage.until(pilot, lambda: stage.bench.room.current_pane == "results")
        await pilot.press("f2")
        await stage.until(pilot, lambda: stage.bench.room.current_pane == "chat")
        await pilot.press("f6")
        await stage.until(pilot, lambda: stage.bench.results.has_focus and "requirements met" in report(stage))
        await pilot.press("f6")
        await stage.until(pilot, lambda: not stage.bench.results.has_class("-on"))
        assert stage.bench.room.current_pane == "code"
