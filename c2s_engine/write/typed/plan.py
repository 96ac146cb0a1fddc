"""What a structure needs of its place, decided before any line is written: lanes, approaches, room, distances.

Pure: it looks at specs only. `make_plan` raises ResolveError, naming the fields, where specs contradict each other.
"""

from dataclasses import dataclass, field

from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import references
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec
from c2s_engine.write.typed import contradictions, lanes
from c2s_engine.write.typed import room as rooms
from c2s_engine.write.typed.contradictions import ResolveError
from c2s_engine.write.typed.tables import APPROACH_ANGLE, JUNCTION, RAMP
from c2s_engine.write.typed.usual import speed_of, turn_of


@dataclass(frozen=True)
class Plan:
    """The place as the writer will ask for it, and what the fragments may refer to in it."""

    place: PlaceSpec
    duration: float  # s
    ego_speed: float  # m/s, the middle of it
    before: float  # m of lane wanted behind ego's start
    after: float  # m wanted ahead of it
    distance: float | tuple[float, float] | None  # m from ego's start to the junction or ramp
    offsets: frozenset[int]  # lane offsets from ego's (+1: one to the left) that fragments refer to
    base: int  # index of ego's lane in its group (0: rightmost, -1: leftmost)
    approaches: tuple[tuple[str, str], ...] = ()  # (position, turn type) that objects need
    oncoming: bool = False
    ramp: bool = False
    stops: tuple[str, ...] = ()  # positions of those who pass a stop sign of their own
    exit_room: float = 0.0  # m of lane wanted behind the junction; 0: nobody stands there
    lane_of: dict[str, int | None] = field(default_factory=dict)  # object id -> lane offset at the start
    leads: dict[str, tuple[str, ...]] = field(default_factory=dict)  # object id -> who is ahead of it in its lane

    @property
    def turning(self) -> bool:
        """Whether ego's way takes a manoeuvre that the place names (`egoTurn`)."""
        return self.junction or self.ramp or self.place.kind in RAMP

    @property
    def junction(self) -> bool:
        return self.place.kind in JUNCTION


def make_plan(structure: Structure, room: float = 1.0) -> Plan:
    """Decide what the place must offer; raises ResolveError. Where the specs leave the way to a junction open, `room`
    shortens it for maps with short roads."""
    place, ego = structure.place.spec, structure.ego.spec
    assert isinstance(place, PlaceSpec) and isinstance(ego, EgoSpec)
    restrictions = structure.restrictions.spec
    objects = {c.id: c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)}
    _placed_after(structure)
    place = _place_kind(place, ego, objects)
    if place.kind == "on_ramp":  # beside a ramp there is the motorway, on the left
        objects = {c: _on_the_left(o) for c, o in objects.items()}
    lane_of = {cid: lanes.lane_offset(cid, objects) for cid in objects}
    if broken := contradictions.first(place, ego, objects.values()):
        raise ResolveError(broken.because, broken.fields)
    ramp = any(o.placement.position == "on_ramp" for o in objects.values())
    oncoming = place.oncoming is True or lanes.needs_oncoming(ego, objects)
    if place.kind not in {"motorway", *RAMP} and place.oncoming is None and lanes.kerb_side(ego, objects) == "left":
        oncoming = True  # the far side of a street lies beyond its oncoming lanes
    offsets = lanes.offsets_of(place, ego, objects, lane_of)
    if ramp or place.kind in RAMP:
        place, base, offsets = lanes.ramp_lanes(place, offsets, ramp)
    else:
        beside = "right" if lanes.pulls_out(ego) else lanes.kerb_side(ego, objects)
        if oncoming and beside is None and lanes.by_oncoming(ego, objects):  # no lane of their own in between
            beside = "left"
        place, base, offsets = lanes.lanes_for(place, offsets, beside)
    if oncoming:
        place = place.model_copy(update={"oncoming": True})
    approaches = tuple(
        sorted(
            {
                (o.placement.position, turn_of(o.phases))
                for o in objects.values()
                if o.placement.position in APPROACH_ANGLE
            }
        )
    )
    speed = middle(speed_of(ego, place))
    duration = getattr(restrictions, "duration", None) or 20.0
    return Plan(
        place=place,
        duration=duration,
        ego_speed=speed,
        before=rooms.before(ego, objects, speed),
        after=rooms.after(place, speed, duration, ego, objects),
        distance=rooms.distance(place.model_copy(update={"kind": "on_ramp"}) if ramp else place, speed, objects, room),
        offsets=offsets,
        base=base,
        approaches=approaches,
        stops=tuple(sorted({o.placement.position for o in objects.values() if _runs_stop(o)} & APPROACH_ANGLE.keys())),
        oncoming=oncoming,
        ramp=ramp,
        exit_room=rooms.behind_junction(objects, speed, place),
        lane_of=lane_of,
        leads=lanes.leads(ego, objects, lane_of, speed, place),
    )


def _placed_after(structure: Structure) -> None:
    """An object is placed relative to one that is written before it; T's conditions name what is there."""
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
    for c in (structure.ego, structure.restrictions, *structure.objects):
        if missing := references(c) - known - {"E"}:
            raise ResolveError(f"{c.id} names {', '.join(sorted(missing))}, which is not there", (c.id,))


def _on_the_left(o: ObjectSpec) -> ObjectSpec:
    if o.placement.position not in ("right_lane", "beside"):
        return o
    return o.model_copy(update={"placement": o.placement.model_copy(update={"position": "left_lane"})})


def _runs_stop(o: ObjectSpec) -> bool:
    return any(p.action == "run_stop" for p in o.phases)


def _place_kind(place: PlaceSpec, ego: EgoSpec, objects: dict[str, ObjectSpec]) -> PlaceSpec:
    """A road becomes an intersection where somebody turns or comes from a crossing road there."""
    positions = {o.placement.position for o in objects.values()}
    turns = any(p.action in ("turn_left", "turn_right", "run_red", "run_stop") for p in lanes.all_phases(ego, objects))
    wants = turns or positions & (APPROACH_ANGLE.keys() | {"intersection_exit"}) or place.control or place.arms
    crossing = positions & (APPROACH_ANGLE.keys() | {"intersection_exit"})
    if (place.kind == "road" and wants) or (crossing and place.kind in ("straight", "curve", "crosswalk")):
        place = place.model_copy(update={"kind": "intersection"})
    if "on_ramp" in positions and place.kind in ("road", "straight"):
        place = place.model_copy(update={"kind": "motorway"})
    if place.kind == "intersection" and place.control is None:  # who passes a light or a sign has one
        passed = {"run_red": "signal", "run_stop": "stop"}
        found = next((passed[p.action] for p in ego.phases if p.action in passed), None)
        others = {p.action for o in objects.values() for p in o.phases}
        place = place.model_copy(update={"control": found or ("signal" if "run_red" in others else None)})
    if place.kind == "intersection" and place.manoeuvre is None:
        turn = {"turn_left": "left", "turn_right": "right", "u_turn": "u_turn"}
        found = next((turn[p.action] for p in ego.phases if p.action in turn), "straight")
        place = place.model_copy(update={"manoeuvre": found})
    return place
