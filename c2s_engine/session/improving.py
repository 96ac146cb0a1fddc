"""Simulation in the loop as a step of a turn: what the runs did not show of S goes back to the model."""

from collections import Counter
from dataclasses import replace
from typing import Any

from c2s_engine.config import METHOD, WITHOUT_MODEL
from c2s_engine.models.errors import ModelError
from c2s_engine.session import steps
from c2s_engine.session.model_methods import ModelMethod
from c2s_engine.session.requiring import Judged, check_and_judge
from c2s_engine.session.steps import Emit, Tools
from c2s_engine.session.trying import Tried
from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import RunFacts
from c2s_engine.structure.progress import Progress, Say, StageStarted, Token, Usage
from c2s_engine.structure.requirements import Requirement, Result, failures, tally
from c2s_engine.write.loop import Outcome

MENDABLE = ("phase", "order", "place", "outcome", "conflict")
"""The kinds of requirements that an edit of S can bring about; the others are the writer's to keep."""


def can_improve(state: dict[str, Any]) -> bool:
    """Whether the loop was asked for, and the runs of a program that ran left something to show."""
    if not state.get("improve") or (state.get("method") or METHOD) in WITHOUT_MODEL:
        return False
    facts = tuple(RunFacts.model_validate(f) for f in state.get("report", {}).get("facts", []))
    return any(f.ran for f in facts) and bool(_of_state(state).differences)


async def improved(state: dict[str, Any], tools: Tools, method: ModelMethod, emit: Emit) -> dict[str, Any]:
    """What changes of the state: the best of what was tried, and what trying cost. The events between are not shown."""
    first = Structure.model_validate(state["structure"])
    tried: list[Tried] = []

    def quietly(event: Progress) -> None:
        if isinstance(event, Token | Usage | StageStarted):
            emit(event)

    async def evaluate(structure: Structure) -> Outcome:
        if structure is first:
            return replace(_of_state(state), structure=first)
        found = await _tried(state, structure, tools, method, quietly)
        tried.append(found)
        return _outcome(found.structure, found.report.facts, found.judged)

    emit(Say(text="The run misses some requirements of the text: asking the model for a correction."))
    try:
        best = await method.improve(first, evaluate, emit)
    except ModelError as error:
        emit(Say(text=f"The model's correction failed. {error}", severity="warning"))
        return {"details": _details(state, method, first)}
    kept = next((t for t in tried if t.structure is best.structure), None)
    if kept is None:
        return {"details": _details(state, method, first)}
    kept.show(emit)
    return {**kept.update(state), "details": _details(state, method, kept.structure)}


async def _tried(state: dict[str, Any], structure: Structure, tools: Tools, method: ModelMethod, emit: Emit) -> Tried:
    """Write and run an S; raises ValueError with the reason where it cannot be written."""
    structure, found, resolved = await steps.configure(
        structure, tools, emit, given=state.get("map"), needed=method.needs_place
    )
    if found.writer is None:
        raise ValueError(found.diagnostic.message if found.diagnostic else "no map has the place.")
    chosen = found.writer.map
    folder = str(chosen.path.parent)
    structure, program, written, result = await method.write(
        structure, emit, map_name=chosen.name, room=found.writer.room, folder=folder
    )
    if not result.ok:
        raise ValueError(result.diagnostics[0].message)
    report, found_of = await check_and_judge(
        structure, program, tools, emit, map_name=chosen.name, room=found.writer.room, folder=folder,
        seed=state.get("seed", 0), runs=state.get("runs", 1), trajectories=state.get("trajectories", False),
    )  # fmt: skip
    where = {"folder": folder, "room": found.writer.room, "map_name": chosen.name, "places": found.count}
    return Tried(structure, program, written, [resolved, result], report, found_of, where)


def _outcome(structure: Structure, facts: tuple[RunFacts, ...], found: Judged) -> Outcome:
    """The share of what S says of its actors that was seen; a program that does not run is worse than any that does."""
    asked = tuple(r for r in found.requirements if r.kind in MENDABLE)
    ids = {r.id for r in asked}
    held, of = tally([r for r in found.results if r.requirement in ids])
    score = (held / of if of else 1.0) if any(f.ran for f in facts) else -1.0
    return Outcome(structure, score, failures(asked, found.results))


def _of_state(state: dict[str, Any]) -> Outcome:
    """What the turn's own runs showed."""
    facts = tuple(RunFacts.model_validate(f) for f in state.get("report", {}).get("facts", []))
    found = Judged(
        tuple(Requirement.model_validate(r) for r in state.get("requirements", [])),
        tuple(Result.model_validate(r) for r in state.get("results", [])),
    )
    return _outcome(Structure.model_validate(state["structure"]), facts, found)


def _details(state: dict[str, Any], method: ModelMethod, structure: Structure) -> dict[str, Any]:
    return summed(state.get("details", {}), method.account(structure))


def summed(details: dict[str, Any], more: dict[str, Any]) -> dict[str, Any]:
    """A turn's details with what a further step of it cost."""
    usage = Counter(details.get("usage", {})) + Counter(more.get("usage", {}))
    tokens = details.get("tokens", 0) + more.get("tokens", 0)
    return {**details, **more, "tokens": tokens, **({"usage": dict(usage)} if usage else {})}
