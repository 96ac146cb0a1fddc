"""Where those start who come towards one that is out of its lane, in closed form: they meet when S means it."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed.passing import ASIDE, CALM, Overtaking, overtakings
from c2s_engine.write.typed.tables import JUNCTION, LANE_WIDTH, LENGTH, RAMP, is_static, is_vehicle
from c2s_engine.write.typed.usual import UNDISTURBED, crosses, default_gap, speed_of

SPARE = {"ego": 1.5, "other": 2.0}
"""s after who overtakes is back in its lane, where nobody reacts: ego, or another."""
JUST = 0.2
"""s after ego is back that broke off its overtaking for one that came towards it."""
MET = 1.5
"""s after it would pull out at which ego meets one whom it lets by first."""
ANSWERED = 1.2
"""s after one began to leave its lane by which the other begins to make way."""
GONE_BY = 3.0
"""s that one is beside what it swerves for."""
WIDE = 1.9
"""m, of most cars."""
OVERLAP = {True: 0.2, False: -0.4}
"""m by which two overlap who meet head-on, where they are to touch, and where they are not."""
NEAREST = 60.0
"""m at least from which one comes towards ego."""
DRIFTS = 0.7
"""m/s sideways"""
OUT = {"swerve", "oncoming", "lane_change"}
ONTO = {"drift", "oncoming", "swerve", "lose_control"}
AHEAD = {"drift": 5.5, "other": 2.8}
"""s before it is there at which one comes over that comes towards ego."""
MAKES_WAY = {"leave_road", "swerve", "drift"}


def facing(structure: Structure, place: PlaceSpec) -> Structure:
    """S with the gaps, where they are open, of those on the other side of the road whom ego meets while it, or one of
    them, is out of its lane."""
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    if place.kind in JUNCTION | RAMP:
        return structure
    all_ = list(overtakings(structure, place))
    own = next((one for one in all_ if one.who == "E"), None)
    speed, narrow = middle(speed_of(ego, place)), place.lanes == 1 or place.lanes is None and place.oncoming is True
    for component in structure.objects:
        spec = component.spec
        if not isinstance(spec, ObjectSpec) or not _comes(spec):
            continue
        passed = next((one for one in all_ if one.whom == component.id and one.who not in ("E", component.id)), None)
        hit = any(p.action == "collide" for p in (*ego.phases, *spec.phases))
        passes = next((one for one in all_ if one.who == component.id), None)
        if passes is not None:
            gap = _meeting(ego, speed, passes, hit)
        elif passed is not None:
            gap = _meeting(ego, speed, passed, hit) - passed.gap - LENGTH[spec.type]
        elif own is not None and narrow and not hit:
            until = own.begins + MET
            if _answers(spec):
                until = own.abreast + ANSWERED + ASIDE / 2
            elif ego.reaction == "none" or own.phase.abandoned:
                until = own.back + (JUST if own.phase.abandoned else SPARE["ego"])
            gap = own.travelled(until) + _drives(spec, place) * until
        elif not hit and (begins := _comes_over(spec)) is not None:
            gap = (speed + _drives(spec, place)) * (begins + UNDISTURBED)
        elif (meets := _out_until(ego, spec, hit)) is not None:
            gap = (speed + _drives(spec, place)) * meets
        elif not hit and {p.action for p in spec.phases} <= CALM and (there := _reached(structure, speed, place)):
            gap = max((speed + _drives(spec, place)) * there, NEAREST)
        else:
            continue
        placed = spec.placement.model_copy(update={"gap": round(gap, 1)})
        structure = structure.with_spec(component.id, placement=placed)
    return structure


def _comes(spec: ObjectSpec) -> bool:
    """Whether one drives towards ego on the other side, nobody says how far off."""
    at = spec.placement
    there = at.position == "oncoming_lane" and at.of == "ego" and at.gap is None
    return there and is_vehicle(spec.type) and not is_static(spec)


def _reached(structure: Structure, speed: float, place: PlaceSpec) -> float:
    """When (s) ego would be where it stops, or brakes, for what stands in its lane or comes onto it; 0: it does not.
    Who comes the other way is there then."""
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    named = [p.target for p in ego.phases if p.action in ("stop", "brake") and p.trigger is None]
    reacts = ego.react_to if ego.reaction == "brake" else None
    whom = next((cid for cid in (*named, reacts) if cid and cid in structure), None)
    spec = structure[whom].spec if whom else None
    if not isinstance(spec, ObjectSpec) or spec.placement.of != "ego" or speed <= 0:
        return 0.0
    stands = is_static(spec) and spec.placement.position in ("ahead", "partly_in_lane")
    if not stands and not crosses(spec):
        return 0.0
    gap = middle(spec.placement.gap) if spec.placement.gap is not None else default_gap(spec, speed, place)
    return gap / speed


def _answers(spec: ObjectSpec) -> bool:
    """Whether one does something as ego overtakes another."""
    triggers = (p.trigger for p in spec.phases if p.trigger is not None)
    return any((t.kind, t.of, t.action) == ("action", "ego", "overtake") for t in triggers)


def _comes_over(spec: ObjectSpec) -> float | None:
    """How long (s) before it is there one begins to come over into ego's lane, who waits for ego to be near; None: it
    does not."""
    first = next((p for p in spec.phases if p.action not in CALM), None)
    if first is None or first.trigger is not None or first.action not in ONTO:
        return None
    return AHEAD["drift" if first.action == "drift" else "other"]


def _drives(spec: ObjectSpec, place: PlaceSpec) -> float:
    return middle(speed_of(spec, place))


def _meeting(ego: EgoSpec, speed: float, one: Overtaking, hit: bool) -> float:
    """How far off one is who overtakes another and meets ego when it is just back, by less where ego brakes for it, or,
    where ego makes way or they touch, while it is still abreast."""
    until = one.abreast + ASIDE
    if ego.reaction == "none" or ego.reaction == "brake" and not hit:
        until = one.back + (SPARE["other"] if ego.reaction == "none" else JUST)
    return speed * until + one.travelled(until)


def _out_until(ego: EgoSpec, other: ObjectSpec, hit: bool) -> float | None:
    """When (s) ego, on its way out of its lane to the left, meets one who comes towards it; None: it stays in it."""
    out = next((p for p in ego.phases if p.action in {*OUT, "drift"} and p.side != "right"), None)
    if out is None:
        if ego.reaction != "evade" or hit:
            return None
        out = Phase(action="swerve")
    timed = out.trigger is not None and out.trigger.kind == "time" and out.trigger.value is not None
    begins = middle(out.trigger.value) if timed else UNDISTURBED  # type: ignore[union-attr, arg-type]
    if out.action == "drift":
        sideways = middle(out.lateral_speed) if out.lateral_speed is not None else DRIFTS
        return begins + (LANE_WIDTH - WIDE + OVERLAP[hit]) / sideways
    if hit:
        return None
    if any(p.action in MAKES_WAY for p in other.phases):
        return begins + ANSWERED + ASIDE + 0.6
    return begins + ASIDE + GONE_BY + ASIDE
