"""The planner's search as a step of a turn: what S leaves open is chosen so that the run shows what is required."""

import time
from typing import Any

from c2s_engine.session import steps
from c2s_engine.session.places import map_choice
from c2s_engine.session.requiring import Judged, by_its_runs, check_and_judge
from c2s_engine.session.steps import Emit, Tools
from c2s_engine.session.trying import Tried
from c2s_engine.solve import Outcome, solve, widened
from c2s_engine.solve.search import MOST
from c2s_engine.solve.shortened import ended_earlier
from c2s_engine.solve.widening import RUNS
from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import RunFacts
from c2s_engine.structure.progress import StageDone, StageStarted
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.write.typed import TypedWriter

AFTER_EDIT = 3
"""Runs that the search may cost after an edit: its verdict is waited for."""


def can_solve(state: dict[str, Any], tools: Tools) -> bool:
    """Whether a program ran that does not show all that is required, or is to be varied, and anything is open.

    After an edit only where it reached more than the settings.
    """
    facts = state.get("report", {}).get("facts", [])
    ran = bool(facts) and any(RunFacts.model_validate(f).ran for f in facts)
    reached = _is_new(state) or any(c != "G" for c in state.get("rewritten", []))
    asked = state.get("widen") or not all(r["holds"] for r in state.get("results", []))
    return tools.settings.solve and ran and reached and bool(asked)


def _is_new(state: dict[str, Any]) -> bool:
    """Whether S is a new one, read from a text or given, rather than an edited one."""
    return bool(state.get("text") or state.get("given"))


class Trials:
    """Changed structures, written, run and judged in a turn's place and on its map. Nothing of it is shown."""

    def __init__(self, state: dict[str, Any], tools: Tools, emit: Emit, most: int):
        self.state, self.tools, self.emit, self.most = state, tools, emit, most
        self.count = 0
        self.writer = TypedWriter(map_choice(tools.library, tools.library.find(state["map_name"])), room=state["room"])
        self.seen: list[tuple[Structure, Judged]] = []
        if tools.seen is not None and tools.seen[0] == state.get("program", {}).get("text"):
            self.seen.append((Structure.model_validate(state["structure"]), tools.seen[1]))

    async def foreseen(self, structure: Structure) -> Outcome | None:
        """What it comes to; where it only ends earlier than what ran, what that shows by then: nothing is kept."""
        for other, found in self.seen:
            if runs := ended_earlier(structure, other, found.runs):
                by_then = by_its_runs(structure, runs, found.without)
                return Outcome(structure, by_then.requirements, by_then.results)
        return await self.run(structure)

    async def run(self, structure: Structure, runs: int = 1) -> Outcome | None:
        """What it comes to; None where it does not run."""
        state, seed = self.state, self.state.get("seed", 0)
        self.count += 1
        if self.count <= self.most:
            self.emit(StageStarted(stage="solve", run=self.count, most=self.most))
        structure, program, written, result = steps.write(structure, [], self.writer, steps.silent)
        if not result.ok:
            return None
        report, found = await check_and_judge(
            structure, program, self.tools, steps.silent, map_name=state["map_name"], room=state["room"],
            folder=state["folder"], seed=seed, runs=runs,
        )  # fmt: skip
        if not report.ok or not any(f.ran for f in report.facts):
            return None
        self.seen.append((structure, found))
        kept = Tried(structure, program, written, [result], report, found, {})
        return Outcome(structure, found.requirements, found.results, kept)


async def solved(state: dict[str, Any], tools: Tools, emit: Emit) -> dict[str, Any]:
    """What changes of the state: the best that was found, varied where that was asked for."""
    room, runs = state["room"], state.get("runs", 1)
    trials = Trials(state, tools, emit, MOST if _is_new(state) else AFTER_EDIT)
    emit(StageStarted(stage="solve"))
    started = time.perf_counter()
    first = Outcome(
        Structure.model_validate(state["structure"]),
        tuple(Requirement.model_validate(r) for r in state["requirements"]),
        tuple(Result.model_validate(r) for r in state["results"]),
    )
    best = await _found(first, trials, room)
    if state.get("widen") and not best.failing:
        best = await _varied(best, trials, room, runs)
    elif best is not first and runs > 1:
        best = await trials.run(best.structure, runs) or first
    result = steps.timed("solve", started)
    emit(StageDone(result=result))
    stages = [*state["stages"], result.model_dump(mode="json")]
    if best.kept is None or best.score < first.score:
        return {"stages": stages}
    kept: Tried = best.kept
    kept.show(emit, tracks=state.get("trajectories", False))
    return kept.update({**state, "stages": stages}, upto=("interpret", "resolve", "solve"))


async def _found(first: Outcome, trials: Trials, room: float) -> Outcome:
    """The best that the search finds, run; where it does not show what was foreseen, found by runs alone."""
    best = await solve(first, trials.foreseen, room, most=trials.most)
    if best is first or best.kept is not None:
        return best
    ran = await trials.run(best.structure)
    if ran is not None and ran.score >= best.score:
        return ran
    return await solve(first, trials.run, room, most=trials.most)


async def _varied(best: Outcome, trials: Trials, room: float, runs: int) -> Outcome:
    """The same with ranges for what was left open; itself where none hold."""

    async def share_whole(structure: Structure) -> float:
        found = await trials.run(structure, RUNS)
        return 0.0 if found is None else found.kept.judged.whole

    changed = await widened(best.structure, room, share_whole)
    return best if changed is best.structure else await trials.run(changed, runs) or best
