"""What a run leaves behind: every object's way, as arrays, and what happened on it."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np


@dataclass
class Path:
    """One object's way: m, rad, m/s (speed signed: backwards is negative; vx, vy in the world's frame)."""

    name: str
    kind: str
    blueprint: str
    role: str
    length: float
    width: float
    height: float
    x: np.ndarray
    y: np.ndarray
    heading: np.ndarray
    vx: np.ndarray
    vy: np.ndarray

    @property
    def speed(self) -> np.ndarray:
        """m/s, never negative."""
        return np.hypot(self.vx, self.vy)

    @property
    def forward(self) -> np.ndarray:
        """m/s along the heading."""
        return -np.sin(self.heading) * self.vx + np.cos(self.heading) * self.vy

    @property
    def xy(self) -> np.ndarray:
        return np.column_stack([self.x, self.y])


@dataclass
class Recording:
    """A whole run. `contacts`: (time, index, index); `lights`: (time, junction, road, state) as changes."""

    step: float
    paths: list[Path]
    contacts: list[tuple[float, int, int]] = field(default_factory=list)
    lights: list[tuple[float, str, str, str]] = field(default_factory=list)
    params: dict[str, Any] = field(default_factory=dict)
    terminated: bool = False

    @property
    def steps(self) -> int:
        return len(self.paths[0].x) if self.paths else 0

    @property
    def time(self) -> np.ndarray:
        return np.arange(self.steps) * self.step


class Recorder:
    """Collects the samples while a run goes on."""

    def __init__(self, step: float) -> None:
        self.step = step
        self.samples: list[list[tuple[float, float, float, float, float]]] = []
        self.lights: list[tuple[float, str, str, str]] = []
        self._shown: dict[tuple[str, str], str] = {}
        self.first: list[int] = []

    def sample(self, actors: list[Any], step: int) -> None:
        while len(self.samples) < len(actors):
            self.samples.append([])
            self.first.append(step)
        for samples, actor in zip(self.samples, actors, strict=True):
            body = actor.body
            vx, vy = body.velocity()
            samples.append((body.x, body.y, body.heading, vx, vy))

    def restart(self, actors: list[Any]) -> None:
        """Take the first sample's speeds anew, as the first actions set them; its places stand."""
        for samples, actor in zip(self.samples, actors, strict=False):
            samples[0] = (*samples[0][:3], *actor.body.velocity())

    def note_lights(self, time: float, states: dict[tuple[str, str], str]) -> None:
        """What the lights show from a time on, s; what a program's first step makes them show is so from the start."""
        if 0.0 < time <= self.step:
            self.lights, self._shown, time = [], {}, 0.0
        for key, state in states.items():
            if self._shown.get(key) != state:
                self._shown[key] = state
                self.lights.append((time, *key, state))

    def finish(self, actors: list[Any], names: list[str], kinds: list[str]) -> Recording:
        """All paths at one length: who came later stands where it came in; who came as the run ended has none."""
        paths = []
        steps = max((len(s) + f for s, f in zip(self.samples, self.first, strict=True)), default=0)
        for samples, first, actor, name, kind in zip(self.samples, self.first, actors, names, kinds, strict=False):
            rows = np.array([(*samples[0][:3], 0.0, 0.0)] * first + samples, dtype=float)[:steps]
            length, width, height = actor.size
            paths.append(Path(name, kind, actor.type_id, actor.attributes["role_name"], length, width, height, *rows.T))
        return Recording(self.step, paths, lights=self.lights)
