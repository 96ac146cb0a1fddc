"""Who drives where: the lanes that positions and manoeuvres refer to, counted from ego's, and who leads whom there."""

from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed.contradictions import ResolveError
from c2s_engine.write.typed.tables import FLAT, LANE_WIDTH, LENGTH, MOVES_OFF_ROAD, is_static, is_vehicle, is_walker
from c2s_engine.write.typed.usual import default_gap


def all_phases(ego: EgoSpec, objects: dict[str, ObjectSpec]) -> list[Phase]:
    return [*ego.phases, *(p for o in objects.values() for p in o.phases)]


def lane_offset(cid: str, objects: dict[str, ObjectSpec], seen: tuple[str, ...] = ()) -> int | None:
    """How many lanes to the left of ego's an object starts; None: on no lane of ego's direction."""
    placement = objects[cid].placement
    if cid in seen:
        raise ResolveError(f"{cid} is placed relative to itself", (f"{cid}.placement.of",))
    of: int | None = 0
    if placement.of != "ego":
        if placement.of not in objects:
            raise ResolveError(
                f"{cid} is placed relative to {placement.of}, which is not there", (f"{cid}.placement.of",)
            )
        of = 0 if is_landmark(objects[placement.of]) else lane_offset(placement.of, objects, (*seen, cid))
    step = {"ahead": 0, "behind": 0, "partly_in_lane": 0, "left_lane": placement.lanes_over,
            "right_lane": -placement.lanes_over}.get(placement.position)  # fmt: skip
    if placement.position == "beside":
        step = -1 if placement.side == "right" else 1
    if step and placement.lateral is not None:  # beyond the next lane
        step *= 1 + int(middle(placement.lateral) // LANE_WIDTH)
    return None if of is None or step is None else of + step


def is_landmark(spec: ObjectSpec) -> bool:
    """Whether a thing beside the road only tells where along it others are: what is ahead of a sign is on the road."""
    beside = spec.placement.position in ("roadside", "sidewalk")
    return beside and not is_vehicle(spec.type) and not is_walker(spec)


def oncoming(spec: ObjectSpec, objects: dict[str, ObjectSpec]) -> bool:
    """Whether somebody starts on a lane of the other direction of ego's road, or ahead of or behind one who does."""
    seen: set[str] = set()
    while spec.placement.position in ("ahead", "behind") and spec.placement.of in objects.keys() - seen:
        seen.add(spec.placement.of)
        spec = objects[spec.placement.of]
    return spec.placement.position == "oncoming_lane"


def leads(
    ego: EgoSpec, objects: dict[str, ObjectSpec], lane_of: dict[str, int | None], speed: float, place: PlaceSpec
) -> dict[str, tuple[str, ...]]:
    """Who starts ahead of each moving vehicle in its lane, ego included."""
    at = {"ego": 0.0}
    for cid, o in objects.items():  # each is placed by one before it
        placement = o.placement
        gap = middle(placement.gap) if placement.gap is not None else default_gap(o, speed, place)
        behind = placement.along == "behind" or (placement.position == "behind" and placement.along is None)
        abreast = placement.position == "beside" or placement.along == "abreast"
        own = gap + LENGTH[o.type] / 2 + 2.5
        at[cid] = at.get(placement.of, 0.0) + (0.0 if abreast else -own if behind else own)
    lanes: dict[str, int | None] = {"ego": 0, **lane_of}
    changes = ego.reaction == "evade" or {"lane_change", "overtake", "cut_in"} & {p.action for p in ego.phases}
    joins = {"on_ramp": (1,), "off_ramp": (-1,)}.get(place.kind, ())
    comes = (1, -1) if changes else joins  # the lanes that ego may come to
    movers = [c for c, o in objects.items() if is_vehicle(o.type) and not is_static(o) and lane_of[c] is not None]

    def before(cid: str, other: str) -> bool:
        if other != "ego" and lanes[other] == 0 and any(p.action == "cut_in" for p in objects[cid].phases):
            return other != cid  # whom it finds there, wherever it comes from
        if other != "ego" and objects[other].type in FLAT:
            return False
        same = lanes[other] == lane_of[cid] or other == "ego" and lane_of[cid] in comes
        return same and other != cid and at[other] > at[cid]

    queued = {
        c: (o.placement.of,)
        for c, o in objects.items()
        if o.placement.position == "behind" and o.placement.of in objects and lane_of[c] is None
    }
    found = {c: tuple(o for o in at if before(c, o)) for c in movers if objects[c].placement.facing != "against"}
    return queued | found


def needs_oncoming(ego: EgoSpec, objects: dict[str, ObjectSpec]) -> bool:
    if any(o.placement.position == "oncoming_lane" for o in objects.values()):
        return True
    return any(p.action in ("oncoming", "u_turn") for p in all_phases(ego, objects))


def by_oncoming(ego: EgoSpec, objects: dict[str, ObjectSpec]) -> bool:
    """Whether somebody leaves its lane for the oncoming one or beyond, or comes from that into ego's."""
    actions = {"oncoming", "overtake", "lane_change", "swerve", "drift", "collide", "leave_road"}
    return any(p.action in actions for p in all_phases(ego, objects))


def offsets_of(
    place: PlaceSpec, ego: EgoSpec, objects: dict[str, ObjectSpec], lane_of: dict[str, int | None]
) -> frozenset[int]:
    """All lane offsets that positions and lane changes reach."""
    used = {0} | {k for k in lane_of.values() if k is not None}
    if place.kind == "off_ramp" and place.ego_lane in ("middle", "leftmost"):
        used.add(-1)
    movers = [(0, ego.phases, ego)] + [(lane_of[c], o.phases, o) for c, o in objects.items()]
    turning = place.kind == "intersection" and place.manoeuvre in ("left", "right", "u_turn")  # from the outermost lane
    one_lane = place.lanes is None and (place.oncoming is True or place.kind == "roundabout" or turning)
    narrow = place.lanes == 1 or one_lane  # lane changes then go by the oncoming lane or the verge
    for start, phases, spec in movers:
        k = start
        for phase in phases:
            if k is None:
                break
            if phase.action in ("lane_change", "cut_out") and not (narrow and used == {0}):
                k += -1 if phase.side == "right" else 1
            elif phase.action == "cut_in":
                k = 0
            elif phase.action == "overtake" and k == lane_of.get(phase.target or "", 0) and not narrow:
                other = ego if phase.target in (None, "ego") and spec is not ego else objects.get(phase.target or "")
                if leaves_lane(other) or other and other.type in ("bicycle", "motorcycle") and phase.side != "right":
                    continue  # it clears the way, or is passed by the lane's left line
                used.add(k + (-1 if phase.side == "right" else 1))
            used.add(k)
        if spec is ego and ego.reaction == "evade" and not narrow:
            used.add(1)
    return frozenset(used)


LEAVES = ("lane_change", "cut_out", "leave_road")
"""What somebody does who is out of its lane then."""


def leaves_lane(spec: ObjectSpec | EgoSpec | None) -> bool:
    """Whether somebody clears its lane for who is behind it: ego where it gives way."""
    if spec is None or isinstance(spec, EgoSpec) and spec.reaction != "yield":
        return False
    out = next((i for i, p in enumerate(spec.phases) if p.action in LEAVES), None)
    if out is None or spec.phases[out].action == "leave_road" and not pulls_over(spec, out):
        return False
    trigger = spec.phases[out].trigger
    return trigger is None or trigger.kind not in ("passed", "contact")


def lane_is_cleared(phase: Phase, other: ObjectSpec | EgoSpec | None) -> bool:
    """Whether whom one overtakes leaves its lane to let it by, or has left it by what the overtaking waits for."""
    t = phase.trigger
    left = t is not None and t.kind == "action" and t.action in LEAVES and (t.of or "ego") == (phase.target or "ego")
    return left or leaves_lane(other) or _moves_over(other, phase.side or "left")


def _moves_over(spec: ObjectSpec | EgoSpec | None, side: str) -> bool:
    """Whether one changes lanes, of its own accord and first of all, to another side than by which it is overtaken."""
    first = next((p for p in getattr(spec, "phases", ()) if p.action != "keep_lane"), None)
    over = first is not None and first.action == "lane_change" and not first.abandoned
    return over and first.trigger is None and (first.side or "left") != side  # type: ignore[union-attr]


def leaves_behind(spec: ObjectSpec | EgoSpec) -> bool:
    """Whether one drives behind another until that does something, and then gets past it or out of its lane."""
    first = spec.phases[0] if spec.phases else None
    if not isinstance(spec, ObjectSpec) or first is None or first.trigger is None or first.trigger.kind != "action":
        return False
    directly = spec.placement.position == "behind" and spec.placement.of == (first.trigger.of or "ego")
    return directly and first.action in ("lane_change", "swerve", "overtake", "leave_road")


def pulls_over(spec: ObjectSpec | EgoSpec, i: int) -> bool:
    """Whether one that leaves the road in its i-th phase does so in order to stand there."""
    then = spec.phases[i + 1 : i + 2]
    return any(p.action in ("stop", "wait", "stationary") for p in then)


def pulls_out(ego: EgoSpec) -> bool:
    """Whether ego stands at the kerb at first and pulls out from there."""
    moves = (p.action for p in ego.phases if p.action not in ("wait", "stationary"))
    return next(moves, "") == "enter_road"


def kerb_side(ego: EgoSpec, objects: dict[str, ObjectSpec]) -> str | None:
    """The side of the road on which somebody waits to cross or stands, or leaves it: ego drives next to it."""
    sides = [o.placement.side or "right" for o in objects.values() if o.placement.position in MOVES_OFF_ROAD]
    sides += ["right" for p in all_phases(ego, objects) if p.action == "leave_road" and p.side != "left"]
    return sides[0] if sides else None


def lanes_for(place: PlaceSpec, offsets: frozenset[int], beside: str | None) -> tuple[PlaceSpec, int, frozenset[int]]:
    """Ego's lane and the number of lanes, so that every offset exists."""
    left, right = max(offsets), -min(offsets)
    needed = 1 + left + right
    if needed > 3:
        raise ResolveError(
            "more than three neighbouring lanes are referred to; maps have three", ("R.lanes", "O.placement")
        )
    wish = place.ego_lane
    if wish is None and (left or right):
        wish = "middle" if left and right else "rightmost" if left else "leftmost"
    if wish is None and beside:
        wish = "rightmost" if beside == "right" else "leftmost"
    if wish == "rightmost" and right or wish == "leftmost" and left or wish == "middle" and max(left, right) > 1:
        side = "right" if wish == "rightmost" else "left"
        raise ResolveError(
            f"ego is in the {wish} lane, but something refers to a lane on its {side}: "
            "change R.ego_lane or the placement",
            ("R.ego_lane", "O.placement.position"),
        )
    lanes = max(place.lanes or 0, needed, 3 if wish == "middle" else 2 if wish and (left or right) else 0)
    base = {"rightmost": 0, "leftmost": -1, "middle": 1, None: 0}[wish]
    update: dict = {"ego_lane": wish, "lanes": lanes or place.lanes}
    return place.model_copy(update=update), base, offsets


def ramp_lanes(place: PlaceSpec, offsets: frozenset[int], ramp: bool) -> tuple[PlaceSpec, int, frozenset[int]]:
    """At a ramp ego's lane is given: the ramp itself, the rightmost lane, or (leaving) one to the left of that."""
    left, right = max(offsets), -min(offsets)
    most_left, most_right = (2, 0) if place.kind == "on_ramp" else (1, 1) if place.kind == "off_ramp" else (2, 0)
    if left > most_left or right > most_right:
        there = "only the road, on its left, with two lanes" if place.kind == "on_ramp" else "no such lane"
        raise ResolveError(
            f"beside this ramp there is {there}: change the position or the kind of place",
            ("R.kind", "O.placement.position"),
        )
    if place.kind == "on_ramp":
        offsets |= {1}
    return place.model_copy(update={"ego_lane": None, "lanes": None}), 0, offsets
