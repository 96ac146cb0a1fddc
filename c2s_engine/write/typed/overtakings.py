"""How one passes another: out of its lane where there is room, by, and back."""

from c2s_engine.structure.facts import called
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.ahead import LEAST
from c2s_engine.write.typed.collisions import Step
from c2s_engine.write.typed.course import Course
from c2s_engine.write.typed.evasion import goes_round
from c2s_engine.write.typed.lanes import lane_is_cleared
from c2s_engine.write.typed.passing import NARROW, comes_back, faster, pull_out, sideways, to_slow
from c2s_engine.write.typed.stations import parked_in_way
from c2s_engine.write.typed.tables import HALF_LANE, LANE_NAME, WIDTH, is_static, is_vehicle
from c2s_engine.write.typed.threats import hits_ego, is_hit, members

INSIDE = 2.3
"""m that riders keep aside from the middle of a car's lane where they pass it on the inside."""
BACK = "for 4 seconds"
WARY = 3.0
"""m/s: so much as if it came nearer faster one slows down sooner who has to wait first."""
HEADWAY = 1.2
"""s behind whom one waits to overtake."""
CLOSE, BRAKES = 8.0, 4.0
"""m behind one that is to clear the lane for it, from where, and m/s2 with which it brakes where that takes long."""
THREATENED, SPOILED = 6.0, 3.5
"""s until one that comes towards it is there, as it pulls out nevertheless, and as it gives up."""
TOO_EARLY = -14
"""m that one is ahead of whom it overtakes, bumper to bumper, when it comes back so early that they touch."""
BREAKS_OFF = {"brake", "swerve", "collide", "stop", "leave_road", "lane_change"}
"""What ego does after an overtaking that somebody who comes towards it spoils."""


def overtakes(c: Course, p: Phase) -> list[Step]:
    """The steps out, past the other (all of them where they are several) and back."""
    if parked_in_way(c.actor.structure, p.target):
        return goes_round(c, p)
    c.set(_top(c, p))
    scrapes = _scrapes(c, p)  # it comes back too early
    if (cut := _cuts_in(c, p)) is not None and p.gap is None:  # that is how it comes back
        p = p.model_copy(update={"gap": cut.gap if cut.gap is not None else LEAST})
    lead = TOO_EARLY if scrapes else _ahead(c, p)
    past = " and ".join(f"lead_on(self, {one}) > {lead}" for one in _passed_actors(c, p))
    if not (c.oncoming_both(p) or c.same_lane(p) and c.lane is not None):
        return [([c.drive()], f"until {past}")]
    if not c.oncoming_both(p) and lane_is_cleared(p, c.party(p.target)):
        away = scope.number(round(HALF_LANE + WIDTH[c.party(p.target).type] / 2, 1))  # type: ignore[union-attr]
        gone = f"until {LANE_NAME[c.lane or 0]}.centerline.distanceTo({c.actor.ref(p.target)}.position) > {away}"
        near = CLOSE + max(c.value - c.target_speed(p), 0.0) ** 2 / (2 * BRAKES)
        behind = c.drive(f"lambda: following_speed(self, {nearest(c, p)}, {c.actor.speed}, {HEADWAY})", 4)
        c.behind = ""
        comes_up = f"{gone} or gap(self, {c.actor.ref(p.target)}) < {scope.number(round(near))}"
        return [([c.drive()], comes_up), ([behind], gone), ([c.drive()], f"until {past}")]
    waits = _waits(c, p)
    home, step = c.lane, -1 if p.side == "right" else 1
    changes = home is not None and not c.oncoming_both(p) and not _by_offset(c, p)
    aside = ""
    if changes:
        line = c.onto(step)
        c.lane = home
        back = c.along_lane()
        out, home_again = [line, c.drive(c.speed)], [back, c.drive(c.speed)]
    else:
        inside = INSIDE if c.actor.spec.type in NARROW else max(sideways(c.other(p.target)), _kept_aside(c, p))
        aside = scope.number(-inside if p.side == "right" else inside)
        out, home_again = [c.drive(c.speed, offset=aside, shift=2)], [c.drive(c.speed)]
    if p.abandoned:
        return [*waits, *_breaks_off(c, p, out, home_again, aside)]
    return [*waits, (out, f"until {past}"), *([] if scrapes or cut is not None else [(home_again, BACK)])]


def _kept_aside(c: Course, p: Phase) -> float:
    """How far (m) to the side it passes at least, by the room that S keeps between the two; 0: it says nothing."""
    pair = {called(c.actor.cid), p.target or "ego"}
    limits = getattr(c.actor.structure.restrictions.spec, "limits", ())
    rooms = [li.minimum for li in limits if li.kind == "gap" and li.minimum and {li.subject, li.other} == pair]
    rooms += [middle(p.clearance)] if p.clearance is not None else []
    whom = c.other(p.target)
    if not rooms or whom is None:
        return 0.0
    return round(max(rooms) + (WIDTH[c.actor.spec.type] + WIDTH[whom.type]) / 2, 1)


def pulls_out(c: Course, p: Phase) -> str:
    """The condition under which it is time to pull out behind whom it overtakes; "": that one clears the lane."""
    if lane_is_cleared(p, c.party(p.target)):
        return ""
    if threatened := _spoils(c, p)[0]:
        return f"until {threatened}"
    closing = max(_top(c, p) - c.target_speed(p), faster(c.other(p.target)))
    if _waits(c, p):
        closing += WARY
    near = pull_out(closing, p.abandoned and _spoiled_by(c, p) is None)
    return f"until gap(self, {nearest(c, p)}) < {scope.number(near)}"


def _top(c: Course, p: Phase) -> float:
    """The speed (m/s) at which it overtakes."""
    return c.wanted(p, max(c.value, c.target_speed(p) + faster(c.other(p.target))))


def _ahead(c: Course, p: Phase) -> str:
    """How far (m) its middle is ahead of the other's when it comes back."""
    return f"{scope.number(comes_back(p, _top(c, p) - c.target_speed(p)))} + self.length"


def _breaks_off(c: Course, p: Phase, out: list[str], back: list[str], aside: str) -> list[Step]:
    """Out beside the other's tail, or until what comes next, and back behind it after that."""
    other, closing = nearest(c, p), _top(c, p) - c.target_speed(p)
    behind = f"lambda: following_speed(self, {other}, {c.speed}, {HEADWAY})"
    slower = [out[-1].replace(f"line, {c.speed}", f"line, lambda: max(0, {other}.speed - 3)")]
    if _spoiled_by(c, p) is not None:
        far = f"until lead_on(self, {other}) < -6 - self.length"
        c.home, c.aside = [(slower, far), ([*back[:-1], c.drive(behind, 4)], "")], aside
        return [(out, "")]
    slower = [slower[0].replace(", offset", ", rate=5, offset")]
    home: list[Step] = [(slower, f"until ahead_by({other}, self) > 1"), ([*back[:-1], c.drive(behind, 5)], BACK)]
    cause = _spoils(c, p)[1] or f"ahead_by({other}, self) < {scope.number(to_slow(closing))}"
    return [(out, f"until {cause}"), *home]


def _spoils(c: Course, p: Phase) -> tuple[str, str]:
    """By when one pulls out to overtake that will break off, and what then makes it, where S says neither: somebody who
    comes towards it, or that whom it overtakes leaves the middle of its lane; "", "": nothing does."""
    if not p.abandoned or p.trigger is not None or _spoiled_by(c, p) is not None or not _by_offset(c, p):
        return "", ""
    whom = c.other(p.target)
    aside = [q for q in (whom.phases if whom else ()) if q.action in ("swerve", "drift") and q.side != "right"]
    awaits = ((q.trigger.kind, q.trigger.of, q.trigger.action) for q in aside if q.trigger)
    if ("action", called(c.actor.cid), "overtake") in awaits:
        return "", f"off_lane({c.actor.ref(p.target)})"
    comes = [o.id for o in c.actor.structure.objects if isinstance(o.spec, ObjectSpec) and comes_towards(o.spec)]
    if not c.actor.is_ego:
        comes = ["ego"] if c.oncoming else [cid for cid in comes if cid not in (c.actor.cid, p.target)]
    if not comes:
        return "", ""
    seconds = f"ttc(self, {c.actor.ref(comes[0])}) < "
    return f"{seconds}{scope.number(THREATENED)}", f"{seconds}{scope.number(SPOILED)}"


def _spoiled_by(c: Course, p: Phase) -> Phase | None:
    """The phase whose trigger says when an overtaking is broken off."""
    phases = c.actor.spec.phases
    after = phases[phases.index(p) + 1 :] if p in phases else ()
    return after[0] if after and after[0].trigger is not None else None


def nearest(c: Course, p: Phase) -> str:
    """The first that it passes: whom it overtakes, or who drives in the lane between the two."""
    cid, seen = p.target, set[str]()
    at, whom = getattr(c.actor.spec, "placement", None), c.other(cid)
    if at and (at.position, at.of) == ("behind", "ego") and whom and whom.placement.position == "ahead":
        return "ego"
    while (spec := c.other(cid)) and spec.placement.position == "ahead" and c.other(spec.placement.of):
        if spec.placement.of in (*seen, c.actor.cid):
            break
        cid = spec.placement.of
        seen.add(cid)
    return members(c.actor.structure, cid)[-1] if cid and c.oncoming_both(p) else c.actor.ref(cid)


def _by_offset(c: Course, p: Phase) -> bool:
    """Whether it passes within the lane, or by the line of the other direction, without changing lanes."""
    offsets, home = c.actor.plan.offsets, c.lane or 0
    spec = c.other(p.target)
    alone = home + 1 not in offsets and home - 1 not in offsets
    return alone or spec is not None and spec.type in NARROW and p.side != "right"


def _waits(c: Course, p: Phase) -> list[Step]:
    """Behind whom it overtakes, while somebody comes towards ego in the lane by which it passes; none: it goes."""
    ego = c.actor.spec
    if not isinstance(ego, EgoSpec) or p.side == "right" or not _by_offset(c, p) or ego.reaction == "none":
        return []
    after = {q.action for q in ego.phases[ego.phases.index(p) + 1 :]} if p in ego.phases else set()
    if after & BREAKS_OFF or p.abandoned:
        return []
    comes = [o for o in c.actor.structure.objects if isinstance(o.spec, ObjectSpec) and comes_towards(o.spec)]
    if any(o.id == ego.react_to or hits_ego(o.spec) or is_hit(ego, o.id) for o in comes):  # type: ignore[arg-type]
        return []
    gone = [f"(passed({one}, self, 0) or {one}.speed < 0.3)" for o in comes for one in members(c.actor.structure, o.id)]
    behind = c.drive(f"lambda: following_speed(self, {nearest(c, p)}, {c.actor.speed}, {HEADWAY})", 5)
    return [([behind], f"until {' and '.join(gone)}")] if gone else []


def comes_towards(spec: ObjectSpec) -> bool:
    """Whether somebody drives towards ego in the next lane."""
    return spec.placement.position == "oncoming_lane" and is_vehicle(spec.type) and not is_static(spec)


def _passed_actors(c: Course, p: Phase) -> list[str]:
    """Those it passes before it may come back: all members where they are in its lane, else the first."""
    if p.target is None or p.target not in c.actor.structure or not (c.same_lane(p) or c.oncoming_both(p)):
        return [c.actor.ref(p.target)]
    return members(c.actor.structure, p.target)


def _cuts_in(c: Course, p: Phase) -> Phase | None:
    """The cut-in by which it comes back before the one that it overtakes."""
    phases = c.actor.spec.phases
    then = next(iter(phases[phases.index(p) + 1 :]), None) if p in phases else None
    if then is None or then.action != "cut_in" or then.abandoned or p.abandoned:
        return None
    return then if (then.target or "ego") == (p.target or "ego") else None


def _scrapes(c: Course, p: Phase) -> bool:
    """Whether it hits the one that it overtakes."""
    phases = c.actor.spec.phases
    after = phases[phases.index(p) + 1 :]
    return any(q.action == "collide" and q.target == p.target for q in after)
