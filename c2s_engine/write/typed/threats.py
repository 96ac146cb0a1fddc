"""Who may come into ego's way, and from when ego can see them."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import high, low, middle
from c2s_engine.structure.specs import AnySpec, EgoSpec, ObjectSpec
from c2s_engine.write.typed import lateral, scope
from c2s_engine.write.typed.course import Actor
from c2s_engine.write.typed.stations import at_door, parked_in_way
from c2s_engine.write.typed.tables import FLAT, is_static, is_walker
from c2s_engine.write.typed.usual import crosses, pace_of

IN_WAY = {"ahead", "partly_in_lane", "intersection_exit"}
NEAREST = 0.6
"""The share of the room to which ego is to come near that it leaves."""
BESIDE_SOON = 6
"""m behind whom it overtakes from which one is all but beside it."""
FOG = 65
"""m that one sees in the fog: at motorway speeds just enough to stop."""
STAYS = {"keep_lane", "move_along", "stationary", "wait", "go_straight"}
"""What somebody does who stays beside the road."""
ASIDE = {"swerve", "lane_change", "leave_road"}
"""How one gets out of the way of what is ahead in its lane."""
STANDS = "ego.speed < 0.3"
"""The condition under which ego stands, for one behind it."""
CALM = {"follow", "keep_lane", "go_straight", "turn_left", "turn_right", "move_along", "brake"}
"""What ego does before it is to stop while nothing forces it to."""


def hits_ego(spec: ObjectSpec) -> bool:
    """Whether somebody runs into ego."""
    return any(p.action == "collide" and p.target in (None, "ego") for p in spec.phases)


def is_hit(ego: EgoSpec, cid: str) -> bool:
    """Whether ego runs into an object."""
    return any(p.action == "collide" and p.target in (cid, None) for p in ego.phases)


def beside_way(structure: Structure, cid: str | None) -> bool:
    """Whether ego passes somebody, or something, that is at the roadside ahead and stays there."""
    spec = structure[cid].spec if cid and cid in structure else None
    if not isinstance(spec, ObjectSpec):
        return False
    at = spec.placement
    stays = {p.action for p in spec.phases} <= STAYS and at.facing != "across" and at.along in (None, "ahead")
    return at.position == "roadside" and at.of == "ego" and stays


def threatening(structure: Structure) -> list[str]:
    """The ids of the objects that may come into ego's way: all that move, and what stands in its lane."""
    objects = [(c.id, c.spec) for c in structure.objects if isinstance(c.spec, ObjectSpec) and c.spec.type not in FLAT]
    cause = getattr(structure.ego.spec, "react_to", None)
    evaded = cause if parked_in_way(structure, cause) else None
    moving = [i for i, o in objects if not is_static(o) and (i == cause or not _halts_at_edge(o))]
    return [i for i, o in objects if o.placement.position in IN_WAY or i in moving or i == evaded]


def _halts_at_edge(spec: ObjectSpec) -> bool:
    """Whether somebody beside the road comes no further than its edge, whatever it looks like until then."""
    broken_off = [p.abandoned for p in spec.phases if p.action == "cross_road"]
    return bool(broken_off) and all(broken_off) and not {"enter_road", "collide"} & {p.action for p in spec.phases}


def standing(structure: Structure, lane_of: dict[str, int | None]) -> str | None:
    """The first object that stands in ego's lane, if one does: what an evasion without a target is about."""
    for c in structure.objects:
        spec = c.spec
        if not isinstance(spec, ObjectSpec) or not is_static(spec) or spec.placement.position not in IN_WAY:
            continue
        if spec.type in FLAT:
            continue
        if lane_of.get(c.id) in (0, None):
            return c.id
    return None


def every(structure: Structure, cid: str) -> str:
    """The reference to an object, or to all of its members (starred)."""
    first = scope.reference(structure, cid)
    return f"*{first.removesuffix('[0]')}" if first.endswith("[0]") else first


def members(structure: Structure, cid: str) -> list[str]:
    """The references to an object, or to the first and the last of its members."""
    first = scope.reference(structure, cid)
    return [first, first.replace("[0]", "[-1]")] if first.endswith("[0]") else [first]


def every_passed(structure: Structure, cid: str) -> str:
    """The condition under which an object, or the first and the last of its members, has gone by before the car."""
    margin = ", margin=2.5" if is_walker(structure[cid].spec) else ""
    return " and ".join(f"passed({one}, self{margin})" for one in members(structure, cid))


def passed_over(structure: Structure, cid: str, by: str | None = None) -> bool:
    """Whether a thing lies in the lane that a vehicle ahead, which stays in it, hides from ego: that one (`by`, or any)
    drives on over it."""
    spec = structure[cid].spec
    hider = spec.placement.hidden_by if isinstance(spec, ObjectSpec) and spec.type == "debris" else None
    over = structure[hider].spec if hider and hider in structure and by in (None, hider) else None
    leaves = {"cut_out", "lane_change", "swerve", "stop", "brake", "leave_road", "collide"}
    moves = isinstance(over, ObjectSpec) and not is_static(over) and over.placement.position == "ahead"
    return moves and not leaves & {p.action for p in over.phases}  # type: ignore[union-attr]


def in_sight(structure: Structure, cid: str) -> str:
    """The reference to an object, or to all of its members (starred), only while what hides it does not."""
    spec, name = structure[cid].spec, every(structure, cid)
    by = spec.placement.hidden_by if isinstance(spec, ObjectSpec) else None
    if isinstance(spec, ObjectSpec) and spec.placement.of in structure and crosses(spec):  # by a thing beside the road
        by = by or spec.placement.of
    if isinstance(spec, ObjectSpec) and at_door(structure, spec):  # nobody was there before
        return f"*([{name}] if {name}.speed > 0 else [])"
    if by is None or by not in structure:
        return name
    seen, hiders = (one.removeprefix("*") if one[0] == "*" else f"[{one}]" for one in (name, every(structure, by)))
    return f"*in_view(self, {seen}, {hiders})"


def once_seen(structure: Structure, cids: list[str]) -> list[str]:
    """References to objects, each only from when ego can see that it is in its way."""
    found = []
    for cid in cids:
        seen, fog = in_sight(structure, cid), in_fog(structure)
        found.append(f"*in_fog(self, [{seen}], {fog})" if fog else seen)
    return found


def in_fog(structure: Structure) -> int:
    """How far (m) one sees in the weather of S; 0: as far as it takes."""
    return FOG if "fog" in getattr(structure.settings.spec, "weather", ()) else 0


def on_foot(structure: Structure) -> list[str]:
    """The ids of those who come onto the road on foot: ego stops for them where it brakes for what is in its way."""
    objects = [(c.id, c.spec) for c in structure.objects if isinstance(c.spec, ObjectSpec) and is_walker(c.spec)]
    does = {cid: {p.action for p in o.phases} for cid, o in objects}
    return [cid for cid, _ in objects if {"cross_road", "enter_road"} & does[cid] and "collide" not in does[cid]]


def room_left(structure: Structure, cid: str) -> float | None:
    """The m that S leaves to somebody as ego stands before them, or at the nearest; None: it says nothing."""
    phases, require = getattr(structure.ego.spec, "phases", ()), getattr(structure.restrictions.spec, "require", ())
    stops = [middle(p.clearance) for p in phases if p.action == "stop" and p.clearance and p.target in (None, cid)]
    near = [NEAREST * c.maximum for c in require if c.kind == "closest" and c.maximum is not None
            and {c.subject, c.other} == {"ego", cid}]  # fmt: skip
    return min([*stops, *near], default=None)


def is_stopped(spec: EgoSpec | ObjectSpec) -> bool:
    """Whether ego is told to come to a stand for who forces it to brake, which slowing down is not."""
    actions = [p.action for p in spec.phases]
    forced = isinstance(spec, EgoSpec) and spec.reaction == "brake"
    at = actions.index("stop") if forced and "stop" in actions else None
    return at is not None and spec.phases[at].trigger is None and set(actions[:at]) <= CALM


def slowed(actor: Actor, target: str | None) -> str:
    """The condition under which ego has done what one behind it is to run into it for; "": nothing is waited for."""
    spec, ego = actor.spec, actor.structure.ego.spec
    if actor.is_ego or target not in (None, "ego") or not isinstance(spec, ObjectSpec) or not isinstance(ego, EgoSpec):
        return ""
    if spec.placement.of != "ego" or "behind" not in (spec.placement.position, spec.placement.along):
        return ""
    actions = {p.action for p in ego.phases}
    if middle(ego.speed or 1) == 0 and not actions & {"start", "accelerate", "enter_road"}:
        return ""  # it stands from the first
    if actions & {"stop", "wait", "stationary"} or ego.reaction in ("brake", "yield") and stops_ego(actor.structure):
        return STANDS
    if ego.reaction in ("brake", "yield") and len(actor.structure.objects) > 1 or "brake" in actions:
        return "ego.speed < EGO_SPEED - 2.5"
    return ""


def stops_ego(structure: Structure) -> bool:
    """Whether somebody is in ego's way who makes it stop: on foot, standing, or coming to a stand."""
    if on_foot(structure):
        return True
    for c in structure.objects:
        spec = c.spec
        if not isinstance(spec, ObjectSpec) or spec.placement.position not in IN_WAY:
            continue
        if is_static(spec) or any(p.action == "stop" for p in spec.phases):
            return True
    return False


def _runs_on(spec: object) -> float:
    """The speed (m/s) by which it can be seen that somebody crosses who came onto the road slower before; 0: nobody
    did."""
    phases = spec.phases if isinstance(spec, ObjectSpec) else ()
    before = [p for p in phases[:1] if p.action == "enter_road"]
    later = [p for p in phases[1:] if p.action == "cross_road" and p.speed is not None]
    if not before or not later or not isinstance(spec, ObjectSpec):
        return 0.0
    slow, fast = high(before[0].speed or pace_of(spec)), low(later[0].speed or 0.0)
    return round((slow + fast) / 2, 1) if fast > slow + 0.5 else 0.0


def _drives_first(spec: AnySpec) -> bool:
    """Whether somebody who sets off has come there, and stopped."""
    phases = spec.phases if isinstance(spec, EgoSpec | ObjectSpec) else ()
    stands = getattr(spec, "speed", None) == 0 or not phases or phases[0].action in ("stationary", "wait", "start")
    return not stands and "stop" in [p.action for p in phases]


def observed(structure: Structure, other: str, cid: str, action: str | None) -> str:
    """What can be seen of another's action while it is at it."""
    spec = structure.ego.spec if cid in ("E", "ego") else structure[cid].spec
    phase = next((p for p in getattr(spec, "phases", ()) if p.action == action), None)
    target = phase.target if phase is not None else None
    whom = scope.reference(structure, target or "ego")
    if action == "stop":  # whoever drives has its speed from the first step on
        return f"clock() > 1 and {other}.speed < 0.3"
    if action in ("stationary", "wait"):
        return f"{other}.speed < 0.3"
    if action == "accelerate":
        return f"speeds_up({other})"
    if action == "brake":
        return f"slows_down({other})"
    if action == "cross_road" and (faster := _runs_on(spec)):
        return f"{other}.speed > {scope.number(faster)}"
    if action == "start" and _drives_first(spec):
        return f"sets_off({other})"
    if action in ("start", "enter_road", "cross_road", "move_along"):
        return f"{other}.speed > 0.5"
    if action == "reverse":
        return f"backs({other}, ego)"
    if action in ("turn_left", "turn_right", "go_straight", "run_red", "run_stop"):
        return f"{other}._intersection is not None"
    if action in (*lateral.LATERAL, "swerve", "drift", "oncoming", "lose_control"):
        return f"off_lane({other})"
    if action == "leave_road":
        return f"{other}._lane is None and {other}._intersection is None"
    if action == "u_turn":
        return f"turns_round({other})"
    if action == "overtake" and phase is not None and phase.abandoned:  # it never comes alongside
        return f"off_lane({other}) and ahead_by({whom}, {other}) < {scope.number(BESIDE_SOON)}"
    if action == "overtake":  # it is alongside
        return f"lead_on({other}, {whom}) > -5"
    if action == "collide" and whom != other:
        return f"touch({other}, {whom})"
    return f"(distance from ego to {other}) < 20"
