"""Tables that the writer reads from data/writer.yaml: classes, blueprints, lengths, usual speeds."""

from typing import Any

import yaml

from c2s_engine import driving
from c2s_engine.paths import shipped
from c2s_engine.structure.quantity import high
from c2s_engine.structure.specs import ObjectSpec, Spec
from c2s_engine.structure.vocabulary import ON_FOOT, VEHICLES

_TABLES: dict[str, Any] = yaml.safe_load(shipped("writer.yaml").read_text())

CLASS: dict[str, str] = {k: v["class"] for k, v in _TABLES["types"].items()}
NAMED_BLUEPRINTS: dict[str, str] = {
    k: v["blueprints"] for k, v in _TABLES["types"].items() if isinstance(v.get("blueprints"), str)
}
"""The list of the driving library that has a type's blueprints, where they are several."""
BLUEPRINTS: dict[str, list[str]] = {
    k: driving.constants()[NAMED_BLUEPRINTS[k]] if k in NAMED_BLUEPRINTS else v["blueprints"]
    for k, v in _TABLES["types"].items()
}
LENGTH: dict[str, float] = {k: v["length"] for k, v in _TABLES["types"].items()}
OBSTRUCTING: dict[str, str] = _TABLES["obstructing"]
HEIGHT: dict[str, float] = {k: v["height"] for k, v in _TABLES["types"].items() if v.get("height")}
"""m, of what another prop stands in for at another size."""
USUAL_HEIGHT = 1.0
"""m, of a thing that moves, whose height is not in the tables."""
ROLLING: dict[str, str] = _TABLES["rolling"]
"""What stands in for a thing that moves: class, blueprint, role name."""
NOTE: dict[str, str] = {k: v["note"] for k, v in _TABLES["types"].items() if v.get("note")}
"""What more is to be said of what stands in."""
WIDTH: dict[str, float] = {k: v["width"] for k, v in _TABLES["types"].items()}
ROLE: dict[str, str] = {k: v["role"] for k, v in _TABLES["types"].items() if v.get("role")}
DEFAULT_SPEED: dict[str, dict[str, float]] = _TABLES["speeds"]
WEATHER: dict[str, dict[str, float]] = _TABLES["weather"]
SUN: dict[str, float] = _TABLES["sun"]
RESERVED: frozenset[str] = frozenset(_TABLES["reserved"]) | driving.names()
WORKS = {"construction_zone", "lane_closure"}
AT_REST = {"stationary", "wait", "stop"}
"""What those do who lie or stand where they are."""
NEXT_LANES = {"left_lane", "right_lane"}
"""Where those start who drive in a lane beside that of ego."""
FLAT = {"slippery_patch"}
"""What one drives over."""
MOVES_OFF_ROAD = {"roadside", "sidewalk", "parked"}
JUNCTION = {"intersection", "roundabout"}
RAMP = {"on_ramp", "off_ramp"}
LANE_WIDTH = 3.5
"""m, of most maps' lanes."""
HALF_LANE = 1.7
"""m from the middle of a lane within which one is in it."""
APPROACH_ANGLE = {"crossing_left": -90, "crossing_right": 90, "opposite_approach": 180, "circulating": -90}
TIMED = {*APPROACH_ANGLE, "intersection_exit", "on_ramp"}
"""Positions whose start follows from when they meet ego."""
SIDE = {"crossing_left": "left", "crossing_right": "right", "opposite_approach": "opposite", "circulating": "ring"}
APPROACH_NAME = {position: f"place.from_{side}" for position, side in SIDE.items()}
LANE_NAME = {
    -2: "place.far_right_lane", -1: "place.right_lane", 0: "place.lane", 1: "place.left_lane", 2: "place.far_left_lane",
}  # fmt: skip
TURN = {"turn_left": "LEFT_TURN", "turn_right": "RIGHT_TURN", "go_straight": "STRAIGHT", "u_turn": "U_TURN"}
RUNS = {"run_red", "run_stop"}
"""What one does that passes its light or its sign."""
BEARING = {"left": "90 deg", "right": "-90 deg", "u_turn": "180 deg"}
"""Where ego leaves a roundabout, to the left of where it came from."""


def is_vehicle(kind: str) -> bool:
    """Whether it drives or rides (bicycles included)."""
    return kind in VEHICLES


def is_walker(spec: Spec | None) -> bool:
    """Whether it goes as people do: those on foot, animals, and things that move (`is_rolling`)."""
    return getattr(spec, "type", None) in ON_FOOT or is_rolling(spec)


def is_rolling(spec: Spec | None) -> bool:
    """Whether it is a thing that rolls, slides or is blown along: props of CARLA do not, so a walker stands in."""
    if not isinstance(spec, ObjectSpec) or is_vehicle(spec.type) or spec.type in {*ON_FOOT, *WORKS, *FLAT}:
        return False
    return not {p.action for p in spec.phases} <= AT_REST


def is_static(spec: ObjectSpec) -> bool:
    """Whether the object never moves."""
    if not (is_vehicle(spec.type) or is_walker(spec)):
        return True
    if spec.phases:
        return all(p.action == "stationary" for p in spec.phases)
    stated = spec.speed is not None and high(spec.speed) > 0
    return spec.placement.position in ("parked", "partly_in_lane") and not stated
