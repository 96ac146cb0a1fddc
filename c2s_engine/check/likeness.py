"""The name that is meant by one that does not exist: spelt otherwise, or what others call it."""

import difflib
from collections.abc import Iterable

_CALLED = {
    "Bike": "Bicycle", "Cyclist": "Bicycle", "Motorbike": "Motorcycle", "Lorry": "Truck", "Walker": "Pedestrian",
    "Person": "Pedestrian", "Adult": "Pedestrian", "Child": "Pedestrian", "TrafficCone": "Cone", "Trashcan": "Trash",
    "TrashCan": "Trash", "Vehicle": "Car", "crosswalks": "crossings", "junctions": "intersections",
    "pavements": "sidewalks", "length_m": "length", "centreline": "centerline", "center_line": "centerline",
}  # fmt: skip
"""What other simulators and people call things of Scenic's."""


def near(name: str, names: Iterable[str]) -> str:
    """The one of `names` that `name` stands for; empty where none is near."""
    known = sorted(names)
    called = _CALLED.get(name, "")
    if called in known:
        return called
    alike = [n for n in known if _plain(n) == _plain(name)]
    close = alike or difflib.get_close_matches(name, known, n=1, cutoff=0.8)
    return close[0] if close else ""


def _plain(name: str) -> str:
    return name.replace("_", "").lower()
