"""When a run is over: soon after each of what S says was seen, as far as that can be told while it runs."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.lanes import oncoming
from c2s_engine.write.typed.lateral import LATERAL
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import APPROACH_ANGLE, HALF_LANE, LANE_NAME, MOVES_OFF_ROAD, TURN, is_static
from c2s_engine.write.typed.threats import IN_WAY, members, observed, threatening
from c2s_engine.write.typed.usual import crosses

LASTING = {"keep_lane", "move_along", "follow", "stationary", "run_red", "run_stop"}
"""What goes on to the end, or is over with what follows it."""
STANDS = {"stop", "wait"}
SEEN = {"brake", "cut_in"}
"""What can be seen of another at any time after it was done."""
BACK = 0.7
"""m from the middle of its lane within which one is back in it."""
Unknown = None
"""What stands for a phase of which nobody can tell while it runs that it is done."""


def conditions(structure: Structure, plan: Plan) -> list[str]:
    """What must have been seen for the run to be over; none: it is over when its time is."""
    ego, objects = structure.ego.spec, {c.id: c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)}
    assert isinstance(ego, EgoSpec)
    if any(p.action == "collide" for phases in (ego.phases, *(o.phases for o in objects.values())) for p in phases):
        return []
    if plan.ego_speed <= 0 and (not _last(ego.phases) or any(crosses(o) for o in objects.values())):
        return []
    found: list[str] = []
    for done in (_of_ego(structure, plan, ego), *(_of_object(structure, plan, c, o) for c, o in objects.items())):
        if done is Unknown:
            return []
        found += done
    return list(dict.fromkeys(found))


def _last(phases: tuple[Phase, ...]) -> Phase | None:
    return next((p for p in reversed(phases) if p.action not in LASTING), None)


def _of_ego(structure: Structure, plan: Plan, ego: EgoSpec) -> list[str] | None:
    last, light = _last(ego.phases), getattr(structure.settings.spec, "light", None)
    if last is None and ego.reaction == "evade" and (others := threatening(structure)):
        last = Phase(action="swerve", target=ego.react_to or others[0])
    onward = ["ego._lane is place.exit_lane"] if plan.place.kind == "intersection" else []
    held = light == "red" and plan.place.control == "signal"
    if last is None and held and not any(p.action in TURN for p in ego.phases):
        return ["ego.speed < 0.3"]
    if last is None or last.action in TURN and last.action != "u_turn":
        return onward
    if last.action in STANDS:
        return ["ego.speed < 0.3"]
    if last.action == "lane_change" and not plan.junction and not last.abandoned:
        return [f"ego._lane is not {LANE_NAME[0]}"]
    if last.action == "swerve" and last.target and last.target in structure:
        return _back(structure, plan, "E", ego, str(last.target))
    if last.action in ("overtake", "yield") and last.target and last.target in structure:
        if last.action == "overtake" and not last.abandoned:
            return [*_back(structure, plan, "E", ego, str(last.target)), *onward]
        return [f"passed({scope.reference(structure, str(last.target))}, ego, 0)", *onward]
    return Unknown


def _of_object(structure: Structure, plan: Plan, cid: str, o: ObjectSpec) -> list[str] | None:
    last, one = _last(o.phases), members(structure, cid)[-1]
    if crosses(o):
        return [f"lead_on({one}, ego) < -3 or ego.speed < 0.3 and {one}.speed < 0.3"]
    if is_static(o):
        own = plan.lane_of.get(cid) == 0 and o.placement.position == "ahead"  # whomever it is placed by
        ahead = o.placement.along in (None, "ahead") and (o.placement.of == "ego" or own)
        beside = o.placement.position in {*MOVES_OFF_ROAD, "left_lane", "right_lane"}
        return (
            [f"lead_on({one}, ego) < -5 or ego.speed < 0.3"]
            if ahead and (beside or o.placement.position in IN_WAY)
            else []
        )
    if last is None:
        return []
    if o.placement.position in APPROACH_ANGLE and last.action in TURN:
        return [f"{one}._intersection is not None"]
    if last.action in STANDS:
        reacts = getattr(structure.ego.spec, "reaction", "") in ("brake", "follow")
        behind = reacts and plan.lane_of.get(cid) == 0 and o.placement.position == "ahead"
        return [f"{one}.speed < 0.3", *(["ego.speed < 0.3"] if behind else [])]
    if last.abandoned:
        return Unknown
    if last.action in SEEN or last.action in ("lane_change", "cut_out") and plan.lane_of.get(cid) == 0:
        goal = middle(last.speed) if last.speed is not None and last.action == "brake" else None
        return [f"{one}.speed < {scope.number(goal + 0.7)}" if goal else _done(structure, one, cid, last.action)]
    if last.action == "overtake" and not last.abandoned:
        return _back(structure, plan, cid, o, last.target or "ego")
    if last.action == "swerve" and any(p.action == "overtake" and p.target == cid for p in structure.ego.spec.phases):  # type: ignore[union-attr]
        return []  # it is passed then
    if last.action == "leave_road":
        return [f"not network.drivableRegion.containsPoint({one}.position)"]
    return Unknown


def _back(structure: Structure, plan: Plan, cid: str, spec: EgoSpec | ObjectSpec, whom: str) -> list[str]:
    """That one who overtakes is ahead of the other, and back in its lane where both were in one; who came towards ego
    is met then."""
    one, other = scope.reference(structure, cid), scope.reference(structure, whom)
    found = [f"lead_on({other}, {one}) < -8"]
    lane = LANE_NAME.get(plan.lane_of.get(cid, 0) if cid != "E" else 0)  # type: ignore[arg-type]
    swerves = not any(p.action == "overtake" for p in spec.phases)
    moved = any(p.action == "lane_change" for p in spec.phases)
    both = swerves or not moved and plan.lane_of.get(whom, 0) == plan.lane_of.get(cid, 0)
    if comes := isinstance(spec, ObjectSpec) and _from_ahead(structure, cid):
        lane, both = "place.oncoming_lane", True
    if lane is not None and both and not plan.junction and not plan.turning:
        found = [f"{found[0]} and {lane}.centerline.distanceTo({one}.position) < {scope.number(BACK)}"]
    return [*found, *([f"lead_on({one}, ego) < -3"] if comes else [])]


def _from_ahead(structure: Structure, cid: str) -> bool:
    """Whether one comes towards ego on the other side of the road."""
    return oncoming(structure[cid].spec, {c.id: c.spec for c in structure.objects})  # type: ignore[misc, arg-type]


def _done(structure: Structure, other: str, cid: str, action: str) -> str:
    """What can be seen of another's action once it is done."""
    if action in LATERAL:
        sign = "<" if action == "cut_in" else ">"
        return f"place.lane.centerline.distanceTo({other}.position) {sign} {HALF_LANE}"
    return observed(structure, other, cid, action)
