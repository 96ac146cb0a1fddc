"""A model of good character for the scripted server: sensible answers for one scenario, by what is asked."""

import json
import re
from typing import Any

from tests.models.fake_ollama import said

TEXT = (
    "The ego vehicle drives at 50 km/h on a road with two lanes in its direction at night in heavy rain. A van drives "
    "20 m ahead of it in the same lane at 40 km/h and brakes hard when a pedestrian, who is hidden by a parked truck "
    "on the right, steps onto the road 30 m further on. The ego vehicle has to brake in an emergency."
)

COMPONENTS = {
    "settings": "It is night and it rains heavily.",
    "place": "A road with two lanes in ego's direction.",
    "ego": "The ego car drives at 50 km/h and brakes in an emergency for the van.",
    "objects": [
        {"type": "van", "sentence": "A van drives 20 m ahead of ego at 40 km/h and brakes hard for the pedestrian."},
        {"type": "truck", "sentence": "A truck is parked on the right, 45 m ahead of ego."},
        {"type": "pedestrian", "sentence": "A pedestrian hidden by the truck crosses from the right before the van."},
    ],
    "restrictions": "",
}

FORMS: dict[str, Any] = {
    "G": {"weather": {"value": ["heavy_rain"], "confidence": 1}, "time": {"value": "night", "confidence": 1}},
    "R": {"kind": "road", "lanes": 2},
    "E": {"type": "car", "speed": 13.9, "reaction": "brake", "react_to": "O1", "hard": True},
    "O1": {
        "name": "van", "type": "van", "speed": 11.1, "placement": {"position": "ahead", "gap": 20},
        "phases": [{"action": "brake", "rate": 6, "trigger": {"kind": "distance", "value": 25, "of": "O3"}}],
    },
    "O2": {
        "name": "truck", "type": "truck", "speed": 0, "placement": {"position": "parked", "side": "right", "gap": 45},
    },
    "O3": {
        "name": "pedestrian", "type": "pedestrian", "speed": 0,
        "placement": {"position": "sidewalk", "side": "right", "gap": 50, "hidden_by": "O2"},
        "phases": [{"action": "cross_road", "trigger": {"kind": "distance", "value": 30, "of": "O1"}}],
    },
}  # fmt: skip


def asked_of(request: dict[str, Any]) -> str:
    """Which component's form a request asks for; "" for the components themselves."""
    match = re.search(r"Fill in the form for (\w+):", said(request))
    if match:
        return match[1]
    return "G" if "confidence" in json.dumps(request.get("format") or {}) else ""


def sensible(request: dict[str, Any]) -> str:
    """The answer of a good model to a request about TEXT."""
    cid = asked_of(request)
    return json.dumps(FORMS[cid] if cid else COMPONENTS)
