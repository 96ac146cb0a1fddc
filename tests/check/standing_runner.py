"""A runner for tests: it runs the behaviours in a world that stands still, so that the check is tested, not physics."""

from typing import Any

from c2s_engine.structure.facts import ObjectFacts, RunFacts, Track, Trajectories


def run_scene(
    scene: Any,
    *,
    names: dict[int, str],
    components: dict[str, str],
    seed: int,
    seconds: float,
    trajectories: bool,
    map_path: str,
) -> tuple[RunFacts, Trajectories | None]:
    """Run the scene's behaviours with nothing moving; the facts name each object with its component."""
    from scenic.domains.driving.simulators import DrivingSimulation, DrivingSimulator

    class StillSimulation(DrivingSimulation):
        def createObjectInSimulator(self, obj: Any) -> None:
            pass

        def executeActions(self, allActions: Any) -> None:
            pass

        def step(self) -> None:
            pass

        def getProperties(self, obj: Any, properties: Any) -> dict[str, Any]:
            return {name: getattr(obj, name) for name in properties}

    class StillSimulator(DrivingSimulator):
        def createSimulation(self, scene: Any, **kwargs: Any) -> DrivingSimulation:
            return StillSimulation(scene, **kwargs)

    StillSimulator().createSimulation(scene, maxSteps=5, name="still", timestep=0.1)
    objects = tuple(
        ObjectFacts(
            name=names[id(o)], component=components.get(names[id(o)]), types=("car",), length=o.length, width=o.width,
            moves=False,
        )
        for o in scene.objects
    )  # fmt: skip
    track = Track(name="ego", x=(0.0,), y=(0.0,), heading=(0.0,), speed=(0.0,), length=4, width=2)
    facts = RunFacts(seed=seed, duration=0.5, ended_by="time", objects=objects)
    return facts, Trajectories(step=0.1, tracks=(track,)) if trajectories else None
