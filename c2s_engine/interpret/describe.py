"""One sentence for each component, in plain words (shown in the panes, and the query of the retrieval)."""

from c2s_engine.structure.quantity import high, low
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec, SettingsSpec

POSITIONS = {
    "ahead": "ahead of {of} in the same lane",
    "behind": "behind {of} in the same lane",
    "beside": "beside {of} on the {side}",
    "left_lane": "{along} {of} in the lane to the left",
    "right_lane": "{along} {of} in the lane to the right",
    "oncoming_lane": "in the oncoming lane",
    "crossing_left": "on the road that crosses from the left",
    "crossing_right": "on the road that crosses from the right",
    "opposite_approach": "on the opposite approach of the intersection",
    "roadside": "at the {side} roadside",
    "sidewalk": "on the {side} sidewalk",
    "parked": "parked on the {side}",
    "partly_in_lane": "partly in the lane at its {side} edge",
    "hidden": "out of sight",
    "on_ramp": "on the on-ramp",
    "intersection_exit": "behind the intersection, where ego turns in",
}
ACTIONS = {
    "stationary": "stands still",
    "keep_lane": "keeps its lane",
    "accelerate": "accelerates",
    "brake": "brakes",
    "stop": "stops",
    "wait": "waits",
    "start": "moves off",
    "lane_change": "changes lane",
    "cut_in": "cuts in ahead of {target}",
    "cut_out": "leaves the lane of {target}",
    "overtake": "overtakes {target}",
    "follow": "follows {target}",
    "swerve": "swerves",
    "drift": "drifts out of its lane",
    "turn_left": "turns left",
    "turn_right": "turns right",
    "go_straight": "goes straight on",
    "u_turn": "turns round",
    "cross_road": "crosses the road",
    "move_along": "moves along the road",
    "enter_road": "comes onto the road",
    "leave_road": "leaves the road",
    "reverse": "reverses",
    "oncoming": "gets into the opposite lane",
    "run_red": "runs the red light",
    "run_stop": "runs the stop sign",
    "yield": "gives way to {target}",
    "lose_control": "loses control for a moment",
    "collide": "hits {target}",
}
PLACES = {
    "road": "a road",
    "straight": "a straight road",
    "curve": "a curve",
    "intersection": "an intersection",
    "roundabout": "a roundabout",
    "motorway": "a motorway",
    "on_ramp": "an on-ramp of a motorway",
    "off_ramp": "a motorway exit",
    "crosswalk": "a road with a crosswalk",
}
CONTROLS = {
    "signal": "with traffic lights",
    "stop": "with a stop sign",
    "yield": "with a yield sign",
    "none": "without lights or signs",
}


def km_h(speed) -> str:  # noqa: ANN001
    """A speed for readers."""
    a, b = low(speed) * 3.6, high(speed) * 3.6
    return f"{a:.0f} km/h" if b - a < 0.5 else f"{a:.0f} to {b:.0f} km/h"


def _metres(value) -> str:  # noqa: ANN001
    a, b = low(value), high(value)
    return f"{a:.0f} m" if b - a < 0.5 else f"{a:.0f} to {b:.0f} m"


def _phase(phase: Phase, names: dict[str, str]) -> str:
    target = names.get(phase.target or "ego", phase.target or "ego")
    words = ACTIONS[phase.action].format(target=target if target == "ego" else f"the {target}")
    if phase.action == "brake" and phase.rate and low(phase.rate) >= 4:
        words = "brakes hard"
    if phase.side and phase.action in ("lane_change", "swerve", "drift", "leave_road", "cut_out"):
        words += f" to the {phase.side}"
    if phase.trigger and phase.trigger.value is not None:
        value = low(phase.trigger.value)
        words += {
            "distance": f" at a distance of {value:.0f} m",
            "ttc": f" at a TTC of {value:.1f} s",
            "time": f" after {value:.0f} s",
            "place": f" {value:.0f} m before the {phase.trigger.place}",
        }.get(phase.trigger.kind, "")
    return words


def _steps(phases: tuple[Phase, ...], names: dict[str, str]) -> str:
    steps = [_phase(p, names) for p in phases]
    return ", then ".join(steps)


def obj(spec: ObjectSpec, names: dict[str, str] | None = None) -> str:
    """An object's sentence."""
    names = {"ego": "ego", **{k: v.replace("_", " ") for k, v in (names or {}).items()}}
    place = spec.placement
    along = {"behind": "behind", "abreast": "abreast of"}.get(place.along or "", "ahead of")
    of = names.get(place.of, place.of)
    where = POSITIONS[place.position].format(of=of, side=place.side or "right", along=along)
    many = f"{spec.count} " if spec.count > 1 else "A "
    noun = spec.type.replace("_", " ") + ("s" if spec.count > 1 else "")
    if many == "A " and noun[0] in "aeiou":
        many = "An "
    text = f"{many}{noun} {where}"
    if place.gap is not None:
        text += f", {_metres(place.gap)} away"
    if place.hidden_by:
        text += f", hidden by the {names.get(place.hidden_by, place.hidden_by)}"
    if spec.speed is not None and high(spec.speed) > 0.1:
        text += f", at {km_h(spec.speed)}"
    steps = _steps(spec.phases, names)
    return f"{text}; it {steps}." if steps else f"{text}."


def ego(spec: EgoSpec, place: PlaceSpec, names: dict[str, str] | None = None) -> str:
    """Ego's sentence."""
    names = {"ego": "ego", **{k: v.replace("_", " ") for k, v in (names or {}).items()}}
    text = f"Ego, a {spec.type.replace('_', ' ')},"
    text += (
        f" drives at {km_h(spec.speed)}"
        if spec.speed is not None and high(spec.speed) > 0.1
        else " stands at first"
        if spec.speed is not None
        else " drives"
    )
    steps = _steps(spec.phases, names)
    if steps:
        text += f"; it {steps}"
    target = f" the {names.get(spec.react_to, spec.react_to)}" if spec.react_to else ""
    text += {
        "brake": "; it brakes hard for what comes into its way"
        if spec.hard
        else "; it brakes for what comes into its way",
        "follow": "; it follows who is ahead",
        "yield": f"; it lets{target or ' the other'} pass",
        "evade": "; it gets out of the way",
        "none": "",
    }[spec.reaction]
    return text + "."


def place(spec: PlaceSpec) -> str:
    """The place's sentence."""
    text = PLACES[spec.kind].capitalize()
    if spec.kind == "intersection":
        if spec.arms:
            text = f"An intersection of {spec.arms} roads"
        if spec.control:
            text += f" {CONTROLS[spec.control]}"
        if spec.manoeuvre:
            text += (
                ", where ego "
                + {
                    "left": "turns left",
                    "right": "turns right",
                    "straight": "goes straight on",
                    "u_turn": "turns round",
                }[spec.manoeuvre]
            )
    if spec.curve:
        text += f" to the {spec.curve}"
    if spec.lanes:
        text += (
            f", {spec.lanes} or more lanes in ego's direction" if spec.lanes > 1 else ", one lane in ego's direction"
        )
    if spec.ego_lane:
        text += f", ego in the {spec.ego_lane}"
    if spec.oncoming:
        text += ", with an oncoming lane beside"
    if spec.crosswalk and spec.kind != "crosswalk":
        text += ", with a crosswalk"
    if spec.speed_limit:
        text += f", limit {spec.speed_limit * 3.6:.0f} km/h"
    return text + "."


def settings(spec: SettingsSpec) -> str:
    """The settings' sentence."""
    sky = " and ".join(w.replace("_", " ") for w in spec.weather) or "clear"
    text = f"{sky.capitalize()} weather, {spec.time or 'day'}"
    text += f", map {spec.map}" if spec.map else ""
    text += f", ego's light {spec.light}" if spec.light else ""
    return text + "."
