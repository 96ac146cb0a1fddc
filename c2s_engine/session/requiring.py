"""The requirements of S and what the runs of its program showed of them; the run with ego's reaction switched off."""

import asyncio
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from c2s_engine.check.protocol import CheckReport, Upto
from c2s_engine.session import steps
from c2s_engine.session.places import map_choice
from c2s_engine.session.steps import Emit, Tools
from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import Trajectories
from c2s_engine.structure.measures import Measures
from c2s_engine.structure.program import Program, assemble, run_limit
from c2s_engine.structure.requirements import Requirement, Result, Run
from c2s_engine.structure.specs import RestrictionsSpec
from c2s_engine.write.typed import TypedWriter

LONGEST = 20.0
"""s for which the run without ego's reaction goes on."""
KEPT = 8
"""Programs whose runs without ego's reaction are kept: one that only ends at another time has the same."""


@dataclass(frozen=True)
class Judged:
    """What S requires, and of each the result that most runs showed; `whole`: the share of the runs that showed all."""

    requirements: tuple[Requirement, ...] = ()
    results: tuple[Result, ...] = ()
    whole: float = 0.0
    runs: tuple[Run, ...] = ()
    without: tuple[Run, ...] = ()  # the same without ego's reaction, where S says a conflict

    @cached_property
    def measures(self) -> tuple[Measures, ...]:
        """Those of each run that has tracks, made when they are asked for: the search's trials need none."""
        from c2s_engine.require.measured import measured

        return tuple(measured(run.facts, run.trajectories) for run in self.runs if run.trajectories.tracks)

    def as_state(self) -> dict[str, Any]:
        """As plain data for the graph's state."""
        return {
            "requirements": [r.model_dump(mode="json") for r in self.requirements],
            "results": [r.model_dump(mode="json") for r in self.results],
            "measures": [m.model_dump(mode="json") for m in self.measures],
        }


async def check_and_judge(structure: Structure, program: Program, tools: Tools, emit: Emit, *, map_name: str,
                          room: float, folder: str, upto: Upto = "run", seed: int = 0, runs: int = 1,
                          trajectories: bool = True) -> tuple[CheckReport, Judged]:  # fmt: skip
    """Check a program and judge its runs by S; the runs without ego's reaction are made beside."""
    beside = asyncio.create_task(
        _without_reaction(structure, tools, map_name=map_name, room=room, seed=seed, runs=runs,
                          seconds=run_limit(program.text, LONGEST))
    ) if upto == "run" else None  # fmt: skip
    try:
        report = await steps.check(program, tools, emit, folder=folder, upto=upto, seed=seed, runs=runs,
                                   trajectories=trajectories)  # fmt: skip
        without = await beside if beside is not None and report.facts else []
    finally:
        if beside is not None:
            beside.cancel()
    found = by_its_runs(structure, runs_of(report), without)
    tools.seen = program.text, found
    return report, found


async def judged(structure: Structure, report: CheckReport, tools: Tools, *, map_name: str, room: float = 1.0,
                 seed: int = 0) -> Judged:  # fmt: skip
    """Derive and evaluate; nothing where nothing ran. `report` holds the trajectories of its runs."""
    if not report.facts:
        return Judged()
    longest = max(LONGEST, *(f.duration for f in report.facts))
    without = await _without_reaction(structure, tools, map_name=map_name, room=room, seed=seed,
                                      runs=len(report.facts), seconds=longest)  # fmt: skip
    return by_its_runs(structure, runs_of(report), without)


def by_its_runs(structure: Structure, runs: Sequence[Run], without: Sequence[Run]) -> Judged:
    """What runs showed of what S requires; `without`: each of them without ego's reaction."""
    from c2s_engine.require import evaluate, majority, require, whole

    if not runs:
        return Judged()
    requirements = require(structure)
    columns = [
        evaluate(requirements, run.facts, run.trajectories, without[k] if k < len(without) else None)
        for k, run in enumerate(runs)
    ]
    share = sum(map(whole, columns)) / len(columns)
    return Judged(requirements, majority(columns), share, tuple(runs), tuple(without))


async def _without_reaction(structure: Structure, tools: Tools, *, map_name: str, room: float, seed: int,
                            runs: int, seconds: float) -> list[Run]:  # fmt: skip
    """The same scenes with ego's reaction switched off, where S says a conflict and ego's code is written from S."""
    from c2s_engine.require import without_reaction

    if not structure.ego.recognised or (changed := without_reaction(structure)) is None:
        return []
    chosen = map_choice(tools.library, tools.library.find(map_name))
    writer = TypedWriter(chosen, room=room)
    if changed.ego.origin != "rendered":  # its own code, though it says the same, would be kept, with the reaction
        changed = changed.with_component(changed.ego.model_copy(update={"origin": "rendered", "key": ""}))
    ego, going_on = (steps.write(each, [], writer, steps.silent) for each in (changed, _going_on(structure, seconds)))
    if not (ego[3].ok and going_on[3].ok):
        return []
    # all others start and drive as in the scene that is judged, for as long as it takes to see what comes of it
    blind = assemble(structure.with_component(ego[0].ego).with_component(going_on[0].restrictions))
    key = blind.text, str(chosen.path), seed, runs
    if key not in tools.blind:
        report = await steps.check(blind, tools, steps.silent, folder=str(chosen.path.parent), upto="run", seed=seed,
                                   runs=runs, trajectories=True)  # fmt: skip
        tools.blind[key] = runs_of(report)
        while len(tools.blind) > KEPT:
            tools.blind.pop(next(iter(tools.blind)))
    return tools.blind[key]


def _going_on(structure: Structure, seconds: float) -> Structure:
    """S whose run does not end with what is said."""
    restrictions = structure.restrictions
    assert isinstance(restrictions.spec, RestrictionsSpec)
    spec = restrictions.spec.model_copy(update={"terminate_when": (), "duration": round(seconds, 1)})
    changed = restrictions.model_copy(update={"spec": spec})
    return structure.with_component(changed) if restrictions.origin == "rendered" else structure


def runs_of(report: CheckReport) -> list[Run]:
    """The report's runs with their tracks; one that broke off before anything moved has none."""
    ways = iter(report.trajectories)
    none = Trajectories(step=0.1, tracks=())
    return [Run(facts=f, trajectories=next(ways, none) if f.objects else none) for f in report.facts]
