"""Parts of a spec in one line of plain words: where an object starts, what a step does and what it waits for."""

from collections.abc import Callable
from typing import Any

from c2s_engine.structure.event_words import ACTS

Text = Callable[[Any, str], str]
"""A value with its unit, as text."""
OPEN = {"distance": "when {of} is near", "ttc": "when {of} is near", "apart": "when {who} is far enough from {of}",
        "speed": "when {who} goes at some speed", "time": "some time after the start"}  # fmt: skip
"""Triggers whose value is left open, by kind."""
EMPTY: tuple[Any, ...] = (None, [], {}, "")
WHERE = {
    "left_lane": "in the lane to the left", "right_lane": "in the lane to the right", "ahead": "", "behind": "",
    "oncoming_lane": "in the oncoming lane", "beside": "beside", "roadside": "at the roadside",
    "sidewalk": "on the sidewalk", "parked": "parked", "partly_in_lane": "partly in the lane",
    "circulating": "in the roundabout",
    "crossing_left": "on the road from the left", "crossing_right": "on the road from the right",
    "opposite_approach": "on the opposite approach", "intersection_exit": "at the intersection's exit",
}  # fmt: skip
APPROACHES = ("crossing_left", "crossing_right", "opposite_approach")


def placement(part: dict[str, Any], text: Text) -> str:
    """`in the lane to the left, 15 m ahead of ego`."""
    position, of = part.get("position") or "ahead", part.get("of") or "ego"
    where = WHERE.get(position, position.replace("_", " "))
    side = f"on the {part['side']}" if part.get("side") else ""
    along = part.get("along") or ("behind" if position == "behind" else "ahead")
    gap = text(part["gap"], "m") if part.get("gap") is not None else ""
    if position in APPROACHES:
        lengthwise = f"{gap} before the intersection" if gap else ""
    elif position == "ahead" or gap or part.get("along"):
        lengthwise = {"abreast": f"level with {of}", "behind": f"{gap} behind {of}"}.get(along, f"{gap} ahead of {of}")
    elif position == "beside":
        where, lengthwise = f"beside {of}", ""
    else:
        lengthwise = f"behind {of}" if position == "behind" else f"of {of}" if of != "ego" else ""
    more = [f"hidden by {part['hidden_by']}" if part.get("hidden_by") else "",
            f"facing {part['facing'].replace('_', ' ')}" if part.get("facing") else ""]  # fmt: skip
    return ", ".join(p for p in (" ".join(filter(None, (where, side))), lengthwise.strip(), *more) if p)


def phase(part: dict[str, Any], text: Text) -> str:
    """`cuts in ahead of ego to the right, when ego is 25 m away`."""
    target = part.get("target") or ""
    words = [ACTS.get(part["action"], part["action"].replace("_", " "))]
    if target:
        words[0] = f"{words[0]} ({target})"
    if part.get("side"):
        words.append(f"to the {part['side']}")
    for name, unit, before in (("speed", "m/s", "at"), ("rate", "m/s2", "with"), ("duration", "s", "for")):
        if part.get(name) not in EMPTY:
            words.append(f"{before} {text(part[name], unit)}")
    waits = trigger(part["trigger"], text) if part.get("trigger") else ""
    return " ".join(words) + (f", {waits}" if waits else "")


def trigger(part: dict[str, Any], text: Text) -> str:
    """`when ego is 25 m away`, `once O1 cuts in, and 2 s later`."""
    delay = part.get("delay")
    return _event(part, text) + (f", and {text(delay, 's')} later" if delay not in EMPTY else "")


def _event(part: dict[str, Any], text: Text) -> str:
    of, value = part.get("of") or "the other", part.get("value")
    who = part.get("subject") or "it"
    if value in EMPTY and part["kind"] in OPEN:
        return OPEN[part["kind"]].format(who=who, of=of)
    if part["kind"] == "apart":
        return f"when {who} is as far as {text(value, 'm')} from {of}"
    if part["kind"] == "speed":
        return f"when {who} goes at {text(value, 'm/s')}"
    if part["kind"] in ("passed", "seen", "contact"):
        words = {"passed": f"{who} has gone by {of}", "seen": f"{who} can see {of}", "contact": f"{who} and {of} touch"}
        return f"when {words[part['kind']]}"
    if part["kind"] == "light":
        return f"when the light before {who} is {part.get('light') or 'another'}"
    if part["kind"] == "distance":
        return f"when {of} is {text(value, 'm')} away"
    if part["kind"] == "ttc":
        return f"when the time to collision with {of} is {text(value, 's')}"
    if part["kind"] == "time":
        return f"{text(value, 's')} after the start"
    if part["kind"] == "place":
        where = (part.get("place") or "place").replace("_", " ")
        return f"{text(value, 'm')} before the {where}" if value else f"at the {where}"
    action = part.get("action") or ""
    return f"once {of} {ACTS.get(action, action.replace('_', ' '))}"
