"""Places as calls of the driving library: the one source for what a PlaceSpec selects, in programs and in counts.

    place_call(spec, approach=60)    # -> Call: junctions(LEFT_TURN, arms=4, control='signal', approach=60)

The call lists all places of whatever map the program has (data/driving/c2s_driving.scenic says what each means); it
names no road, no junction and no map, so that a program samples on every map that has such a place.
"""

from dataclasses import dataclass
from functools import cache
from typing import Any

import yaml

from c2s_engine import paths
from c2s_engine.structure.quantity import high
from c2s_engine.structure.specs import PlaceSpec

FAST = 24.0
"""m/s: from this limit on a plain road may be a carriageway of a motorway."""
MARGIN = 15.0
"""m of approach beyond the distance that a spec asks for."""
FUNCTION = {
    "road": "stretches", "straight": "stretches", "curve": "curves", "motorway": "motorways",
    "crosswalk": "crosswalks", "intersection": "junctions", "roundabout": "roundabouts", "on_ramp": "merges",
    "off_ramp": "exits",
}  # fmt: skip
MANOEUVRE_TYPE = {"left": "LEFT_TURN", "right": "RIGHT_TURN", "straight": "STRAIGHT", "u_turn": "U_TURN"}
"""Scenic's name of the way by which ego leaves a junction."""
STRETCHES = ("road", "straight", "curve", "motorway")


@dataclass(frozen=True)
class Call:
    """A call of the library, its arguments apart so that they can be set on lines."""

    function: str
    arguments: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.function}({', '.join(self.arguments)})"

    def lines(self, before: str, after: str, width: int = 100) -> list[str]:
        """The call in lines of at most `width` characters, between what comes before and after it."""
        rows = [f"{before}{self.function}("]
        for i, argument in enumerate(self.arguments):
            more = argument + (f"){after}" if i == len(self.arguments) - 1 else ", ")
            if len(rows[-1]) + len(more.rstrip()) > width:
                rows[-1] = rows[-1].rstrip()
                rows.append("    ")
            rows[-1] += more
        if not self.arguments:
            rows[-1] += f"){after}"
        return rows


def place_call(
    spec: PlaceSpec,
    *,
    length: float = 0.0,
    min_length: float = 0.0,
    approach: float = 0.0,
    exit_room: float = 0.0,
    others: tuple[str, ...] = (),
    more: dict[str, str] | None = None,
) -> Call:
    """The call for a place.

    `length`, `min_length` (m): of a stretch, wanted and needed; `approach`, `exit_room` (m): before and behind a
    junction, ramp or crosswalk; `others`: calls of `From`; `more`: further arguments.
    """
    if spec.distance is not None:
        approach = max(approach, high(spec.distance) + MARGIN)
    first, named = _kind(spec)
    if spec.kind in STRETCHES:
        named |= {"length": _metres(length), "min_length": _metres(min_length)}
    elif spec.kind == "crosswalk":
        named["before"] = _metres(approach)
    else:
        named |= {"approach": _metres(approach), "exit": _metres(exit_room)}
    if spec.lanes and spec.lanes > 1:
        named["lanes"] = str(spec.lanes)
    for name in ("ego_lane", "oncoming", "shoulder", "sidewalk"):
        if (value := getattr(spec, name)) is not None:
            named[name] = repr(value)
    if spec.speed_limit is not None:
        named["limit"] = f"{round(spec.speed_limit * 3.6)} / 3.6"
    named |= more or {}
    if others:
        named["others"] = f"[{', '.join(others)}]"
    return Call(FUNCTION[spec.kind], (*first, *(f"{k}={v}" for k, v in named.items() if v)))


def _kind(spec: PlaceSpec) -> tuple[tuple[str, ...], dict[str, str]]:
    """What a kind alone asks for: positional and named arguments."""
    named: dict[str, str] = {}
    first: tuple[str, ...] = ()
    if spec.kind == "straight":
        named["straight"] = "True"
    if spec.kind == "curve" and spec.curve:
        first = (repr(spec.curve),)
    if spec.kind in ("road", "straight", "curve") and not _two_way(spec):
        named["two_way"] = "False"
    if spec.kind in ("road", "straight", "intersection") and spec.crosswalk is not None:
        named["crosswalk"] = repr(spec.crosswalk)
    if spec.kind == "intersection":
        first = (MANOEUVRE_TYPE[spec.manoeuvre],) if spec.manoeuvre else ()
        named |= {"arms": str(spec.arms or ""), "control": repr(spec.control) if spec.control else ""}
    along = spec.ego_lane in ("leftmost", "middle") or (spec.kind == "on_ramp" and (spec.lanes or 1) > 1)
    if spec.kind in ("on_ramp", "off_ramp") and along:
        named["ego_on"] = "'road'"
    return first, named


def survey() -> dict[str, str]:
    """What is counted on a map for its overview: name -> call."""
    return {name: str(place_call(PlaceSpec(**fields))) for name, fields in _survey().items()}


@cache
def _survey() -> dict[str, Any]:
    return yaml.safe_load(paths.shipped("maps", "places.yaml").read_text(encoding="utf-8"))["survey"]


def relaxed(spec: PlaceSpec) -> dict[str, PlaceSpec]:
    """The specs that leave out one field, by the field's name: where a place is missing, one of them may be near."""
    kept = {"component", "kind"}
    return {
        name: spec.model_copy(update={name: None})
        for name in type(spec).model_fields
        if name not in kept and getattr(spec, name) is not None
    }


def _two_way(spec: PlaceSpec) -> bool:
    """Whether a plain road means one with both directions: motorways and ramps are asked for by kind or by fields."""
    return spec.oncoming is not False and (spec.lanes or 1) < 3 and (spec.speed_limit or 0.0) < FAST


def _metres(value: float) -> str:
    """A length of a place as an argument; nothing for none."""
    return f"{value:.0f}" if value else ""
