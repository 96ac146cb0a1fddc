"""One manoeuvre through a backend: the dry run, or CARLA in a process of its own."""

import asyncio
import contextlib
import json
import sys
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from c2s_engine.calibrate.manoeuvres import Manoeuvre
from c2s_engine.dryrun.carla import CarlaUnavailable
from c2s_engine.structure.facts import Trajectories

if TYPE_CHECKING:
    from c2s_engine.api import Engine

GRACE = 10
"""s that a cancelled run has to give the server back."""
Backend = Callable[[Manoeuvre, Path], Awaitable[Trajectories]]
"""Drives a manoeuvre whose program is saved in a file, its map and library beside it. Raises NotDriven."""


class NotDriven(RuntimeError):
    """A manoeuvre was not driven to its end; the message says why."""


@dataclass(frozen=True)
class DryRun:
    """The dry run of an engine."""

    engine: "Engine"

    async def __call__(self, manoeuvre: Manoeuvre, file: Path) -> Trajectories:
        report = await self.engine.check(
            file.read_text(encoding="utf-8"), upto="run", seconds=manoeuvre.seconds, trajectories=True,
            folder=str(file.parent), filename=file.name,
        )  # fmt: skip
        said = [d.message for stage in report.stages for d in stage.diagnostics if not stage.ok]
        if not report.ok or not report.trajectories:
            raise NotDriven(said[0] if said else "the run showed nothing")
        return report.trajectories[0]


@dataclass(frozen=True)
class Carla:
    """The CARLA server at an address."""

    host: str
    port: int

    async def __call__(self, manoeuvre: Manoeuvre, file: Path) -> Trajectories:
        """Raises CarlaUnavailable where the server does not answer as CARLA does, or no more."""
        command = ["-m", "c2s_engine.calibrate.in_carla", str(file), self.host, str(self.port), str(manoeuvre.seconds)]
        pipe = asyncio.subprocess.PIPE
        process = await asyncio.create_subprocess_exec(sys.executable, *command, stdout=pipe, stderr=pipe)
        try:
            out, err = await process.communicate()
        finally:
            await _ended(process)
        last = (out.decode(errors="replace").splitlines() or [""])[-1]
        if process.returncode == 0:
            return Trajectories.model_validate_json(last)
        try:
            why = json.loads(last)["error"]
        except (ValueError, KeyError):
            why = (err.decode(errors="replace").strip().splitlines() or ["its process ended"])[-1]
        if process.returncode == 3:
            raise CarlaUnavailable(f"The CARLA server at {self.host}:{self.port} cannot be used: {why}")
        raise NotDriven(why)


async def _ended(process: asyncio.subprocess.Process) -> None:
    if process.returncode is not None:
        return
    with contextlib.suppress(ProcessLookupError):
        process.terminate()
    try:
        await asyncio.wait_for(process.wait(), GRACE)
    except TimeoutError:
        process.kill()
        await process.wait()
