"""Speeds that words say: data/paces.yaml, by kind of road user and, for drivers, the limit of the road."""

from functools import cache
from typing import Any

import yaml

from c2s_engine import paths
from c2s_engine.structure.quantity import Range
from c2s_engine.structure.specs import PlaceSpec


@cache
def table() -> dict[str, Any]:
    """data/paces.yaml."""
    return yaml.safe_load(paths.shipped("paces.yaml").read_text("utf-8"))


def row(kind: str, pace: str) -> dict[str, Any] | None:
    """What the table says of a type of road user at a pace; None: it has no such pace."""
    group = next((g for g, types in table()["kinds"].items() if kind in types), "")
    return table()["paces"][pace].get(group)


def paces_of(kind: str) -> list[str]:
    """The paces that a type of road user has."""
    return [name for name in table()["paces"] if row(kind, name) is not None]


def speed_at(kind: str, pace: str, place: PlaceSpec) -> Range | None:
    """m/s from and to; None where the type has no such pace."""
    found = row(kind, pace)
    if found is None:
        return None
    if "speed" in found:
        return tuple(found["speed"])
    limits = table()["limits"]
    limit = place.speed_limit or limits.get(place.kind, limits["else"])["value"]
    low, high = found["limit"]
    return round(low * limit, 1), round(high * limit, 1)
