"""Objects whose place the text leaves open do not start inside each other: later ones are set further off."""

from functools import lru_cache

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import references
from c2s_engine.structure.quantity import high, low, middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec, RestrictionsSpec, SettingsSpec
from c2s_engine.structure.vocabulary import LightState
from c2s_engine.write.typed import traffic
from c2s_engine.write.typed.apart import apart
from c2s_engine.write.typed.contradictions import ResolveError
from c2s_engine.write.typed.forms import normal
from c2s_engine.write.typed.paced import paced
from c2s_engine.write.typed.planning import make_plan
from c2s_engine.write.typed.pockets import pocketed
from c2s_engine.write.typed.reach import reached
from c2s_engine.write.typed.tables import APPROACH_ANGLE, MOVES_OFF_ROAD, is_static, is_vehicle, is_walker
from c2s_engine.write.typed.usual import (
    at_corner,
    crosses,
    default_gap,
    has_marking,
    right_behind,
    row_length,
    speed_of,
    uses_crosswalk,
)

_ROW = {"partly_in_lane": "ahead", "roadside": "kerb", "sidewalk": "kerb", "parked": "kerb"}
ROOM = 3.0
"""m between two of them."""
AT_IT = 1.0
"""m from a vehicle that stands to who steps out at it."""
ANSWERS = ("follow", "brake", "stop", "overtake")
"""What one does for another that is ahead of it in its lane."""
HEADWAY = 2.0
"""s behind the one for whom it does that."""
TO_PULL_OUT = 15.0
"""m behind whom one overtakes."""


def spread(structure: Structure) -> Structure:
    """S for the writer, in its normal form: of two objects that would overlap the one whose gap is open is set off.

    Raises ResolveError where specs contradict each other, or two of them start inside each other whatever is open.
    """
    key = (structure.place.spec, structure.ego.spec, structure.restrictions.spec)
    light = getattr(structure.settings.spec, "light", None)
    specs = _spread(light, *key, tuple((c.id, c.spec) for c in structure.objects))
    for component, spec in zip((structure.place, structure.ego, *structure.objects), specs, strict=True):
        if spec is not component.spec:
            structure = structure.with_spec(component.id, spec)
    return structure


def contradiction(structure: Structure) -> ResolveError | None:
    """What in the specs contradicts itself, whatever the map."""
    try:
        make_plan(spread(structure))
    except ResolveError as error:
        return error
    return None


@lru_cache(maxsize=256)
def _spread(
    light: LightState | None, place: PlaceSpec, ego: EgoSpec, restrictions: RestrictionsSpec,
    objects: tuple[tuple[str, ObjectSpec], ...],
) -> tuple[PlaceSpec | EgoSpec | ObjectSpec, ...]:
    """The place, ego and the objects as they are spread (each fragment of a program asks for them)."""
    found = Structure(
        settings=Component(id="G", spec=SettingsSpec(light=light)),
        place=Component(id="R", spec=place),
        ego=Component(id="E", spec=ego),
        objects=tuple(Component(id=cid, spec=spec) for cid, spec in objects),
        restrictions=Component(id="T", spec=restrictions),
    )
    _placed_after(found)
    found = apart(_rows(reached(traffic.solved(normal(paced(found))))), found)
    return (found.place.spec, found.ego.spec, *(c.spec for c in found.objects))  # type: ignore[return-value, arg-type]


def _placed_after(structure: Structure) -> None:
    """Raises ResolveError where an object is placed relative to one that is not written before it, where a component
    names one that is not there, or where T requires a time of the scene."""
    known = {"ego"}
    for component in structure.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        for name, other in (("of", spec.placement.of), ("hidden_by", spec.placement.hidden_by)):
            if other is not None and other not in known:
                where = f"{component.id}.placement.{name}"
                raise ResolveError(
                    f"{component.id} is placed by {other}, which is not there before it: move it", (where,)
                )
        known.add(component.id)
    if any(c.kind == "time" for c in getattr(structure.restrictions.spec, "require", ())):
        raise ResolveError(
            "a scene has no time that could be required: say how long the run is, or when it ends",
            ("T.require", "T.duration", "T.terminate_when"),
        )
    for c in (structure.ego, structure.restrictions, *structure.objects):
        if missing := references(c) - known - {"E"}:
            raise ResolveError(f"{c.id} names {', '.join(sorted(missing))}, which is not there", (c.id,))


def _rows(structure: Structure) -> Structure:
    """Those that share a lane or a kerb, one after the other."""
    place = structure.place.spec
    speed = middle(speed_of(structure.ego.spec, place))  # type: ignore[arg-type]
    structure = _queued(structure)
    taken: dict[tuple, list[tuple[float, float]]] = {}
    objects = [c for c in structure.objects if isinstance(c.spec, ObjectSpec) and not right_behind(c.spec)]
    answered = [(p.target, _row(c.spec)) for c in objects for p in c.spec.phases if p.action in ANSWERS]  # type: ignore
    leads = {c.id for c in objects if (c.id, _row(c.spec)) in answered}  # type: ignore[arg-type]
    for component in sorted(objects, key=lambda c: (c.spec.placement.gap is None, _comes_later(c.spec), c.id in leads)):  # type: ignore
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        row, size = taken.setdefault(_row(spec), []), row_length(spec)
        if spec.placement.gap is not None:
            row.append((low(spec.placement.gap), high(spec.placement.gap) + size))
            continue
        if _steps_out_at(structure, spec):
            structure = structure.with_spec(component.id, placement=spec.placement.model_copy(update={"gap": AT_IT}))
            continue
        by_marking = has_marking(place) and uses_crosswalk(spec)  # type: ignore[arg-type]
        if spec.placement.position in APPROACH_ANGLE or by_marking or at_corner(spec, place):  # type: ignore[arg-type]
            continue
        start = default_gap(_followed(structure, spec), speed, place)  # type: ignore[arg-type]
        gap = start + _between(component.id, structure, speed)
        room = max(ROOM, HEADWAY * speed) if component.id in leads else ROOM
        room = TO_PULL_OUT if _comes_later(spec) else room
        while any(gap < end + room and begin < gap + size + room for begin, end in row):
            gap += 2.0
        row.append((gap, gap + size))
        if gap != start:
            moved = spec.placement.model_copy(update={"gap": round(gap, 1)})
            structure = structure.with_component(
                component.model_copy(update={"spec": spec.model_copy(update={"placement": moved})})
            )
    return structure


def _steps_out_at(structure: Structure, spec: ObjectSpec) -> bool:
    """Whether somebody on foot beside the road is placed by a vehicle that stands, nobody says how far from it."""
    by = structure[spec.placement.of].spec if spec.placement.of in structure else None
    stands = isinstance(by, ObjectSpec) and is_vehicle(by.type) and is_static(by)
    return stands and is_walker(spec) and spec.placement.position in MOVES_OFF_ROAD


def _followed(structure: Structure, spec: ObjectSpec) -> ObjectSpec:
    """Whom somebody beside the road sets out after who waits for that, from where that one does; else itself."""
    trigger = spec.phases[0].trigger if spec.phases else None
    of = trigger.of if trigger and trigger.kind == "action" else None
    other = structure[of].spec if of and of in structure else None
    return other if isinstance(other, ObjectSpec) and crosses(spec) and crosses(other) else spec


def _between(cid: str, structure: Structure, speed: float) -> float:
    """How much (m) those take who come behind an object that is ahead of ego in its lane."""
    if structure[cid].spec.placement.position != "ahead" or structure[cid].spec.placement.of != "ego":  # type: ignore[union-attr]
        return 0.0
    specs = [c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)]
    behind = [s for s in specs if s.placement.of == cid and s.placement.position == "behind" and is_vehicle(s.type)]
    place = structure.place.spec
    gaps = [high(s.placement.gap) if s.placement.gap is not None else default_gap(s, speed, place) for s in behind]  # type: ignore[arg-type]
    return sum(gaps) + sum(row_length(s) for s in behind)


def _comes_later(spec: ObjectSpec) -> bool:
    """Whether it is an oncoming one that overtakes another: it starts further off."""
    passes = any(p.action == "overtake" and p.target not in (None, "ego") for p in spec.phases)
    return passes and spec.placement.position == "oncoming_lane"


def _queued(structure: Structure) -> Structure:
    """Of several on the on-ramp or on an approach the first is timed to ego; each other comes behind the one before."""
    before: dict[str, str] = {}
    objects = {c.id: c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)}
    passed = pocketed(objects, structure.place.spec)  # type: ignore[arg-type]
    for component in structure.objects:
        spec = component.spec
        if not isinstance(spec, ObjectSpec) or spec.placement.position not in (*APPROACH_ANGLE, "on_ramp"):
            continue
        if component.id in passed:
            continue
        position = spec.placement.position
        if position in before and (position == "on_ramp" or spec.placement.gap is None):
            last = structure[before[position]].spec
            assert isinstance(last, ObjectSpec)
            changes = {"position": "behind", "of": before[position], "along": None, "gap": 8.0}
            behind = spec.placement.model_copy(update=changes)
            changed = component.model_copy(update={"spec": spec.model_copy(update={"placement": behind})})
            structure = structure.with_component(changed)
        before[position] = component.id
    return structure


def _row(spec: ObjectSpec) -> tuple:
    """Objects that share a row may overlap: the same lane or kerb, on the same side of the same other."""
    placement = spec.placement
    row = _ROW.get(placement.position, placement.position)
    along = placement.along if row in ("left_lane", "right_lane", "kerb") else None
    return row, placement.of, placement.side if row in ("kerb", "beside") else None, along
