"""Run a sampled scene and say what it showed. Runs in the check process (Scenic and the stand-ins are there)."""

import contextlib
import traceback
import warnings
from functools import cache
from pathlib import Path
from typing import Any

import scenic
from scenic.core.distributions import RejectionException
from scenic.core.dynamics import GuardViolation, RejectSimulationException
from scenic.core.dynamics.utils import StuckBehaviorWarning
from scenic.core.simulators import SimulationCreationError, TerminationType
from scenic.simulators.carla import blueprints

from c2s_engine.dryrun import plain
from c2s_engine.dryrun.events.derivation import derive, with_courses
from c2s_engine.dryrun.events.table import definitions
from c2s_engine.dryrun.outline import box_of, map_outline
from c2s_engine.dryrun.recording import Recording
from c2s_engine.dryrun.roads import index_of
from c2s_engine.dryrun.world import DryRunSimulation
from c2s_engine.maps.extras import BrokenMap, MapExtras, read_extras
from c2s_engine.structure.facts import Course, RunFacts, Track, Trajectories

STUCK = 3
"""s that a behaviour may compute without taking an action."""
OURS = (str(Path(scenic.__file__).parent), str(Path(__file__).parent))


def prepare(network: Any = None, path: str = "") -> None:
    """Make what all runs of a process (and of its forks) share: Scenic's shortcuts, tables, a map's index."""
    plain.install()
    definitions()
    blueprint_classes()
    if network is not None:
        index_of(network).warm()
        with contextlib.suppress(BrokenMap):
            read_extras(path)


def run_scene(scene: Any, *, names: dict[int, str], components: dict[str, str], seed: int, seconds: float,
              trajectories: bool, map_path: str) -> tuple[RunFacts, Trajectories | None]:  # fmt: skip
    """Run the scene for `seconds` s. A run that fails is told by `ended_by` and `reason`; nothing is raised for it.

    What a run showed before it broke off is there; where nothing moved yet there are neither objects nor trajectories.
    """
    run = simulate(scene, names=names, seed=seed, seconds=seconds, map_path=map_path)
    courses: dict[str, Course] = {}
    if run.recording is None or run.recording.steps < 2:
        return RunFacts(seed=seed, duration=run.duration, ended_by=run.ended_by, reason=run.reason), None
    index = index_of(scene.workspace.network)
    if trajectories:
        facts, courses = with_courses(run.recording, index, run.extras)
    else:
        facts = derive(run.recording, index, run.extras)
    objects = tuple(o.model_copy(update={"component": components.get(o.name), "line": run.lines.get(o.name)})
                    for o in facts.objects)  # fmt: skip
    update = {"seed": seed, "duration": run.duration, "ended_by": run.ended_by, "reason": run.reason}
    facts = facts.model_copy(update={**update, "objects": objects})
    if not trajectories:
        return facts, None
    outline = map_outline(scene.workspace.network, box_of(run.recording), run.extras)
    ways = tracks_of(run.recording)
    tracks = tuple(t.model_copy(update={"course": courses.get(t.name)}) for t in ways.tracks)
    return facts, ways.model_copy(update={"tracks": tracks, "outline": outline})


class Run:
    """A run's recording, how it ended, and the line of the program at which each object's behavior was by then."""

    recording: Recording | None = None
    extras: MapExtras | None = None
    duration = 0.0
    ended_by: Any = "error"
    reason = ""

    def __init__(self) -> None:
        self.lines: dict[str, int] = {}


def simulate(scene: Any, *, names: dict[int, str], seed: int, seconds: float, map_path: str) -> Run:
    """Run the scene and keep what was recorded, also of a run that was cut short."""
    prepare()
    run = Run()
    step = min(0.1, max(0.01, float(scene.params.get("timestep", 0.1))))
    simulation: DryRunSimulation | None = None
    made: list[DryRunSimulation] = []

    class Kept(DryRunSimulation):
        def setup(self) -> None:
            made.append(self)
            super().setup()

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            run.extras = read_extras(map_path) if map_path.endswith(".xodr") else None
            Kept(scene, index=index_of(scene.workspace.network), extras=run.extras, kinds=blueprint_classes(),
                 seed=seed, seconds=seconds, timestep=step, stuck=STUCK)  # fmt: skip
            simulation = made[0]
            run.ended_by = _ending(simulation)
            run.reason = "" if run.ended_by == "time" else str(simulation.result.terminationReason)
        except (RejectSimulationException, RejectionException, GuardViolation) as error:
            run.ended_by = "rejected"
            run.reason = _reason(error, made, step, names)
        except Exception as error:
            run.ended_by = "error"
            run.reason = _reason(error, made, step, names)
    if made and made[0].recorder.samples:
        simulation = made[0]
        labels = [names.get(id(o)) or f"{type(o).__name__.lower()}_{i}" for i, o in enumerate(simulation.objects)]
        run.lines = {label: simulation.lines[id(o)] for label, o in zip(labels, simulation.objects, strict=True)
                     if id(o) in simulation.lines}  # fmt: skip
        run.recording = simulation.recorder.finish(simulation.world.actors, labels, simulation.classes)
        run.recording.contacts = list(simulation.contacts.found) if simulation.contacts else []
        run.recording.params = dict(scene.params)
        run.duration = (run.recording.steps - 1) * step
    return run


def _ending(simulation: DryRunSimulation) -> str:
    if simulation.crashed is not None:
        return "collision"
    return "time" if simulation.ended is TerminationType.timeLimit else "terminated"


_TYPED = (
    AssertionError, AttributeError, KeyError, IndexError, NameError, TypeError, ValueError, SimulationCreationError,
)  # fmt: skip
"""Faults that are told with their class: the catalogue of the check knows them by it."""


def _reason(error: BaseException, made: list[DryRunSimulation], step: float, names: dict[int, str]) -> str:
    """One sentence: when, who, where in the program, what."""
    text = str(error) or type(error).__name__
    if isinstance(error, StuckBehaviorWarning):
        text = f"it computed for over {STUCK} s without taking an action; a loop without `take` or `wait`?"
    elif isinstance(error, _TYPED):
        text = f"{type(error).__name__}: {text}"
    parts = []
    if made:
        parts.append(f"at {made[0].currentTime * step:.1f} s")
        if made[0].acting is not None:
            agent = made[0].acting
            doing = type(agent.behavior).__name__ if agent.behavior else ""
            parts.append(f"in {doing or 'the behavior'} of {names.get(id(agent)) or type(agent).__name__}")
    line = next(
        (f.lineno for f in reversed(traceback.extract_tb(error.__traceback__)) if _of_program(f.filename)), None
    )
    if line:
        parts.append(f"line {line}")
    return f"{', '.join(parts)}: {text}" if parts else text


def _of_program(filename: str) -> bool:
    return not filename.startswith(OURS) and "site-packages" not in filename and not filename.startswith("<frozen") \
        and "/lib/python" not in filename and "c2s_engine" not in filename  # fmt: skip


PICKUPS = ("vehicle.tesla.cybertruck",)
"""Among Scenic's trucks, and no heavy vehicles: the driving library's list (reading that takes 50 ms of each start)."""


@cache
def blueprint_classes() -> dict[str, str]:
    """The class of every blueprint in Scenic's table: vehicles by their class, everything else a prop."""
    found: dict[str, str] = {}
    for category, members in blueprints.ids.items():
        kind = category.removesuffix("Models")
        kind = kind if kind in ("car", "van", "truck", "bus", "motorcycle", "bicycle", "walker") else "prop"
        found.update(dict.fromkeys(members, kind))
    found.update(dict.fromkeys(PICKUPS, "pickup"))
    return found


def tracks_of(recording: Recording) -> Trajectories:
    """The ways for the pictures and for export."""

    def rounded(values: Any, digits: int) -> tuple[float, ...]:
        return tuple(round(float(v), digits) for v in values)

    tracks = tuple(
        Track(
            name=p.name,
            x=rounded(p.x, 3),
            y=rounded(p.y, 3),
            heading=rounded(p.heading, 4),
            speed=rounded(p.speed, 3),
            length=round(p.length, 2),
            width=round(p.width, 2),
            kind=p.kind,
        )  # fmt: skip
        for p in recording.paths
    )
    lights = tuple((round(t, 2), f"{junction}/{road}", state) for t, junction, road, state in recording.lights)
    return Trajectories(step=recording.step, tracks=tracks, lights=lights)
