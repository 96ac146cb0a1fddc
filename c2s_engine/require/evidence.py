"""A run as the rules read it: who is whom, and each one's motion as arrays, up to its first contact."""

import math
from functools import cached_property

import numpy as np

from c2s_engine.structure.facts import EGO, ContactFact, Course, ObjectFacts, RunFacts, Stay, Track, Trajectories

STANDING = 0.3
"""m/s: who is slower stands."""
SMOOTH = 0.5
"""s over which speeds are averaged before they are differentiated."""


class Motion:
    """One object's motion. Arrays hold a value a step, up to its first contact."""

    def __init__(self, facts: ObjectFacts, track: Track, step: float, contact: float | None):
        self.facts, self.track, self.step, self.contact = facts, track, step, contact
        self.name = facts.name
        last = len(track.x) if contact is None else max(2, min(len(track.x), math.ceil(contact / step - 1e-6)))
        self.x, self.y = np.array(track.x[:last]), np.array(track.y[:last])
        self.heading, self.speed = np.unwrap(np.array(track.heading[:last])), np.array(track.speed[:last])
        self.time = np.arange(last) * step
        self.size = (track.length, track.width)

    @property
    def poses(self) -> np.ndarray:
        """(steps, [x, y, heading])."""
        return np.column_stack([self.x, self.y, self.heading])

    @property
    def beyond_contact(self) -> "Motion":
        """The same, to the end of the run."""
        return Motion(self.facts, self.track, self.step, None)

    @cached_property
    def smooth(self) -> np.ndarray:
        """Speed averaged over half a second, m/s."""
        width = max(1, round(SMOOTH / self.step)) // 2 * 2 + 1
        padded = np.pad(self.speed, width // 2, mode="edge")
        return np.convolve(padded, np.ones(width) / width, mode="valid")

    @cached_property
    def acceleration(self) -> np.ndarray:
        """m/s2 along the way."""
        return np.gradient(self.smooth, self.step) if len(self.smooth) > 1 else np.zeros(len(self.smooth))

    @cached_property
    def lateral(self) -> np.ndarray:
        """m/s2 across the way."""
        turning = np.gradient(self.heading, self.step) if len(self.heading) > 1 else np.zeros(len(self.heading))
        width = max(1, round(SMOOTH / self.step)) // 2 * 2 + 1
        padded = np.pad(turning, width // 2, mode="edge")
        return np.abs(np.convolve(padded, np.ones(width) / width, mode="valid") * self.speed)

    @property
    def course(self) -> Course:
        return self.track.course or Course()

    def of_course(self, name: str) -> np.ndarray:
        """`along`, `aside`, `ego_along` or `ego_aside` at each step (NaN where it is not known)."""
        values = getattr(self.course, name)
        if not values:
            return np.full(len(self.time), np.nan)
        return np.interp(self.time, np.arange(len(values)) * self.course.every, values)

    def stay(self, time: float) -> Stay | None:
        """Where it is at a time."""
        return next((s for s in reversed(self.course.stays) if s.time <= time + 1e-6), None)

    def at(self, time: float) -> int:
        """The step of a time."""
        return int(min(max(0, round(time / self.step)), len(self.time) - 1))

    def visible_from(self, time: float = 0.0) -> float | None:
        """When ego can first see it at or after a time; None where it never can."""
        before = [shown for change, shown in self.course.sight if change <= time]
        if before and before[-1]:
            return time
        return next((change for change, shown in self.course.sight if shown and change > time), None)

    @property
    def moves(self) -> bool:
        return self.facts.moves

    @property
    def kind(self) -> str:
        """Its class in the table of bounds."""
        types = self.facts.types
        for name in ("pedestrian", "animal", "bicycle", "motorcycle", "pickup", "truck", "bus", "van", "car"):
            if name in types:
                return name
        return "obstacle"


def stretches(mask: np.ndarray) -> list[tuple[int, int]]:
    """(first, last) of each run of true steps."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(int)))
    return [(int(a), int(b) - 1) for a, b in zip(edges[::2], edges[1::2], strict=True)]


class Evidence:
    """One run's facts and tracks. `without`: the same scene with ego's reaction switched off, where it was run.

    `times`: when each requirement that has a moment was seen, by its id; filled as requirements are judged in order.
    """

    def __init__(self, facts: RunFacts, trajectories: Trajectories, without: "Evidence | None" = None):
        self.facts, self.trajectories, self.without = facts, trajectories, without
        self.step = trajectories.step
        self.times: dict[str, float | None] = {}

    @cached_property
    def components(self) -> dict[str, str]:
        """Object's name to the reference that means it ('' for nobody's)."""
        return {o.name: EGO if o.name == EGO else o.component or "" for o in self.facts.objects}

    def members(self, actor: str) -> list[ObjectFacts]:
        """The objects of the run that a reference means."""
        return [o for o in self.facts.objects if self.components[o.name] == actor]

    @cached_property
    def _motions(self) -> dict[str, Motion]:
        contact: dict[str, float] = {}
        for c in self.facts.contacts:
            for name in (c.one, c.other):
                contact[name] = min(c.time, contact.get(name, c.time))
        objects = {o.name: o for o in self.facts.objects}
        return {
            t.name: Motion(objects[t.name], t, self.step, contact.get(t.name))
            for t in self.trajectories.tracks if t.name in objects and len(t.x) > 1
        }  # fmt: skip

    @property
    def everybody(self) -> list[Motion]:
        return list(self._motions.values())

    def motions(self, actor: str) -> list[Motion]:
        """The motions of a reference's objects."""
        return [self._motions[o.name] for o in self.members(actor) if o.name in self._motions]

    def motion(self, actor: str) -> Motion | None:
        return next(iter(self.motions(actor)), None)

    def contacts(self, one: str, other: str) -> list[ContactFact]:
        """The contacts of two references."""
        pair = {one, other}
        return [c for c in self.facts.contacts if {self.components.get(c.one), self.components.get(c.other)} == pair]

    @property
    def end(self) -> float:
        return self.facts.duration
