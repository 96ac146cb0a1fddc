"""What S says, in the vocabulary of the benchmark's records, so that it can be compared before anything runs."""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

from collections.abc import Callable

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import high, low, middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec
from c2s_engine.structure.vocabulary import MOTOR, ON_FOOT, VEHICLES

TYPES = {
    "police_car": {"car"}, "ambulance": {"van", "truck"}, "fire_truck": {"truck"}, "pickup": {"truck", "car"}, "child": {"pedestrian"},
}  # fmt: skip
MOVERS = {*VEHICLES, *ON_FOOT}


def types_of(kind: str) -> set[str]:
    """Every type of the records' format that an object type is."""
    found = set(TYPES.get(kind, {kind}))
    if kind in MOTOR:
        found |= {"vehicle"}
    if kind in ("pedestrian", "child", "bicycle", "motorcycle"):
        found.add("vru")
    if kind not in MOVERS:
        found |= {"obstacle"}
    return found | {"any"}


def relations_of(spec: ObjectSpec) -> tuple[set[str], set[str]]:
    """(relations, lanes) that a placement means, seen from its `of`."""
    place, side = spec.placement, spec.placement.side or "right"
    along = {"ahead": "ahead", "behind": "behind", "abreast": "", None: ""}[place.along]
    position = place.position

    def quadrant(lengthwise: str, lateral: str) -> set[str]:
        found = {lateral} if lateral else set()
        if lengthwise:
            found.add(lengthwise)
        if lengthwise and lateral:
            found.add(f"{lengthwise}_{lateral}")
        return found

    simple = {
        "ahead": ({"ahead"}, {"same"}), "behind": ({"behind"}, {"same"}), "beside": (quadrant("", side), {side, "adjacent"}),
        "left_lane": (quadrant(along, "left"), {"left", "adjacent"}), "right_lane": (quadrant(along, "right"), {"right", "adjacent"}),
        "oncoming_lane": (quadrant("ahead", "left"), {"oncoming"}), "crossing_left": (quadrant("ahead", "left"), {"crossing"}),
        "crossing_right": (quadrant("ahead", "right"), {"crossing"}), "opposite_approach": (quadrant("ahead", "left"), {"oncoming"}),
        "roadside": (quadrant(along or "ahead", side), {"roadside"}), "sidewalk": (quadrant(along or "ahead", side), {"roadside", "sidewalk"}),
        "parked": (quadrant(along or "ahead", side), {"roadside"}), "partly_in_lane": (quadrant("ahead", side), {"same"}),
        "on_ramp": (quadrant("ahead", "right"), {"ramp"}), "circulating": (quadrant("ahead", "left"), {"crossing"}), "intersection_exit": ({"ahead"}, {"crossing", "exit"}), "hidden": ({"ahead"}, set()),
    }  # fmt: skip
    return simple[position]


def _actions(spec: ObjectSpec | EgoSpec) -> list[str]:
    return [p.action for p in spec.phases]


def shows(spec: ObjectSpec | EgoSpec, event: str, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
    """Whether the spec says that event (towards that component, where one is named)."""
    test = EVENTS.get(event)
    return test is not None and test(spec, target, place, ego)


def _phase(*actions: str, side: str | None = None) -> Callable[..., bool]:
    def test(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
        return any(
            p.action in actions
            and (side is None or p.side in (None, side))
            and (target is None or p.target in (None, target))
            for p in spec.phases
        )

    return test


def _moves(spec: ObjectSpec | EgoSpec) -> bool:
    acts = set(_actions(spec))
    if isinstance(spec, ObjectSpec) and spec.type not in MOVERS:
        return False
    return not (acts and acts <= {"stationary", "wait"}) and not (
        not acts and spec.speed is not None and high(spec.speed) == 0
    )


def _brakes(hard: bool) -> Callable[..., bool]:
    def test(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
        rates = [p.rate for p in spec.phases if p.action in ("brake", "stop")]
        if isinstance(spec, EgoSpec) and spec.reaction in ("brake", "follow", "yield") and (spec.hard or not hard):
            return True
        if isinstance(spec, EgoSpec) and spec.reaction == "brake" and spec.hard:
            return True
        return any(r is not None and high(r) >= 4 for r in rates) if hard else bool(rates)

    return test


def _stops(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
    return "stop" in _actions(spec) or isinstance(spec, EgoSpec) and spec.reaction in ("brake", "follow", "yield")


def _straight(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
    acts = _actions(spec)
    turns = any(a in ("turn_left", "turn_right", "u_turn") for a in acts)
    if isinstance(spec, EgoSpec):
        return place.manoeuvre == "straight" and not turns
    return (
        not turns
        and _moves(spec)
        and (spec.placement.position.startswith(("crossing", "opposite")) or "go_straight" in acts or "run_red" in acts)
    )


def _crosses(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
    if isinstance(spec, EgoSpec):
        return True
    return _moves(spec) and (
        spec.placement.position.startswith(
            ("crossing", "opposite", "parked", "roadside", "partly", "right_lane", "left_lane", "on_ramp", "ahead")
        )
    )


def _keeps(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
    return _moves(spec) and not any(
        a
        in (
            "lane_change",
            "cut_in",
            "cut_out",
            "overtake",
            "swerve",
            "drift",
            "leave_road",
            "enter_road",
            "oncoming",
            "turn_left",
            "turn_right",
            "u_turn",
        )
        for a in _actions(spec)
    )


def _approaches(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
    return isinstance(spec, ObjectSpec) and ego.phases[:1] != () or True


def _slow(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
    own, other = spec.speed, ego.speed
    return own is not None and (middle(own) <= 8.4 or other is not None and middle(own) < 0.6 * middle(other))


def _stationary(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
    return not _moves(spec)


def _follows(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
    return _phase("follow")(spec, target, place, ego) or isinstance(spec, EgoSpec) and spec.reaction == "follow"


def _yields(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
    if isinstance(spec, EgoSpec) and spec.reaction == "yield" and (target is None or spec.react_to in (None, target)):
        return True
    return _phase("yield")(spec, target, place, ego)


def _turn(side: str) -> Callable[..., bool]:
    def test(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
        return f"turn_{side}" in _actions(spec) or isinstance(spec, EgoSpec) and place.manoeuvre == side

    return test


def _overtakes(spec: ObjectSpec | EgoSpec, target: str | None, place: PlaceSpec, ego: EgoSpec) -> bool:
    if _phase("overtake")(spec, target, place, ego):
        return True
    passing = (
        isinstance(spec, ObjectSpec)
        and spec.placement.along == "behind"
        and spec.speed is not None
        and ego.speed is not None
    )
    return bool(passing and low(spec.speed) > high(ego.speed))  # type: ignore[arg-type]


def _changes(side: str | None) -> Callable[..., bool]:
    return _phase("lane_change", "cut_in", "cut_out", "overtake", side=side)


EVENTS: dict[str, Callable[..., bool]] = {
    "stationary": _stationary, "keep_lane": _keeps, "stop": _stops, "brake": _brakes(False), "brake_hard": _brakes(True),
    "accelerate": _phase("accelerate", "start"), "slow": _slow, "follow": _follows, "approach": _approaches, "lane_change": _changes(None),
    "lane_change_left": _changes("left"), "lane_change_right": _changes("right"), "cut_in": _phase("cut_in", "overtake"), "cut_out": _phase("cut_out"),
    "overtake": _overtakes, "swerve": _phase("swerve", "lose_control"), "drift": _phase("drift"), "turn_left": _turn("left"), "turn_right": _turn("right"),
    "u_turn": _phase("u_turn"), "go_straight": _straight, "cross_path": _crosses, "cross_road": _phase("cross_road"), "walk_along": _phase("move_along"),
    "ride_along": _phase("move_along"), "enter_road": _phase("enter_road", "reverse"), "leave_road": _phase("leave_road"), "oncoming_intrusion": _phase("oncoming", "overtake", "drift"),
    "reverse": _phase("reverse"), "run_red": _phase("run_red"), "run_stop": _phase("run_stop"), "yield": _yields, "hits": _phase("collide"), "passes_first": lambda *a: True,
}  # fmt: skip


def temporary(structure: Structure) -> set[str]:
    """The temporary modifications that S has."""
    kinds = {o.spec.type for o in structure.objects}  # type: ignore[union-attr]
    names = {
        "construction_zone": {"construction_zone", "cones", "warning_sign", "lane_closure"},
        "lane_closure": {"lane_closure", "cones"},
        "cone": {"cones"},
        "barrier": {"barrier"},
        "debris": {"debris"},
        "warning_sign": {"warning_sign"},
    }
    return {n for kind in kinds for n in names.get(kind, ())}
