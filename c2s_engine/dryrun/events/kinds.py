"""What an object is, in the words of FORMAT.md, from its class, its blueprint and its role name."""

from c2s_engine.dryrun.recording import Path

TYPES = {
    "car": ("car", "vehicle"),
    "van": ("van", "vehicle"),
    "truck": ("truck", "vehicle"),
    "pickup": ("pickup", "truck", "vehicle"),
    "bus": ("bus", "vehicle"),
    "motorcycle": ("motorcycle", "vehicle", "vru"),
    "bicycle": ("bicycle", "vru"),
    "walker": ("pedestrian", "vru"),
    "prop": ("obstacle",),
}
DRIVEN = frozenset({"car", "van", "truck", "pickup", "bus", "motorcycle", "bicycle"})
RIDDEN = frozenset({"motorcycle", "bicycle"})
PARTS = {
    "cones": ("constructioncone", "trafficcone"),
    "barrier": ("barrier",),
    "debris": ("debris",),
    "warning_sign": ("trafficwarning",),
}
ROLES = {"cone": "cones", "barrier": "barrier", "debris": "debris", "warning_sign": "warning_sign",
         "construction_sign": "warning_sign"}  # fmt: skip


def types_of(path: Path) -> tuple[str, ...]:
    """Every type that it is."""
    if path.kind == "walker" and path.role.startswith("animal"):
        return ("animal",)
    if path.kind == "walker" and path.role.startswith("thing"):
        return TYPES["prop"]
    return TYPES[path.kind]


def is_vehicle(path: Path) -> bool:
    """A motor vehicle or a bicycle."""
    return path.kind in DRIVEN


def is_vru(path: Path) -> bool:
    """Whether it goes as those on foot do, or rides."""
    return path.kind == "walker" or path.kind in RIDDEN


def temporary_kind(path: Path) -> str | None:
    """cones, barrier, debris or warning_sign, where a prop is one: by its role name, else by its blueprint."""
    if path.kind != "prop":
        return None
    role = path.role.split(":")[0].rstrip("0123456789_")
    if role in ROLES:
        return ROLES[role]
    if role in ("stop_sign", "yield_sign", "speed_sign"):
        return None
    name = path.blueprint.rpartition(".")[2]
    return next((kind for kind, parts in PARTS.items() if any(part in name for part in parts)), None)
