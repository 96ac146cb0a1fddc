"""The closed vocabulary of the specs: the names. Their meanings stand in data/vocabulary.yaml.

A test holds that both list the same names; schema, prompts and documentation take the meanings from there.
"""

from typing import Literal, get_args

VehicleType = Literal[
    "car", "truck", "pickup", "van", "bus", "police_car", "ambulance", "fire_truck", "motorcycle", "bicycle"
]
VEHICLES: tuple[VehicleType, ...] = get_args(VehicleType)
MOTOR: tuple[VehicleType, ...] = tuple(v for v in VEHICLES if v != "bicycle")
FOUR_WHEELED: tuple[VehicleType, ...] = tuple(v for v in MOTOR if v != "motorcycle")
WITH_SIREN: frozenset[VehicleType] = frozenset(("police_car", "ambulance", "fire_truck"))
SIDED = ("beside", "roadside", "sidewalk", "parked", "partly_in_lane", "intersection_exit")
"""Positions that have a side."""
ON_FOOT = frozenset(("pedestrian", "child", "animal"))
ObjectType = Literal[
    VehicleType,
    "pedestrian", "child", "animal",
    "cone", "barrier", "debris", "warning_sign", "stop_sign", "yield_sign", "speed_sign",
    "construction_zone", "lane_closure",
    "obstacle", "container", "trash", "box", "bench", "bus_stop", "kiosk", "vending_machine", "plant_pot", "barrel",
    "building", "wall", "hedge", "pole", "tree", "guard_rail", "billboard", "toll_booth", "slippery_patch",
]  # fmt: skip

PlaceKind = Literal[
    "road", "straight", "curve", "intersection", "roundabout", "motorway", "on_ramp", "off_ramp", "crosswalk"
]
Control = Literal["signal", "stop", "yield", "none"]
Manoeuvre = Literal["left", "right", "straight", "u_turn"]
EgoLane = Literal["leftmost", "middle", "rightmost"]

Position = Literal[
    "ahead", "behind", "beside", "left_lane", "right_lane", "oncoming_lane",
    "crossing_left", "crossing_right", "opposite_approach", "circulating",
    "roadside", "sidewalk", "parked", "partly_in_lane", "on_ramp", "intersection_exit",
]  # fmt: skip
Side = Literal["left", "right"]
TOWARDS_EGO: dict[str, Side] = {"left_lane": "right", "right_lane": "left"}
"""From a lane beside ego's, the side on which ego's is."""
Part = Literal["front", "rear", "left", "right", "front_left", "front_right", "rear_left", "rear_right"]
Along = Literal["ahead", "abreast", "behind"]

Action = Literal[
    "stationary", "keep_lane", "accelerate", "brake", "stop", "wait", "start",
    "lane_change", "cut_in", "cut_out", "overtake", "follow", "swerve", "drift",
    "turn_left", "turn_right", "go_straight", "u_turn",
    "cross_road", "move_along", "enter_road", "leave_road", "reverse", "oncoming",
    "run_red", "run_stop", "yield", "lose_control", "collide",
]  # fmt: skip

Pace = Literal[
    "crawl", "walking_pace", "slow", "below_limit", "at_limit", "over_limit", "far_over_limit", "fast", "too_fast",
    "stroll", "walk", "jog", "run", "sprint",
]  # fmt: skip

TriggerKind = Literal[
    "distance", "apart", "ttc", "time", "place", "action", "passed", "speed", "light", "seen", "contact"
]
TriggerPlace = Literal[
    "intersection", "stop_line", "in_intersection", "past_intersection", "crosswalk", "bend", "merge_end"
]
Reaction = Literal["brake", "follow", "yield", "evade", "none"]

Weather = Literal["clear", "cloudy", "wet", "rain", "heavy_rain", "fog", "snow", "wind"]
TimeOfDay = Literal["day", "dawn", "dusk", "night"]
LightState = Literal["red", "yellow", "green", "flashing", "dark"]
ConditionKind = Literal[
    "distance", "closest", "visible", "not_visible", "time", "travelled", "collision", "stopped", "action"
]

LimitKind = Literal[
    "speed", "acceleration", "deceleration", "lateral_acceleration", "jerk", "gap", "ttc", "collision",
]  # fmt: skip

Origin = Literal["rendered", "generated", "by_hand", "imported"]
