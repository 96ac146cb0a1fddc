"""The engine's steps as plain functions: interpret, configure, write, check. The graph's nodes are thin over them."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from c2s_engine.check.client import CheckClient, CheckError
from c2s_engine.check.protocol import CheckReport, CheckRequest, Limits, Upto
from c2s_engine.config import Settings
from c2s_engine.maps.library import SHIPPED, MapLibrary
from c2s_engine.session.places import Resolution, map_choice, resolve
from c2s_engine.session.settle import settle, strictly
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.diagnostics import Diagnostic, StageResult
from c2s_engine.structure.edits import Edit, EditError, apply
from c2s_engine.structure.program import Program, assemble, run_limit
from c2s_engine.structure.progress import ComponentState, ProgramChanged, Progress, RunDone, StageDone, StageStarted
from c2s_engine.structure.regenerate import FragmentWriter, dirty, regenerate
from c2s_engine.structure.requirements import Run
from c2s_engine.write.by_hand import with_offers
from c2s_engine.write.typed import TypedWriter

if TYPE_CHECKING:
    from c2s_engine.session.requiring import Judged

Emit = Callable[[Progress], None]


@dataclass
class Tools:
    """What the steps work with."""

    settings: Settings
    library: MapLibrary
    check: CheckClient
    extra: dict[str, Any] = field(default_factory=dict)
    blind: dict[tuple[str, str, int, int], list[Run]] = field(default_factory=dict)
    """The last runs without ego's reaction, by program, map, seed and count."""
    seen: "tuple[str, Judged] | None" = None
    """The program that was judged last, and what its runs showed."""


def silent(event: Progress) -> None:
    """What is tried, or only serves to judge something else, is not shown."""


def timed(name: Any, started: float, diagnostics: tuple[Diagnostic, ...] = ()) -> StageResult:
    ok = not any(d.severity == "error" for d in diagnostics)
    return StageResult(name=name, ok=ok, seconds=round(time.perf_counter() - started, 4), diagnostics=diagnostics)


async def configure(
    structure: Structure, tools: Tools, emit: Emit, *, given: str | None, needed: bool = True, lenient: bool = False,
    strict: bool = False,
) -> tuple[Structure, Resolution, StageResult]:
    """Choose the map and resolve the place on it; what was chosen for want of words goes to G's `assumed`.

    `lenient`: S was read from a text, so that fields of R which cannot be had are left open rather than refused, and
    speeds lowered for which roads have no room; `strict`: both are refused.
    Methods that do not render specs need no place (`needed`): for them a map is enough.
    """
    emit(StageStarted(stage="resolve"))
    started = time.perf_counter()
    try:
        look = settle if lenient else strictly if strict else _as_it_is
        structure, found = await look(structure, tools.library, tools.check, given=given, default=tools.settings.map)
    except CheckError as error:
        found = Resolution(None, diagnostic=Diagnostic(stage="resolve", message=str(error), code="check-server"))
    if found.writer is None and not needed:
        found = Resolution(TypedWriter(map_choice(tools.library, tools.library.find(given or SHIPPED))))
    result = timed("resolve", started, (found.diagnostic,) if found.diagnostic else ())
    emit(StageDone(result=result))
    settings = structure.settings
    assumed = tuple(a for a in settings.assumed if a.field != "map") + found.assumed
    if assumed != settings.assumed:
        structure = structure.with_component(settings.model_copy(update={"assumed": assumed}))
    return structure, found, result


async def _as_it_is(structure: Structure, *args: Any, **options: Any) -> tuple[Structure, Resolution]:
    return structure, await resolve(structure, *args, **options)


def write(
    structure: Structure, edits: list[Edit], writer: FragmentWriter, emit: Emit
) -> tuple[Structure, Program, list[ComponentId], StageResult]:
    """Apply edits, write anew what is dirty, offer what would be written beside code by hand, assemble."""
    emit(StageStarted(stage="write"))
    started = time.perf_counter()
    try:
        after = structure
        for edit in edits:
            after = apply(after, edit)
        for cid in dirty(after, writer):
            emit(ComponentState(component=after[cid], state="writing"))
        structure, written = regenerate(structure, edits, writer, lambda c: emit(_state(c)))
        structure = with_offers(structure, writer)
        if isinstance(writer, TypedWriter):
            structure = writer.decided(structure)
    except (EditError, ValueError) as error:
        result = timed("write", started, (Diagnostic(stage="write", message=str(error), code="edit"),))
        emit(StageDone(result=result))
        return structure, assemble(structure), [], result
    program = assemble(structure)
    result = timed("write", started)
    emit(StageDone(result=result))
    emit(ProgramChanged(program=program, rewritten=tuple(written)))
    return structure, program, written, result


def _state(component: Component) -> ComponentState:
    return ComponentState(component=component, state="by_hand" if component.origin == "by_hand" else "clean")


async def check(
    program: Program,
    tools: Tools,
    emit: Emit,
    *,
    folder: str,
    upto: Upto,
    seed: int,
    runs: int,
    trajectories: bool,
    trust: bool = False,
) -> CheckReport:
    """Check the assembled program in the check server, on the map that it names.

    The report of a run has its trajectories, for the requirements; the events carry them where they are asked for.
    """
    request = CheckRequest(
        program=program.text,
        folder=folder,
        spans=program.spans,
        upto=upto,
        seed=seed,
        runs=runs,
        seconds=run_limit(program.text, tools.settings.seconds),
        trajectories=trajectories or upto == "run",
        trust=trust,
        allow=tools.settings.allow,
        limits=Limits(wall=60.0 + 30.0 * runs, cpu=60.0 + 30.0 * runs),
    )
    emit(StageStarted(stage="compile"))
    try:
        report = await tools.check.check(request)
    except CheckError as error:
        failed = Diagnostic(stage="compile", message=str(error), code="check-server")
        report = CheckReport(stages=(StageResult(name="compile", ok=False, diagnostics=(failed,)),))
    for stage in report.stages:
        emit(StageDone(result=stage))
    for i, facts in enumerate(report.facts):
        shown = trajectories and i < len(report.trajectories)
        emit(RunDone(facts=facts, trajectories=report.trajectories[i] if shown else None))
    return report
