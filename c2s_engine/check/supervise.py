"""One request from beginning to end: read, find a warm process, fork, watch the limits, gather the report."""

import asyncio
import contextlib
import os
import re
import signal
import time
from pathlib import Path
from typing import Any

from c2s_engine import driving
from c2s_engine.check import beside, wire
from c2s_engine.check.pool import Pool, TooSlow
from c2s_engine.check.processes import Child, Zygote
from c2s_engine.check.protocol import (
    CheckReport,
    CheckRequest,
    ImportRequest,
    ImportResult,
    Limits,
    PlacesReport,
    PlacesRequest,
)
from c2s_engine.structure.diagnostics import Diagnostic, StageName, StageResult
from c2s_engine.structure.facts import RunFacts, Trajectories

LONGEST = 500_000  # characters of a program
_MAP = re.compile(r"^param map = localPath\(['\"]([^'\"]+\.xodr)['\"]\)", re.MULTILINE)


async def check(pool: Pool, request: CheckRequest, runner: str | None) -> CheckReport:
    """Check a program; whatever happens to its process becomes a diagnostic."""
    job = request.model_dump(mode="json")
    folder = Path(request.folder or os.getcwd())
    job["filename"] = str(folder / request.filename)
    job["runner"] = runner
    job["modules"] = beside.found(request.program, folder)
    gathered = _Gathered()
    started = time.perf_counter()
    if len(request.program) > LONGEST:
        return gathered.failed("parse", started, "too_long", f"the program is longer than {LONGEST:,} characters")
    if said := _MAP.search(request.program):
        pool.expect(_map_path(said[1], request, folder))
    try:
        header, blob = await pool.read(job)
    except TooSlow:
        return gathered.failed("parse", started, "parse_time", "the program takes too long to parse; make it simpler")
    except wire.Closed:
        return gathered.failed(
            "parse", started, "parse_crash", "the program is nested too deeply or too large to parse; make it simpler"
        )
    gathered.stages = [StageResult.model_validate(s) for s in header["stages"]]
    gathered.ast_hash = header.get("ast_hash", "")
    if not blob or request.upto in ("parse", "safety"):
        return gathered.report()
    if request.upto == "run" and not runner:
        return gathered.failed("run", started, "no_runner", "this check server was started without a runner")
    job["map"] = _map_path(header["map"], request, folder)
    where = (job["map"], header, job, blob)
    doing = {**job, **_begun(header), "kind": "check"}
    zygote = await pool.nearest(*where)
    try:
        child = await _child(zygote, doing, header, blob)
    except wire.Closed:  # it died since it was last used
        zygote = await pool.nearest(*where)
        child = await zygote.spawn(doing, blob)
    try:
        return await _watch(child, request.limits, gathered)
    finally:
        pool.used(zygote, doing, header, blob, gathered.executed)


async def _child(zygote: Zygote, job: dict[str, Any], header: dict[str, Any], blob: bytes) -> Child:
    """A child with the job: one that has done the program's beginning, else a fresh one."""
    return await zygote.ahead.give(job, header, blob) or await zygote.spawn(job, blob)


def _begun(header: dict[str, Any]) -> dict[str, Any]:
    """Which of a program's pieces a snapshot has done, and which of these set params."""
    return {"count": header.get("count", 0), "settings": header.get("settings", [])}


def _map_path(said: str, request: CheckRequest, folder: Path) -> str:
    path = request.params.get("map", said)
    return str(folder / str(path)) if path else ""


class _Gathered:
    """What a child has reported so far."""

    def __init__(self) -> None:
        self.stages: list[StageResult] = []
        self.facts: list[RunFacts] = []
        self.trajectories: list[Trajectories] = []
        self.iterations: list[int] = []
        self.scenes: list[dict[str, Any]] = []
        self.isolation = ""
        self.ast_hash = ""
        self.stage: StageName = "compile"
        self.places: dict[str, Any] | None = None
        self.ended = False

    @property
    def executed(self) -> bool:
        """Whether the program's statements came to their end."""
        return any(s.name == "compile" and s.ok for s in self.stages)

    def take(self, message: dict[str, Any]) -> None:
        if "stage" in message:
            self.stages.append(StageResult.model_validate(message["stage"]))
        elif "begin" in message:
            self.stage = message["begin"]
        elif "facts" in message:
            self.facts.append(RunFacts.model_validate(message["facts"]))
        elif "trajectories" in message:
            self.trajectories.append(Trajectories.model_validate(message["trajectories"]))
        elif "iterations" in message:
            self.iterations.append(int(message["iterations"]))
        elif "scene" in message:
            self.scenes.append(dict(message["scene"]))
        elif "isolation" in message:
            self.isolation = str(message["isolation"])
        elif "places" in message:
            self.places = message["places"]
        elif "end" in message:
            self.ended = True

    def failed(self, stage: StageName, started: float, code: str, message: str) -> CheckReport:
        found = Diagnostic(stage=stage, code=code, message=message)
        seconds = time.perf_counter() - started
        self.stages.append(StageResult(name=stage, ok=False, seconds=seconds, diagnostics=(found,)))
        return self.report()

    def report(self) -> CheckReport:
        return CheckReport(
            stages=tuple(self.stages),
            facts=tuple(self.facts),
            trajectories=tuple(self.trajectories),
            iterations=tuple(self.iterations),
            scenes=tuple(self.scenes),
            isolation=self.isolation,
            ast_hash=self.ast_hash,
        )


async def _follow(child: Child, gathered: _Gathered) -> None:
    while not gathered.ended:
        header, _ = await wire.read(child.reader)
        gathered.take(header)


async def _watch(child: Child, limits: Limits, gathered: _Gathered) -> CheckReport:
    started = time.perf_counter()
    try:
        await asyncio.wait_for(_follow(child, gathered), limits.wall)
    except TimeoutError:
        return gathered.failed(gathered.stage, started, "limit_wall", f"stopped after {limits.wall:g} s (wall time)")
    except (wire.Closed, ValueError, KeyError):
        status = await child.status()
        if not child.zygote.alive:
            raise wire.Closed from None
        code, message = _death(status, limits)
        return gathered.failed(gathered.stage, started, code, message)
    finally:
        child.kill()
    return gathered.report()


def _death(status: int, limits: Limits) -> tuple[str, str]:
    number = status & 0x7F if status >= 0 else 0
    if number == signal.SIGXCPU or number == signal.SIGKILL:
        return "limit_cpu", f"stopped after {limits.cpu:g} s of CPU time"
    if number == signal.SIGSEGV:
        return "crash", "the program crashed the interpreter (it is nested or recursing too deeply)"
    if number:
        return "crash", f"the program ended its process ({signal.Signals(number).name})"
    return "exit", "the program ended its process"


async def expect(pool: Pool, path: str) -> None:
    """Have all that a program on this map starts from made beforehand."""
    if pool.expect(path):
        with contextlib.suppress(ValueError, TooSlow, wire.Closed):
            await places(pool, PlacesRequest(map=path, expressions={}))


async def places(pool: Pool, request: PlacesRequest) -> PlacesReport:
    """Evaluate expressions in the names that a program on that map has."""
    text = f"param map = {request.map!r}\nparam carla_map = None\nmodel scenic.simulators.carla.model\n"
    text += f"{driving.IMPORT}\n"
    check_request = CheckRequest(program=text, filename="places.scenic", upto="compile")
    job = check_request.model_dump(mode="json")
    job["filename"] = str(Path(request.map).parent / "places.scenic")
    if not Path(request.map).is_file():
        raise ValueError(f"there is no map file {request.map}")
    header, blob = await pool.read(job)
    for stage in header["stages"]:
        for found in (d for d in stage["diagnostics"] if d["severity"] == "error"):
            raise ValueError(found["message"])
    if why := await pool.no_map(request.map):
        name = Path(request.map).name
        raise ValueError(why if name in why else f"Scenic cannot read the map {name}: {why}")
    zygote = await pool.nearest(request.map, header, job, blob)
    if "read" not in zygote.grown:  # the map can be read, but these statements do not run
        why = _first_error(await check(pool, check_request, None)) or "it does not run"
        raise ValueError(f"the driving library is broken: {driving.path()}: {why}; reinstall c2s, or repair the file")
    child = await zygote.spawn(
        {**job, "kind": "places", "expressions": request.expressions, "first": request.first}, b""
    )
    gathered = _Gathered()
    report = await _watch(child, check_request.limits, gathered)
    if gathered.places is None:
        raise ValueError(_first_error(report) or f"the map {request.map} could not be read")
    return PlacesReport.model_validate(gathered.places)


def _first_error(report: CheckReport) -> str:
    """The first thing that is wrong, in a sentence; nothing where all is well."""
    errors = (d for stage in report.stages for d in stage.diagnostics if d.severity == "error")
    return next((d.message for d in errors), "")


async def import_program(pool: Pool, request: ImportRequest) -> ImportResult:
    """Decompose a program in the reader: nothing of it is executed."""
    try:
        header, _ = await pool.read({"kind": "import", **request.model_dump(mode="json")})
    except TooSlow:
        raise ValueError("the program takes too long to parse; make it simpler") from None
    except wire.Closed:
        raise ValueError("the program is nested too deeply or too large to parse; make it simpler") from None
    return ImportResult.model_validate(header)
