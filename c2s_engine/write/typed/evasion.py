"""Out of one's lane and back: round what is in the way, and how one slides that has lost control."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec, Phase
from c2s_engine.write.typed import lateral, scope
from c2s_engine.write.typed.collisions import Step, hit_beside, hit_next, ways_cross
from c2s_engine.write.typed.course import Course
from c2s_engine.write.typed.hiding import aside
from c2s_engine.write.typed.passing import BESIDE, NARROW
from c2s_engine.write.typed.stations import parked_in_way
from c2s_engine.write.typed.tables import LANE_WIDTH, WIDTH, is_static, is_vehicle, is_walker
from c2s_engine.write.typed.threats import beside_way, every, members

SLIDING = {"snow": 3.0, "rain": 4.5, "heavy_rain": 4.0, "wet": 4.5}
"""m/s2 at which one slows down that slides, by the weather; else `DRY`."""
DRY = 6.0
PARTLY = 1.8
"""m by which one that slides into the next lane ends beside the middle of its own."""
ASKEW = 0.8
"""The same of one that slides straight into another whose way crosses its own."""
INTO = 0.4
"""rad by which one is turned that slides from the road, so that it is still its front that hits what is there."""
RECOVERS = "for 1.2 seconds"
ENDS = {"stop", "stationary", "wait"}
WHERE = {"drift", "swerve", "lane_change", "cut_out", "oncoming"}
"""What says, after the loss of control, where one ends."""
SWERVES, OVER = 2.2, 1.3
"""m by which one swerves; one that is `WIDE` (m): it is over the line by as much then."""
WIDE = 2.3
CLOSE = 0.2
"""m that are left to who passes one that swerves then."""
SHIFT = 2.5
"""m/s sideways at which one swerves."""
PASSING = 2.0
"""m between one that swerves and whom it passes who is beside its lane, or partly in it: else it would hardly move."""
CLIPS = 0.1
"""m by which one that swerves too late still touches whom it hits."""
CAUTION = 0.7
"""The share of its speed at which one goes round what blocks its lane."""


def grip(structure: Structure, table: dict[str, float], dry: float) -> float:
    """The value of a table for the weather, the least of several; `dry` where none is in it."""
    weather = getattr(structure.settings.spec, "weather", ())
    return min([dry, *(table[w] for w in weather if w in table)])


def loses_control(c: Course, p: Phase) -> list[Step]:
    """A slide out of the lane: to a stand where that is the end of it, else until it is caught."""
    phases = c.actor.spec.phases
    later = phases[phases.index(p) + 1 :] if p in phases else ()
    sided = next((q for q in (p, *later) if q.side), p)
    metres = (-1 if sided.side == "right" else 1) * PARTLY
    if beside := hit_beside(c, p):
        return _slides_into(c, p, beside)
    if any(q.action in ("lane_change", "cut_out", "oncoming") for q in later[:1]):
        metres = metres / PARTLY * LANE_WIDTH
    hit = hit_next(c, p)
    if hit and abs(metres) == PARTLY:
        metres = metres / PARTLY * (ASKEW if ways_cross(c, hit) else LANE_WIDTH)
    rate = grip(c.actor.structure, SLIDING, DRY)
    slides = f"do Skid(line, {scope.number(metres)}, {scope.number(rate)})"
    if hit:
        return [([slides], f"until touch(self, {c.actor.ref(hit.target)})")]
    if any(q.action in ENDS for q in later):
        return [([slides], "until self.speed < 0.2")]
    return [([slides], RECOVERS), ([c.drive()], "for 2 seconds")]


def _slides_into(c: Course, p: Phase, cid: str) -> list[Step]:
    """A slide from the lane straight into what stands beside the road."""
    thing, rate = c.actor.ref(cid), grip(c.actor.structure, SLIDING, DRY)
    spec = c.other(cid)
    left = spec is not None and spec.placement.side == "left"
    slides = f"do Skid(line, {1 if left else -1}, {scope.number(rate)}, {INTO}, target={thing})"
    drive = c.drive(c.set(c.wanted(p, c.value)))
    return [([drive], f"until (distance from self to {thing}) < 15 + 1.5 * self.speed"),
            ([slides], f"until touch(self, {thing})")]  # fmt: skip


def slides_there(c: Course, p: Phase) -> bool:
    """Whether a phase only says where one ends that has lost control before it."""
    phases = c.actor.spec.phases
    before = phases[: phases.index(p)] if p in phases else ()
    lost = any(q.action == "lose_control" for q in before)
    stands = p in phases and any(q.action in ENDS for q in phases[phases.index(p) :])
    return lost and stands and p.action in WHERE and p.trigger is None


def swerves_by(c: Course) -> float:
    """How far (m) one swerves: on two wheels, where another passes it then, to `CLOSE` of that one."""
    if c.actor.spec.type not in NARROW:
        return SWERVES if WIDTH[c.actor.spec.type] < WIDE else OVER
    passed = [p for s in (c.actor.structure.ego, *c.actor.structure.objects) for p in getattr(s.spec, "phases", ())]
    by = any(p.action == "overtake" and p.target == c.actor.cid for p in passed)
    return BESIDE - CLOSE if by else SWERVES


def goes_round(c: Course, p: Phase) -> list[Step]:
    """Out as far as the target takes, past it, past those who are met there, and back."""
    s, target = c.actor.structure, str(p.target)
    free = [step for step in (1, -1) if (c.lane or 0) + step in c.actor.plan.offsets]
    side = {"left": ", 1", "right": ", -1", None: f", {free[0]}" if len(free) == 1 else ""}[p.side]
    partly = (thing := c.other(target)) is not None and thing.placement.position == "partly_in_lane"
    beside = partly or beside_way(s, target) or parked_in_way(s, target)
    wide = middle(p.clearance) if p.clearance is not None else PASSING if beside else None
    room = f", room={scope.number(wide)}" if wide is not None else ""
    aside = f"lambda: way_round(self, line, [{every(s, target)}]{side}{room})"
    steady = p.speed is not None or _small(c, target) or not c.actor.is_ego
    slower, shift = c.speed if steady else scope.number(CAUTION * c.value), lateral.said(p) or SHIFT
    past = " and ".join(f"lead_on({one}, self) < -self.length" for one in members(s, target))
    found = [([c.drive(slower, 4, aside, shift)], f"until {past}")]
    if p.side == "left" and (met := _yielding_oncoming(s)):  # they make way for it
        stays = c.drive(slower, 4, scope.number(0.8 * LANE_WIDTH))
        found.append(([stays], f"until {' and '.join(f'passed({one}, self, 0)' for one in met)}"))
    return [*found, ([c.drive()], "for 3 seconds")]


def last_moment(c: Course, p: Phase) -> tuple[float, float]:
    """Of one that swerves for whom it then hits all the same, in its lane or at the edge of that: how far (m) it gets
    aside, so that it still touches that one, and how long (s) that takes; 0, 0: it does not."""
    hit, spec = hit_next(c, p), c.other(p.target)
    there = spec is not None and spec.placement.position in ("ahead", "partly_in_lane")
    if hit is None or spec is None or not there or not c.actor.is_ego or p.target not in (hit.target, None):
        return 0.0, 0.0
    off = abs(aside(c.actor.structure, str(p.target), c.actor.plan) - float(c.aside or 0))
    metres = max((WIDTH[c.actor.spec.type] + WIDTH[spec.type]) / 2 - off - CLIPS, CLIPS)
    return round(metres, 2), round(lateral.sideways(metres, lateral.said(p) or SHIFT) + 3 * lateral.ANSWERS, 1)


def swerves_too_late(c: Course, p: Phase) -> list[Step]:
    """Out of the way of whom it hits with its side, as far as it gets until then; nothing: it is in time."""
    metres, _ = last_moment(c, p)
    if not metres:
        return []
    out = scope.number(round(float(c.aside or 0) + (-metres if p.side == "right" else metres), 2))
    drive = c.drive(c.set(c.wanted(p, c.value)), offset=out, shift=lateral.said(p) or SHIFT)
    return [([drive], f"until touch(self, {c.actor.ref(p.target)})")]


def _small(c: Course, cid: str) -> bool:
    spec = c.other(cid)
    return spec is not None and is_walker(spec)


def _yielding_oncoming(structure: Structure) -> list[str]:
    """Those who come towards ego in the lane beside its own, and make way for it."""
    objects = [(o.id, o.spec) for o in structure.objects if isinstance(o.spec, ObjectSpec)]
    coming = [i for i, o in objects if o.placement.position == "oncoming_lane" and is_vehicle(o.type)]
    aside = {"drift", "swerve", "leave_road", "lane_change"}
    coming = [i for i in coming if aside & {p.action for p in getattr(structure[i].spec, "phases", ())}]
    return [scope.reference(structure, i) for i in coming if not is_static(structure[i].spec)]  # type: ignore[arg-type]
