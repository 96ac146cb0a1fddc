"""How far behind ego one starts that runs into it, in closed form from how both drive: it never looks, and keeps its
speed; the hit comes since ego has slowed down."""

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec
from c2s_engine.write.typed.tables import JUNCTION, is_static, is_vehicle
from c2s_engine.write.typed.threats import hits_ego
from c2s_engine.write.typed.usual import UNDISTURBED, default_gap, speed_of

FASTER = 4.0
"""m/s by which one is faster that runs into another which does not slow down."""
CATCHES_UP = 5.0
"""s that it then drives behind it."""
STANDS = 1.2
"""s that ego stands or holds its lower speed when it is struck from behind."""
RATE = {"stop": 3.5, "brake": 3.0, "reaction": 5.0}
HARD = 7.0
"""m/s2 at which ego slows down."""


def solved(structure: Structure) -> Structure:
    """S with the gaps, where they are open, of those who run into ego from behind."""
    place, ego = structure.place.spec, structure.ego.spec
    assert isinstance(place, PlaceSpec) and isinstance(ego, EgoSpec)
    for component in structure.objects:
        spec = component.spec
        if not isinstance(spec, ObjectSpec) or not is_vehicle(spec.type) or is_static(spec):
            continue
        at = spec.placement
        if not hits_ego(spec) or at.of != "ego" or at.gap is not None:
            continue
        if at.position == "behind":
            found = _from_behind(structure, spec, ego, place)
            structure = structure.with_spec(component.id, found)
    return structure


def _from_behind(structure: Structure, spec: ObjectSpec, ego: EgoSpec, place: PlaceSpec) -> ObjectSpec:
    """One that runs into ego from behind: at its speed all along, so far behind that it comes once ego has slowed."""
    own = middle(speed_of(ego, place))
    slows = _slows(structure, ego, place, own)
    if slows is None:
        speed = max(middle(spec.speed) if spec.speed is not None else 0.0, own + FASTER)
        gap = (speed - own) * CATCHES_UP
    else:
        begin, rate, slower = slows
        speed = middle(spec.speed) if spec.speed is not None else max(own, 8.0)
        braking = (own - slower) / rate
        until = begin + braking + STANDS
        gap = speed * until - own * begin - (own + slower) / 2 * braking - slower * STANDS
    changes = {"gap": round(max(gap, 3.0), 1)}
    stated = spec.speed if spec.speed is not None and middle(spec.speed) == speed else round(speed, 2)
    return spec.model_copy(update={"speed": stated, "placement": spec.placement.model_copy(update=changes)})


def _slows(structure: Structure, ego: EgoSpec, place: PlaceSpec, own: float) -> tuple[float, float, float] | None:
    """When (s), how hard (m/s2) and to what speed (m/s) ego slows down; None: it does not."""
    if own <= 0:
        return (0.0, 1.0, 0.0)
    for phase in ego.phases:
        if phase.action not in ("stop", "brake", "wait", "yield"):
            continue
        rate = middle(phase.rate) if phase.rate else HARD if ego.hard else RATE.get(phase.action, 3.0)
        slower = middle(phase.speed) if phase.speed is not None else own / 2 if phase.action == "brake" else 0.0
        if phase.trigger is not None and phase.trigger.kind == "time" and phase.trigger.value is not None:
            return (middle(phase.trigger.value), rate, slower)
        if place.kind in JUNCTION and phase.action != "brake":
            far = middle(place.distance) if place.distance is not None else 4 * own
            return (max((far - 4) / own - own / (2 * rate), 0.5), rate, slower)
        if ego.reaction == "none":
            return (UNDISTURBED, rate, slower)
    if ego.reaction not in ("brake", "yield"):
        return None
    rate = HARD if ego.hard else RATE["reaction"]
    gaps = [_far(c, own, place) for c in structure.objects if isinstance(c.spec, ObjectSpec)]
    nearest = min((g for g in gaps if g is not None), default=None)
    return None if nearest is None else (max(nearest / own - own / (2 * rate), 0.5), rate, 0.0)


def _far(component: Component, own: float, place: PlaceSpec) -> float | None:
    """How far ahead of ego (m) somebody is for whom it stops; None: not ahead of it."""
    spec = component.spec
    assert isinstance(spec, ObjectSpec)
    if hits_ego(spec) or "behind" in (spec.placement.position, spec.placement.along):
        return None
    return middle(spec.placement.gap) if spec.placement.gap is not None else default_gap(spec, own, place)
