"""The dry-run world on Scenic's simulator interface: fake actors, our own stepping, and why a run ended."""

import random
import time
from typing import Any

import carla
from scenic.core.dynamics.actions import _EndScenarioAction, _EndSimulationAction
from scenic.core.dynamics.invocables import runTryInterrupt
from scenic.core.simulators import SimulationCreationError, TerminationType
from scenic.core.vectors import Vector
from scenic.domains.driving.simulators import DrivingSimulation

from c2s_engine.dryrun import actors as fake
from c2s_engine.dryrun import controllers, undriven
from c2s_engine.dryrun.contacts import Contacts
from c2s_engine.dryrun.dynamics import SUBSTEP
from c2s_engine.dryrun.fast import Mirror, lookups
from c2s_engine.dryrun.lights import Lights
from c2s_engine.dryrun.recording import Recorder
from c2s_engine.dryrun.roads import RoadIndex
from c2s_engine.dryrun.streets import Streets
from c2s_engine.dryrun.stuck import watching
from c2s_engine.dryrun.traffic import TrafficManager
from c2s_engine.dryrun.walkers import Guide
from c2s_engine.maps.extras import MapExtras

AFTERMATH, APPROACH, LONGEST, ALL = 1.0, 3.5, 4.0, 10.0
"""s that a run goes on after a collision, at least: and after anybody else has last braked; where ego is not in it and
may come up to it; at most until those in it stand; in all."""
BRAKES = 0.5
"""m/s2 by which one slows down who does something about it."""
NOTHING = Vector(0, 0, 0)


class World(carla.World):
    """CARLA's world as far as the stock model and its actions ask it."""

    def __init__(self, simulation: "DryRunSimulation") -> None:
        self._simulation = simulation
        self.actors: list[Any] = []
        self.weather: Any = None

    def get_map(self) -> Streets:
        return self._simulation.map

    def get_actors(self) -> list[Any]:
        return self.actors

    def get_weather(self) -> Any:
        return self.weather

    def set_weather(self, weather: Any) -> None:
        self.weather = weather

    def freeze_all_traffic_lights(self, frozen: bool) -> None:
        self._simulation.lights.freeze(frozen)

    def reset_all_traffic_lights(self) -> None:
        for light in self._simulation.lights.by_approach.values():
            light.forced = None

    def get_traffic_light(self, landmark: Any) -> Any:
        return landmark.light

    def get_random_location_from_navigation(self) -> Any:
        return self._simulation.map.random_walk(self._simulation.rng)

    def limit(self, road: str) -> float | None:
        extras = self._simulation.extras
        return extras.limit(int(road)) if extras and str(road).isdigit() else None

    def red_ahead(self, actor: Any) -> float | None:
        """m to the line of a red or yellow light that faces a vehicle, within 60 m."""
        place = self._simulation.map.get_waypoint(actor.get_location())
        if place is None or place.is_junction:
            return None
        for sign in place.get_landmarks_of_type(60.0, "1000001"):
            if str(sign.light.state) in ("Red", "Yellow"):
                return sign.distance
        return None


def _line_of(behavior: Any) -> int | None:
    """The line of the program at which a behavior is: the innermost that is not of a library beside it."""
    line: int | None = None
    running: Any = getattr(behavior, "_runningIterator", None)
    while (frame := getattr(running, "gi_frame", None)) is not None:
        if frame.f_globals.get("__name__") == "__main__":  # as Scenic calls the program's own module
            line = frame.f_lineno
        of_interrupts = frame.f_code is runTryInterrupt.__code__
        running = frame.f_locals["block"].runningIterator if of_interrupts else running.gi_yieldfrom
    return line


class DryRunSimulation(DrivingSimulation):
    """One run of a scene."""

    def __init__(self, scene: Any, *, index: RoadIndex, extras: MapExtras | None, kinds: dict[str, str], seed: int,
                 seconds: float, timestep: float, stuck: float = 3.0) -> None:  # fmt: skip
        self.index, self.extras, self.kinds = index, extras, kinds
        self.rng = random.Random(seed)
        self.lights = Lights(extras, self.rng)
        self.map = Streets(index, extras, self.lights, str(scene.params.get("carla_map")))
        self.world = World(self)
        self.tm = TrafficManager(self.world, index, self.rng)
        self.recorder = Recorder(timestep)
        self.classes: list[str] = []
        self.contacts: Contacts | None = None
        self.acting: Any = None
        self.lines: dict[int, int] = {}  # by id of an agent: where its behavior is, in the program's own text
        self.crashed: float | None = None
        self.braked = 0.0
        self.speeds: dict[int, float] = {}
        self.ended: TerminationType | None = None
        self.substeps = max(1, round(timestep / SUBSTEP))
        self.mirrors: dict[int, Mirror] = {}
        self.agents: list[Any] = []  # a beginning that fails stops them before Scenic has made the list
        with lookups(index.network) as self.found, watching(stuck) as self.watch:
            super().__init__(
                scene, maxSteps=max(1, round(seconds / timestep)), name="dry run", timestep=timestep, enableReplay=False
            )

    @property
    def client(self) -> Any:
        raise RuntimeError("the dry run has no CARLA client")

    def setup(self) -> None:
        weather = self.scene.params.get("weather")
        if isinstance(weather, str):
            presets = [n for n, v in vars(carla.WeatherParameters).items() if isinstance(v, carla.WeatherParameters)]
            if weather not in presets:
                raise SimulationCreationError(f"CARLA has no weather preset {weather!r}: use {', '.join(presets)}")
            self.world.set_weather(getattr(carla.WeatherParameters, weather))
        elif isinstance(weather, dict):
            known = vars(carla.WeatherParameters())
            if wrong := [n for n in weather if n not in known]:
                raise SimulationCreationError(f"CARLA's weather has no {wrong[0]!r}: it has {', '.join(known)}")
            self.world.set_weather(carla.WeatherParameters(**weather))
        super().setup()
        self.contacts = Contacts(self.world.actors, self.classes)

    def createObjectInSimulator(self, obj: Any) -> Any:
        plain = undriven.kind_of(obj)
        kind = plain or fake.class_of(str(getattr(obj, "blueprint", "") or ""), self.kinds)
        actor = fake.make(len(self.world.actors), obj, kind)
        if plain:
            undriven.adapt(obj, plain)
            if any(obj.velocity):
                obj.carlaActor = actor
                obj.setVelocity(obj.velocity)
        elif obj.speed:
            raise SimulationCreationError(
                f"a {type(obj).__name__} has an initial speed, which CARLA cannot give: "
                "let its behavior take SetSpeedAction, or leave 'with speed' out"
            )
        actor.set_simulate_physics(bool(getattr(obj, "physics", kind != "prop")))
        obj.carlaActor = actor
        if kind == "walker":
            obj.carlaController = Guide(actor, self.index)
        self.world.actors.append(actor)
        self.classes.append(kind)
        if self.contacts is not None:
            known, touched = set(self.contacts.found), self.contacts.touched
            self.contacts = Contacts(self.world.actors, self.classes)
            self.contacts.found, self.contacts.touched = sorted(known), touched
        return actor

    def _run(self, dynamicScenario: Any, maxSteps: int) -> tuple[TerminationType, str]:
        """Scenic's loop, but a collision ends the run, and it is known who acts."""
        self.recorder.sample(self.world.actors, 0)
        self.recorder.note_lights(0.0, self.lights.states())
        while True:
            kind, reason = TerminationType.scenarioComplete, dynamicScenario._step()
            self.recordCurrentState()
            monitored = dynamicScenario._runMonitors()
            if monitored is not None:
                kind, reason = TerminationType.terminatedByMonitor, monitored
            if reason is None:
                kind = TerminationType.simulationTerminationCondition
                reason = dynamicScenario._checkSimulationTerminationConditions()
            if reason is None and self.currentTime >= maxSteps:
                kind, reason = TerminationType.timeLimit, "the time was over"
            if reason is not None:
                return self._end(kind, reason)
            if self._crash_is_over():
                return self._end(TerminationType.timeLimit, "collision")
            actions = self._decide(dynamicScenario)
            if not isinstance(actions, dict):
                return self._end(TerminationType.terminatedByBehavior, str(actions))
            self.executeActions(actions)
            if self.currentTime == 0:
                self.recorder.restart(self.world.actors)
            self.step()
            self.currentTime += 1
            self.updateObjects()

    def _crash_is_over(self) -> bool:
        if self.crashed is None:
            return False
        now, speeds = self.currentTime * self.timestep, self.speeds
        bodies = {id(a): a.body for a in self.world.actors if not isinstance(a, fake.Prop)}
        self.speeds = {key: abs(body.speed) for key, body in bodies.items()}
        alive = (key for key, body in bodies.items() if not body.dead)
        if any(self.speeds[key] < speeds.get(key, 0.0) - BRAKES * self.timestep for key in alive):
            self.braked = now
        rolls = any(body.dead and abs(body.speed) > 0.1 for body in bodies.values())
        ego = getattr(self.scene.egoObject, "carlaActor", None)
        least = LONGEST if rolls else AFTERMATH if ego is None or ego.body.dead else APPROACH
        since, quiet = now - self.crashed, now - max(self.crashed, self.braked)
        return since >= ALL or quiet >= AFTERMATH and since >= least

    def _end(self, kind: TerminationType, reason: Any) -> tuple[TerminationType, str]:
        self.ended = kind
        self.lines = {id(o): line for o in self.objects if (line := _line_of(o.behavior)) is not None}
        return kind, str(reason)

    def _decide(self, scenario: Any) -> Any:
        """The actions of every agent in this step, or the action that ends the run."""
        for obj in self.objects:
            obj.lastActions = ()
            if obj.behavior and obj not in self.agents:
                self.agents.append(obj)
        chosen: dict[Any, tuple] = {}
        for agent in self.agents:
            if not agent.behavior:
                continue
            self.acting, self.watch.begun = agent, time.process_time()
            actions = agent.behavior._step()
            self.watch.begun = None
            if isinstance(actions, _EndSimulationAction):
                return actions
            if isinstance(actions, _EndScenarioAction):
                if actions.scenario._isRunning:
                    actions.scenario._stop(actions)
                if actions.scenario is scenario:
                    return actions
                actions = ()
            if len(actions) == 1 and isinstance(actions[0], list | tuple):
                actions = tuple(actions[0])
            for action in actions:
                if not hasattr(action, "canBeTakenBy"):
                    raise TypeError(f"`take` was given {action!r}, which is no action")
                if not action.canBeTakenBy(agent):
                    raise TypeError(f"a {type(agent).__name__} cannot take {type(action).__name__}")
            chosen[agent] = agent.lastActions = actions
        self.acting = None
        return chosen

    def executeActions(self, allActions: dict[Any, tuple]) -> None:
        for agent, actions in allActions.items():
            self.acting = agent
            for action in actions:
                action.applyTo(agent, self)
        self.acting = None
        for agent in self.agents:
            if agent._control is not None:
                agent.carlaActor.apply_control(agent._control)
                agent._control = None

    def step(self) -> None:
        now = self.currentTime * self.timestep
        actors, dt = self.world.actors, self.timestep / self.substeps
        fastest = 0.0
        for actor in actors:
            if getattr(actor, "autopilot", False) and not actor.body.dead:
                self.tm.drive(actor, self.timestep)
            fastest = max(fastest, abs(actor.body.speed) + abs(actor.body.sideways))
        contacts = self.contacts
        assert contacts is not None  # made by setup
        close = contacts.near(2.0 * (fastest + 1.0) * self.timestep)
        moving = [a for a in actors if not isinstance(a, fake.Prop)]
        for i in range(self.substeps):
            for actor in moving:
                actor.advance(dt)
            if close or contacts.touched:
                contacts.check(close, now + (i + 1) * dt)
        if contacts.found and self.crashed is None:
            self.crashed = contacts.found[0][0]
        self.lights.tick(self.timestep)
        self.recorder.sample(actors, self.currentTime + 1)
        self.recorder.note_lights(now + self.timestep, self.lights.states())

    def getProperties(self, obj: Any, properties: set[str]) -> dict[str, Any]:
        raise NotImplementedError("objects are updated by their mirrors")

    def updateObjects(self) -> None:
        self.found.clear()
        for obj in self.objects:
            mirror = self.mirrors.get(id(obj))
            if mirror is None or mirror.parent is not obj.parentOrientation:
                mirror = self.mirrors[id(obj)] = Mirror(obj, obj.carlaActor)
            mirror.write()

    def currentState(self) -> tuple:
        """Scenic's own record is not used; the recorder keeps the ways."""
        return ()

    def _controllers(self, agent: Any, tuning: controllers.Tuning) -> Any:
        return controllers.pair(agent.carlaActor.body, tuning, self.timestep, lambda: self.currentTime * self.timestep)

    def getLaneFollowingControllers(self, agent: Any) -> Any:
        return self._controllers(agent, controllers.FOLLOWING)

    def getTurningControllers(self, agent: Any) -> Any:
        return self._controllers(agent, controllers.TURNING)

    def getLaneChangingControllers(self, agent: Any) -> Any:
        return self._controllers(agent, controllers.CHANGING)
