"""Runs built by hand: facts and tracks on a straight road with a junction, for both sides of each requirement.

Ego drives north in the lane x = 0; lanes are 3.5 m wide; a junction lies from y = 60 to 80 with a light's line at 60.
A mirrored run exchanges left and right.
"""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from c2s_engine.structure.facts import (
    ContactFact,
    Course,
    EventFact,
    Mark,
    ObjectFacts,
    RoadFacts,
    RunFacts,
    StartFact,
    Stay,
    Track,
    Trajectories,
)
from c2s_engine.structure.requirements import Run

STEP = 0.1
OTHER = {"left": "right", "right": "left"}
SIZES = {
    "car": (4.5, 1.9),
    "truck": (10.0, 2.5),
    "bicycle": (1.8, 0.6),
    "pedestrian": (0.5, 0.5),
    "obstacle": (1.0, 1.0),
}
TYPES = {"pedestrian": ("pedestrian", "vru"), "bicycle": ("bicycle", "vru", "vehicle"), "obstacle": ("obstacle",)}


@dataclass
class Actor:
    """One road user: m/s a step (or one number), m to the right of ego's lane, m north at the start."""

    name: str
    component: str | None
    speed: Any = 10.0
    x: Any = 0.0
    y: float = 0.0
    heading: Any = 0.0  # rad, 0 is north
    kind: str = "car"
    events: tuple[EventFact, ...] = ()
    lanes: tuple[str, ...] = ("same",)
    relations: tuple[str, ...] = ("ahead",)
    gap: float = 20.0
    stays: tuple[Stay, ...] = (Stay(time=0.0, lane=1, to_ego="own"),)
    marks: tuple[Mark, ...] = ()
    sight: tuple[tuple[float, bool], ...] = ((0.0, True),)
    hidden_behind: tuple[str, ...] = ()
    across: bool = False  # it moves along x instead of y
    of: str = "ego"  # whom `relations`, `lanes` and `gap` are seen from


@dataclass
class Scene:
    """A run to be built; `seconds` long."""

    actors: list[Actor]
    seconds: float = 12.0
    contacts: tuple[ContactFact, ...] = ()
    ended_by: Any = "terminated"
    reason: str = ""
    facts: dict[str, Any] = field(default_factory=dict)
    lights: tuple[tuple[float, str, str], ...] = ()

    def run(self, mirrored: bool = False) -> Run:
        steps = round(self.seconds / STEP) + 1
        tracks, objects = zip(*(_built(a, steps, mirrored) for a in self.actors), strict=True)
        contacts = tuple(_contact(c) if mirrored else c for c in self.contacts)
        facts = RunFacts(seed=0, duration=self.seconds, ended_by=self.ended_by, reason=self.reason, objects=objects,
                         contacts=contacts, **{"road": RoadFacts(straight=True), **self.facts})  # fmt: skip
        return Run(facts=facts, trajectories=Trajectories(step=STEP, tracks=tracks, lights=self.lights))


def ramp(*points: tuple[float, float], seconds: float = 12.0) -> np.ndarray:
    """Values a step between (time, value) points."""
    times, values = zip(*points, strict=True)
    return np.interp(np.arange(round(seconds / STEP) + 1) * STEP, times, values)


def event(name: str, time: float, other: str | None = None) -> EventFact:
    return EventFact(event=name, time=time, other=other)


def _built(actor: Actor, steps: int, mirrored: bool) -> tuple[Track, ObjectFacts]:
    sign = -1.0 if mirrored else 1.0
    speed = _series(actor.speed, steps)
    gone = np.concatenate([[0.0], np.cumsum(speed[:-1]) * STEP])
    aside, heading = _series(actor.x, steps), _series(actor.heading, steps)
    x, y = (aside + gone, np.full(steps, actor.y)) if actor.across else (aside, actor.y + gone)
    if actor.across:
        heading = np.full(steps, -np.pi / 2)
    x, heading = sign * x, sign * heading
    length, width = SIZES[actor.kind]
    off = -sign * (np.zeros(steps) if actor.across else aside - aside[0])
    course = Course(
        every=2 * STEP,
        along=_kept(x if actor.across else y),
        aside=_kept(off),
        ego_along=_kept(y),
        ego_aside=_kept(-x),
        stays=tuple(_stay(s) if mirrored else s for s in actor.stays),
        marks=actor.marks,
        sight=actor.sight,
    )
    track = Track(name=actor.name, x=tuple(x), y=tuple(y), heading=tuple(heading), speed=tuple(speed), length=length,
                  width=width, kind=actor.kind, course=course)  # fmt: skip
    start = StartFact(relations=actor.relations, lanes=actor.lanes, gap=actor.gap)
    facts = ObjectFacts(
        name=actor.name, component=actor.component, types=TYPES.get(actor.kind, (actor.kind, "vehicle")), length=length,
        width=width, moves=bool(speed.max() > 0), hidden_behind=actor.hidden_behind,
        events=tuple(EventFact(**{**e.model_dump(), "event": swap(e.event)}) if mirrored else e for e in actor.events),
        starts={} if actor.name == "ego" else {actor.of: _start(start) if mirrored else start},
    )  # fmt: skip
    return track, facts


def _series(values: Any, steps: int) -> np.ndarray:
    """One number, or a value a step of at least so many."""
    found = np.asarray(values, float)
    return found[:steps] if found.ndim else np.full(steps, float(found))


def _kept(values: np.ndarray) -> tuple[float, ...]:
    return tuple(np.round(values[::2], 3).tolist())


def swap(word: str) -> str:
    """A word with left and right exchanged."""
    return "right".join(part.replace("right", "left") for part in word.split("left"))


def _stay(stay: Stay) -> Stay:
    return stay.model_copy(update={"to_ego": OTHER.get(stay.to_ego, stay.to_ego)})


def _start(start: StartFact) -> StartFact:
    return StartFact(relations=tuple(map(swap, start.relations)), lanes=tuple(map(swap, start.lanes)), gap=start.gap)


def _contact(contact: ContactFact) -> ContactFact:
    parts = {k: swap(getattr(contact, k)) for k in ("part_one", "part_other")}
    spots = {k: (at[0], -at[1]) for k in ("at_one", "at_other") if (at := getattr(contact, k))}
    return contact.model_copy(update={**parts, **spots})
