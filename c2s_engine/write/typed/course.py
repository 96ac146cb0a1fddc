"""A vehicle whose behaviour is written, and where on its course the writing stands."""

from dataclasses import dataclass, field

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase
from c2s_engine.write.typed import lateral, pockets, scope
from c2s_engine.write.typed.alongside import offset, pulls_out
from c2s_engine.write.typed.lanes import oncoming
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.stations import outwards, parked_in_way
from c2s_engine.write.typed.tables import DEFAULT_SPEED, LANE_NAME, TURN, WIDTH, is_static
from c2s_engine.write.typed.usual import rides_beside, speed_of, turn_of

GENTLY = {"bicycle", "truck", "bus", "fire_truck"}
GENTLE = 2.4
"""m/s2 by which the speed of riders and heavy vehicles changes, where nothing says how."""
USUAL_GAP, USUAL_HEADWAY = 4.0, 1.5
"""m and s: how one follows another, as `following_speed` in the driving library has it."""
HALF_LANE = 1.75
"""m from the lane's middle to its edge, on most maps."""
IN_ITS_WAY = 0.5
"""m by which one at the edge of the lane overlaps with ego, before that swerves too late."""
WHERE_IT_IS = "self.beside"
"""m to the left of its lane's middle, as a drive begins."""
EDGE = 1.6
"""m from the lane's middle to where those partly in it start, and riders stay."""


@dataclass
class Actor:
    """A vehicle whose behaviour is written."""

    cid: str  # component id; "E" for ego
    spec: EgoSpec | ObjectSpec
    structure: Structure
    plan: Plan
    line: str  # expression for the points that it follows at first
    lane: int | None  # lane offset from ego's, where it drives in ego's direction
    speed: str  # the constant's name
    value: float  # its value, m/s
    approach: str | None = None  # the lane variable by which it reaches the junction
    others: list[str] = field(default_factory=list)  # references to those it may have to react to

    @property
    def is_ego(self) -> bool:
        return self.cid == "E"

    @property
    def sets_out(self) -> bool:
        """Whether it stands before the junction and sets out into ego's way."""
        return self.cid in self.plan.set_out

    @property
    def to_junction(self) -> str | None:
        """The lane by which it reaches the junction, if it does."""
        return self.approach or ("place.lane" if self.plan.junction else None)

    def ref(self, cid: str | None) -> str:
        """The code for another party: the one named, or ego (for ego: the first object)."""
        if cid:
            return scope.reference(self.structure, cid)
        if not self.is_ego:
            return "ego"
        return self.others[0] if self.others else "ego"


class Course:
    """What a behaviour has come to as its phases are written: the lane and the speed now in force."""

    def __init__(self, actor: Actor):
        self.actor = actor
        self.lane = actor.lane
        self.speed = actor.speed  # the speed expression now in force
        self.value = actor.value  # m/s
        self.backwards = False
        self.home: list[tuple[list[str], str]] = []  # how it gets back to its lane once it has done what comes next
        self.held = False  # whether it has stopped in the middle of the junction
        self.behind = ""  # whom it overtakes later, where that one is ahead in its lane
        self.out = False  # whether it is out of its lane, and stands there if it stops
        self.aside = _aside(actor)  # m to the left of its lane's middle that it keeps to; "": it keeps to the middle

    # What is driven.

    def drive(
        self, speed: str | None = None, rate: float | str | None = None, offset: str = "", shift: float | None = None
    ) -> str:
        """The `do Drive` at a speed (the one in force; "0": `do Stop`), rate (m/s2), offset (m to the
        left), shift (m/s)."""
        goal = self._guarded(speed if speed is not None else self.cruise())
        rate = rate or (GENTLE if self.actor.spec.type in GENTLY else None)
        extra = f", rate={rate if isinstance(rate, str) else scope.number(rate)}" if rate else ""
        offset = offset or (WHERE_IT_IS if self.out else self.aside)
        extra += f", offset={offset}" if offset else ""
        extra += f", shift={scope.number(shift)}" if shift else ""
        return f"do Stop(line{extra})" if goal == "0" else f"do Drive(line, {goal}{extra})"

    def _guarded(self, goal: str) -> str:
        """The speed that keeps it from running into whom it overtakes later."""
        expression = goal.removeprefix("lambda: ")
        if not self.behind or goal == "0" or f"(self, {self.behind}, " in goal:
            return goal
        return f"lambda: following_speed(self, {self.behind}, {expression})"

    def cruise(self) -> str:
        """The speed in force, or the pace behind whom ego follows."""
        spec = self.actor.spec
        if isinstance(spec, EgoSpec) and spec.reaction == "follow" and self.actor.others:
            speed = self.speed if self.value > 0 else scope.number(DEFAULT_SPEED["car"]["road"])  # it moves off with it
            return self.pacing(spec.react_to, speed)
        if self.actor.is_ego and self.lane == 0 and (slower := self._slower_ahead()):
            return f"lambda: following_speed(self, {self.actor.ref(slower)}, {self.speed})"
        return self.speed

    def _slower_ahead(self) -> str | None:
        """Whom ego comes up to that just drives on ahead in its lane, and does nothing else about than stay behind."""
        spec, met = self.actor.spec, {p.target for p in self.actor.spec.phases}
        for cid, o in self._objects.items():
            calm = {p.action for p in o.phases} <= {"keep_lane"} and not is_static(o)
            named = cid in met or getattr(spec, "react_to", None) in (None, cid)
            ahead = o.placement.position == "ahead" and o.placement.facing != "against"
            if calm and ahead and not named and self.actor.plan.lane_of.get(cid) == 0 \
                    and middle(speed_of(o, self.actor.plan.place)) < self.value - 1:  # fmt: skip
                return cid
        return None

    def pacing(self, cid: str | None, speed: str, gap: float | None = None) -> str:
        """The speed of one that follows another: at a gap (m) that is said, that at which it starts where that is
        nearer than usual and both are as fast, or the usual one."""
        keeps, of = "", cid or next(iter(self._objects), None)
        lead = self._objects.get(of or "")
        start = lead.placement if self.actor.is_ego and lead else getattr(self.actor.spec, "placement", None)
        if gap is None and self.actor.is_ego:
            follows = (p.gap for p in self.actor.spec.phases if p.action == "follow" and (p.target or of) == of)
            gap = next((middle(g) for g in follows if g is not None), None)
        pace = middle(speed_of(lead, self.actor.plan.place)) if lead else self.actor.plan.ego_speed
        directly = start is not None and start.of == ("ego" if self.actor.is_ego or not lead else of)
        if gap is None and directly and start and start.gap is not None and abs(pace - self.value) < 1:
            gap = middle(start.gap)
            gap = gap if gap < USUAL_GAP + USUAL_HEADWAY * pace else None
        if gap is not None:
            seconds, standing = lateral.headway(gap, pace)
            near = f", standstill_gap={scope.number(standing)}" if gap < 4 else ""
            keeps = f", headway={scope.number(seconds)}{near}"
        leaves = lead is not None and any(p.action in ("cut_out", "lane_change", "leave_road") for p in lead.phases)
        if self.actor.is_ego and of is not None and (leaves or self.actor.plan.lane_of.get(of) != self.lane):
            keeps += ", points=line"  # while it is there
        return f"lambda: following_speed(self, {self.actor.ref(cid)}, {speed}{keeps})"

    def set(self, value: float, words: str = "") -> str:
        """Drive at another speed (m/s; `words`: as an expression) from now on; the cruising constant stays where it is
        the same."""
        self.speed = self.actor.speed if abs(value - self.actor.value) < 0.05 else words or scope.number(value)
        return self.cruise()

    def wanted(self, phase: Phase, default: float) -> float:
        """The speed that a phase states, or the default, m/s."""
        return middle(phase.speed) if phase.speed is not None else default

    # Lanes.

    def onto(self, step: int) -> str:
        """The statement that makes the lane `step` lanes to the left the line to follow (the other way if none)."""
        plan = self.actor.plan
        self.aside = self.behind = ""
        if self.lane is None:  # from a ramp, the kerb or a parking lane onto ego's lane
            self.lane = 0
        else:
            if self.lane + step not in plan.offsets and self.lane - step in plan.offsets:
                step = -step
            self.lane += step
        return self.along_lane()

    def along_lane(self) -> str:
        """The statement that makes its lane the line to follow, and what it does at the junction or exit ahead."""
        plan, phases = self.actor.plan, self.actor.spec.phases
        turn = ""
        if plan.place.kind == "off_ramp" and self.lane == -1 and self.actor.is_ego:
            turn = ", place.turn"
        elif plan.junction and any(p.action in TURN for p in phases):
            turn = ", place.turn" if self.actor.is_ego and self.lane == 0 else f", {turn_of(phases)}"
        return f"line = route({LANE_NAME[self.lane or 0]}{'' if turn == ', STRAIGHT' else turn})"

    # How it stands to others.

    def other(self, cid: str | None) -> ObjectSpec | None:
        """The object that a phase is about, if it is one."""
        spec = self.actor.structure[cid].spec if cid and cid in self.actor.structure else None
        return spec if isinstance(spec, ObjectSpec) else None

    def party(self, cid: str | None) -> ObjectSpec | EgoSpec | None:
        """Whom a phase is about: an object, or, for others than ego, ego where nobody or ego is named."""
        ego = self.actor.structure.ego.spec
        return ego if cid in (None, "ego") and not self.actor.is_ego else self.other(cid)  # type: ignore[return-value]

    def target_lane(self, phase: Phase) -> int | None:
        """The lane in which the phase's target starts, as an offset from ego's."""
        return 0 if phase.target in (None, "ego") else self.actor.plan.lane_of.get(phase.target)

    def same_lane(self, phase: Phase) -> bool:
        return self.lane == self.target_lane(phase)

    def target_speed(self, phase: Phase) -> float:
        """The initial speed of the phase's target, m/s."""
        plan = self.actor.plan
        if phase.target in (None, "ego"):
            return 0 if self.actor.is_ego else plan.ego_speed
        spec = self.actor.structure[phase.target].spec
        return middle(speed_of(spec, plan.place)) if isinstance(spec, ObjectSpec) and not is_static(spec) else 0

    @property
    def oncoming(self) -> bool:
        """Whether it comes towards ego, on its road or from the opposite approach."""
        spec = self.actor.spec
        if not isinstance(spec, ObjectSpec):
            return False
        return spec.placement.position == "opposite_approach" or oncoming(spec, self._objects)

    def comes_up_to(self, cid: str) -> bool:
        """Whether it starts behind another object or ego, in that one's lane or at the edge of which that one is."""
        own, target = self.actor.spec, self._objects.get(cid)
        if not isinstance(own, ObjectSpec):
            return False
        if target is None:
            return cid == "ego" and own.placement.of == "ego" and own.placement.position == "behind"
        there = target.placement.position in ("ahead", "partly_in_lane") or parked_in_way(self.actor.structure, cid)
        ahead = there and target.placement.along != "behind"
        return ahead and self.actor.plan.lane_of.get(self.actor.cid) in (0, None)

    def oncoming_both(self, phase: Phase) -> bool:
        """Whether it and the phase's target both come from the other direction."""
        own, target = self.actor.spec, self._objects.get(phase.target or "")
        both = isinstance(own, ObjectSpec) and target is not None
        return both and oncoming(own, self._objects) and oncoming(target, self._objects)  # type: ignore[arg-type]

    @property
    def _objects(self) -> dict[str, ObjectSpec]:
        return {c.id: c.spec for c in self.actor.structure.objects if isinstance(c.spec, ObjectSpec)}

    @property
    def on_ramp(self) -> bool:
        """Whether it comes up the ramp and has not yet changed onto the motorway."""
        actor = self.actor
        if actor.is_ego:
            return actor.plan.place.kind == "on_ramp" and self.lane == 0
        placement = getattr(actor.spec, "placement", None)
        return bool(placement and placement.position == "on_ramp" and self.lane is None)


def _aside(actor: Actor) -> str:
    """Riders who start at the edge of the lane, or go along beside the lanes, stay there; who drives past one that
    waits before the junction keeps to the other side."""
    spec = actor.spec
    if not isinstance(spec, ObjectSpec):
        return _towards_edge(actor)
    if squeezes := pockets.aside(actor.structure, actor.plan, actor.cid):
        return squeezes
    ego = actor.structure.ego.spec
    if isinstance(ego, EgoSpec) and (beside := offset(spec, ego, actor.plan.place)):
        return f"lambda: passing_by(self, ego, {scope.number(beside)})" if pulls_out(spec) else scope.number(beside)
    if rides_beside(spec) and min(actor.plan.offsets) >= 0:
        return scope.number(-(HALF_LANE + outwards(spec)))
    if spec.placement.position != "partly_in_lane" or spec.type not in ("bicycle", "motorcycle"):
        return ""
    return scope.number(EDGE if spec.placement.side == "left" else -EDGE)


def _towards_edge(actor: Actor) -> str:
    """How far (m) to the left of the middle of its lane ego drives that hits somebody at the edge of it in spite of its
    swerving: so near to that edge that it does; "": it keeps to the middle."""
    phases = actor.spec.phases
    hit = {p.target for p in phases if p.action == "collide"} & {p.target for p in phases if p.action == "swerve"}
    for cid in hit:
        other = actor.structure[cid].spec if cid and cid in actor.structure else None
        if isinstance(other, ObjectSpec) and other.placement.position == "partly_in_lane":
            off = EDGE + IN_ITS_WAY - (WIDTH[actor.spec.type] + WIDTH[other.type]) / 2
            return scope.number(round(max(off, 0.0) * (1 if other.placement.side == "left" else -1), 2) or 0)
    return ""
