"""The planner's search as a step of a turn: what S leaves open is chosen so that the run shows what is required."""

import time
from typing import Any

from c2s_engine.session import steps
from c2s_engine.session.places import map_choice
from c2s_engine.session.requiring import judged
from c2s_engine.session.steps import Emit, Tools
from c2s_engine.session.trying import Tried
from c2s_engine.solve import Outcome, solve
from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import RunFacts
from c2s_engine.structure.progress import StageDone, StageStarted
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.write.typed import TypedWriter

AFTER_EDIT = {"most": 3}
"""How far is searched after an edit: its verdict is waited for."""


def can_solve(state: dict[str, Any], tools: Tools) -> bool:
    """Whether a program ran that does not show all that is required, and anything is open that might mend it.

    After an edit only where it reached more than the settings.
    """
    facts = state.get("report", {}).get("facts", [])
    ran = bool(facts) and any(RunFacts.model_validate(f).ran for f in facts)
    reached = _is_new(state) or any(c != "G" for c in state.get("rewritten", []))
    return tools.settings.solve and ran and reached and not all(r["holds"] for r in state.get("results", []))


def _is_new(state: dict[str, Any]) -> bool:
    """Whether S is a new one, read from a text or given, rather than an edited one."""
    return bool(state.get("text") or state.get("given"))


async def solved(state: dict[str, Any], tools: Tools, emit: Emit) -> dict[str, Any]:
    """What changes of the state: the best that was found. The events of what was tried are not shown."""
    chosen = map_choice(tools.library, tools.library.find(state["map_name"]))
    room, seed = state["room"], state.get("seed", 0)
    writer = TypedWriter(chosen, room=room)

    async def tried(structure: Structure, runs: int) -> Outcome | None:
        structure, program, written, result = steps.write(structure, [], writer, steps.silent)
        if not result.ok:
            return None
        report = await steps.check(
            program, tools, steps.silent, folder=state["folder"], upto="run", seed=seed, runs=runs, trajectories=True
        )
        if not report.ok or not any(f.ran for f in report.facts):
            return None
        found = await judged(structure, report, tools, map_name=state["map_name"], room=room, seed=seed)
        kept = Tried(structure, program, written, [result], report, found, {})
        return Outcome(structure, found.requirements, found.results, kept)

    emit(StageStarted(stage="solve"))
    started = time.perf_counter()
    first = Outcome(
        Structure.model_validate(state["structure"]),
        tuple(Requirement.model_validate(r) for r in state["requirements"]),
        tuple(Result.model_validate(r) for r in state["results"]),
    )
    best = await solve(first, lambda s: tried(s, 1), room, **({} if _is_new(state) else AFTER_EDIT))
    if best is not first and state.get("runs", 1) > 1:
        best = await tried(best.structure, state["runs"]) or first
    result = steps.timed("solve", started)
    emit(StageDone(result=result))
    stages = [*state["stages"], result.model_dump(mode="json")]
    if best.score <= first.score:
        return {"stages": stages}
    kept: Tried = best.kept
    kept.show(emit, tracks=state.get("trajectories", False))
    return kept.update({**state, "stages": stages}, upto=("interpret", "resolve", "solve"))
