"""What the installed Scenic offers, read from its files without importing it: classes, behaviours, actions, functions.

The CP blocks of the prompts are made from this, so that they agree with the version that checks the programs.
"""

import ast
import re
from functools import cache
from importlib.metadata import distribution
from pathlib import Path

_DRIVING = "scenic/domains/driving"
_CARLA = "scenic/simulators/carla"


@cache
def _source(path: str) -> str:
    return Path(str(distribution("scenic").locate_file(path))).read_text(encoding="utf-8")


@cache
def _classes(path: str) -> dict[str, ast.ClassDef]:
    return {n.name: n for n in ast.parse(_source(path)).body if isinstance(n, ast.ClassDef)}


def _scenic_classes(path: str) -> dict[str, list[str]]:
    """Class -> its bases, of a .scenic file."""
    found = re.findall(r"^class (\w+)(?:\(([^)]*)\))?:", _source(path), re.M)
    return {name: [b.strip() for b in bases.split(",") if b.strip()] for name, bases in found}


def version() -> str:
    return distribution("scenic").version


@cache
def road_elements() -> dict[str, list[str]]:
    """Each class of the road network with what it offers: public fields and properties, without those inherited."""
    found: dict[str, list[str]] = {}
    for name, node in _classes(f"{_DRIVING}/roads.py").items():
        if name.startswith("_") or name in ("Signal",):
            continue
        fields = [n.target.id for n in node.body if isinstance(n, ast.AnnAssign) and isinstance(n.target, ast.Name)]
        methods = [
            n.name if _is_property(n) else f"{n.name}({', '.join(a.arg for a in n.args.args[1:])})"
            for n in node.body
            if isinstance(n, ast.FunctionDef)
        ]
        names = [n for n in (*fields, *methods) if not n.startswith("_") and n.split("(")[0] not in _INTERNAL]
        found[name] = list(dict.fromkeys(names))
    return found


_INTERNAL = {
    "uid", "id", "name", "tags", "network", "polygon", "openDriveID", "lanesByOpenDriveID", "tolerance", "elements",
    "fromFile", "fromOpenDrive", "fromPickle", "dumpPickle", "show", "pickledExt", "connectingRoads", "allRoads",
    "nominalDirectionsAt", "clone", "vehicleTypes", "speedLimit", "country", "type_", "findPointIn", "distanceTo",
    "defaultHeadingAt", "shiftLanes", "flowFrom", "orientation", "guessTypeFromLanes", "centerlineSegmentTree",
}  # fmt: skip


def _is_property(node: ast.FunctionDef) -> bool:
    return any(getattr(d, "id", "") == "property" for d in node.decorator_list)


def road_hierarchy() -> str:
    """`NetworkElement -> LinearElement -> {Road, Lane, ...}`, from the classes' bases."""
    classes = _classes(f"{_DRIVING}/roads.py")
    below: dict[str, list[str]] = {}
    for name, node in classes.items():
        for base in node.bases:
            base_name = getattr(base, "id", "")
            if not name.startswith("_") and base_name in classes and not base_name.startswith("_"):
                below.setdefault(base_name, []).append(name)

    def tree(name: str) -> str:
        children = below.get(name, [])
        return f"{name} -> {{{', '.join(tree(c) for c in children)}}}" if children else name

    return tree("NetworkElement")


def maneuver_types() -> list[str]:
    """The names of ManeuverType."""
    node = _classes(f"{_DRIVING}/roads.py")["ManeuverType"]
    return [n.targets[0].id for n in node.body if isinstance(n, ast.Assign) and isinstance(n.targets[0], ast.Name)]


def object_classes() -> dict[str, list[str]]:
    """Vehicles, persons and props of the CARLA model."""
    classes = _scenic_classes(f"{_CARLA}/model.scenic")
    vehicles = [n for n, bases in classes.items() if "Vehicle" in bases and n != "Vehicle"]
    props = [n for n, bases in classes.items() if "Prop" in bases]
    return {"vehicles": vehicles, "persons": ["Pedestrian"], "props": props}


def behaviours() -> list[str]:
    """The signatures of the library's behaviours that work in CARLA, the more specific file's first."""
    found: dict[str, str] = {}
    for path in (f"{_CARLA}/behaviors.scenic", f"{_DRIVING}/behaviors.scenic"):
        for name, parameters in re.findall(r"^behavior (\w+)\(([^)]*)\):", _source(path), re.M):
            found.setdefault(name, f"{name}({', '.join(p.strip() for p in parameters.split(',') if p.strip())})")
    return [s for n, s in found.items() if n not in ("AccelerateForwardBehavior", "WalkForwardBehavior")]


def actions() -> list[str]:
    """The actions that an agent can take, with their arguments."""
    found: dict[str, str] = {}
    for path in (f"{_CARLA}/actions.py", f"{_DRIVING}/actions.py"):
        for name, node in _classes(path).items():
            if not name.endswith("Action") or name in _BASE_ACTIONS:
                continue
            init = next((n for n in node.body if isinstance(n, ast.FunctionDef) and n.name == "__init__"), None)
            arguments = [a.arg for a in init.args.args[1:]] if init else []
            found.setdefault(name, f"{name}({', '.join(arguments)})")
    return list(found.values())


_BASE_ACTIONS = {
    "SteeringAction", "VehicleAction", "PedestrianAction", "WalkingAction", "SetTransformAction",
    "SetManualFirstGearShiftAction", "SetManualGearShiftAction", "SetGearAction", "TrackWaypointsAction",
    "SetVehicleLightStateAction", "SetAngularVelocityAction", "SetJumpAction", "OffsetAction", "SetWalkAction",
}  # fmt: skip


def functions() -> list[str]:
    """The model's functions, with their arguments."""
    found: list[str] = []
    for path in (f"{_DRIVING}/model.scenic", f"{_CARLA}/model.scenic"):
        for name, arguments in re.findall(r"^def (\w+)\(([^)]*)\):", _source(path), re.M):
            if not name.startswith("_") and name != "is2DMode":
                found.append(f"{name}({arguments})")
    return found


def names() -> frozenset[str]:
    """Every name that a program may use from the model without defining it."""
    classes = object_classes()
    signatures = [*behaviours(), *actions(), *functions()]
    return frozenset(
        [*classes["vehicles"], *classes["persons"], *classes["props"], *(s.split("(")[0] for s in signatures)]
    )
