"""The manoeuvres (data/calibration.yaml), each a program with what is measured of its run."""

from dataclasses import dataclass
from functools import cache
from typing import Any

import yaml

from c2s_engine.calibrate.measures import MEASURES, way_of
from c2s_engine.maps.library import MapFile
from c2s_engine.paths import shipped
from c2s_engine.structure.facts import Trajectories


@dataclass(frozen=True)
class Measure:
    """One number of a run: of ego (0) or of the other (1)."""

    name: str
    argument: float | None
    who: int

    @property
    def description(self) -> str:
        label = MEASURES[self.name][0].format(self.argument)
        return f"other: {label}" if self.who else label

    @property
    def unit(self) -> str:
        return MEASURES[self.name][1]

    def of(self, found: Trajectories) -> float | None:
        """Its value; None where the run did not come to that."""
        given = () if self.argument is None else (self.argument,)
        return MEASURES[self.name][2](way_of(found, self.who), *given)


@dataclass(frozen=True)
class Manoeuvre:
    """What is driven for `seconds` s, and what is compared of it."""

    name: str
    about: str
    seconds: float
    body: str
    measures: tuple[Measure, ...]

    def program(self, on: MapFile) -> str:
        """Its Scenic program on a map."""
        head: str = _data()["head"].format(map=on.path.name, carla_map=repr(on.carla_map))
        return f"{head}\n{self.body}"


def manoeuvres() -> dict[str, Manoeuvre]:
    """All of them, by name."""
    return {name: _manoeuvre(name, row) for name, row in _data()["manoeuvres"].items()}


@cache
def _data() -> dict[str, Any]:
    return yaml.safe_load(shipped("calibration.yaml").read_text(encoding="utf-8"))


def _manoeuvre(name: str, row: dict[str, Any]) -> Manoeuvre:
    measures = []
    for measure in row["measures"]:
        (what, argument), who = next(iter(measure.items())), measure.get("of") == "other"
        measures.append(Measure(what, argument, int(who)))
    return Manoeuvre(name, row["about"], row["seconds"], row["program"], tuple(measures))
