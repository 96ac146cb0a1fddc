"""Phases to a Scenic behaviour: each becomes one `do`, ended by the next phase's trigger or its own completion."""

from dataclasses import dataclass, field

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Trigger
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.plan import LANE_NAME, Plan, speed_of
from c2s_engine.write.typed.tables import is_static

LANE_WIDTH = 3.5
FORCED = {"brake", "stop", "swerve", "lane_change"}
DELAYED = {
    "brake", "stop", "swerve", "lane_change", "cut_out", "drift", "lose_control", "leave_road",
    "accelerate", "oncoming",
}  # fmt: skip
ONWARD = {"start", "wait", "go_straight", "turn_left", "turn_right", "accelerate"}
IN_WAY = {"ahead", "partly_in_lane", "intersection_exit"}


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

    def ref(self, cid: str | None) -> str:
        """The code for another party: the one named, or ego (for ego: the first object)."""
        if cid:
            return scope.reference(self.structure, cid)
        if not self.is_ego:
            return "ego"
        return self.others[0] if self.others else "ego"


def body(actor: Actor) -> list[str]:
    """The statements of the behaviour (not indented)."""
    return _Script(actor).lines()


class _Script:
    def __init__(self, actor: Actor):
        self.a = actor
        self.k = actor.lane
        self.speed = actor.speed  # the speed expression now in force
        self.value = actor.value

    def lines(self) -> list[str]:
        a = self.a
        out = [f"line = {a.line}"]
        if a.value > 0:
            out.append(f"take SetSpeedAction({a.speed})")
        phases = self._phases()
        steps: list[tuple[list[str], str]] = []  # statements, completion condition of the last `do`
        if not phases or self._begins_later(phases[0]):
            steps.append(([self._drive()], ""))
        for i, phase in enumerate(phases):
            condition = self._trigger(phase, i)
            if condition:
                if not steps:
                    steps.append(([self._drive()], ""))
                steps[-1] = (steps[-1][0], condition)
            steps.extend(self._steps(phase))
        for i, (statements, until) in enumerate(steps):
            last = i == len(steps) - 1
            *before, final = statements
            out += before
            if not final.startswith("do Drive") and not until or last:
                out.append(final)
            else:
                out.append(f"{final} {until or 'for 3 seconds'}")
        return out

    # What is done.

    def _phases(self) -> list[Phase]:
        """The phases, with what the place asks of ego (its red light, its stop sign) put first."""
        a = self.a
        phases = list(a.spec.phases)
        if not a.is_ego or not a.plan.junction:
            return phases
        edge = Trigger(kind="place", place="intersection", value=0)
        for i, (phase, then) in enumerate(zip(phases, phases[1:], strict=False)):
            if phase.action == "stop" and phase.trigger is None and then.action in ONWARD:  # at the junction's edge
                phases[i] = phase.model_copy(update={"trigger": edge})
        actions = {p.action for p in phases}
        light = getattr(a.structure.settings.spec, "light", None)
        control = a.plan.place.control
        if control == "signal" and light == "red" and not actions & {"run_red", "stop", "stationary"}:
            return [*phases, Phase(action="stop", trigger=edge)]
        if (
            control == "stop"
            and not actions & {"run_stop", "stop", "yield"}
            and getattr(a.spec, "reaction", "") != "yield"
        ):
            stop = Phase(action="stop", trigger=edge)
            return [stop, Phase(action="wait", duration=1.0), Phase(action="start"), *phases]
        return phases

    def _begins_later(self, phase: Phase) -> bool:
        return phase.trigger is not None or bool(self._implicit(phase))

    def _drive(
        self, speed: str | None = None, rate: float | None = None, offset: str = "", shift: float | None = None
    ) -> str:
        goal = speed if speed is not None else self._cruise()
        extra = f", rate={scope.number(rate)}" if rate else ""
        extra += f", offset={offset}" if offset else ""
        extra += f", shift={scope.number(shift)}" if shift else ""
        return f"do Drive(line, {goal}{extra})"

    def _cruise(self) -> str:
        spec = self.a.spec
        if isinstance(spec, EgoSpec) and spec.reaction == "follow" and self.a.others:
            return f"lambda: pace(self, {self.a.ref(spec.react_to)}, {self.speed})"
        return self.speed

    # When it begins.

    def _trigger(self, phase: Phase, index: int) -> str:
        t = phase.trigger
        if t is None:
            return self._implicit(phase, index == 0)
        other = self.a.ref(t.of)
        value = middle(t.value) if t.value is not None else None
        if t.kind == "time":
            return f"until simulation().currentTime * simulation().timestep >= {scope.number(value or 3)}"
        if t.kind == "ttc":
            return f"until ttc(self, {other}) < {scope.number(value or 3)}"
        if t.kind == "place":
            return self._before_junction(value or 0, phase)
        if t.kind == "action":
            return f"until {self._observed(other, t)}"
        return f"until (distance from self to {other}) < {scope.number(value or 25)}"

    def _before_junction(self, value: float, phase: Phase) -> str:
        lane = self.a.approach or ("egoLane" if self.a.plan.junction else None)
        if lane is None:
            return "for 4 seconds"
        room = value + 4
        if phase.action in ("stop", "yield", "wait", "brake") and value < 12:
            rate = middle(phase.rate) if phase.rate else 3
            end = f"{lane}.centerline[-1]"
            braking = f"self.speed ** 2 / {scope.number(2 * rate)}"
            return f"until (distance from self to {end}) < {scope.number(room)} + {braking}"
        return f"until (distance from self to {lane}.centerline[-1]) < {scope.number(room)}"

    def _observed(self, other: str, t: Trigger) -> str:
        return observed(self.a.structure, other, t.of or "ego", t.action)

    def _implicit(self, phase: Phase, first: bool = True) -> str:
        """The trigger of a phase that names none: what ego is forced to waits for the need, a cut-in for its gap."""
        a = self.a
        if phase.trigger is not None:
            return ""
        if phase.action in ("lane_change", "cut_in") and self._on_ramp():
            return "until self._lane is accelerationLane"
        if a.is_ego and phase.action in FORCED and self._confronted(phase):
            other = a.ref(phase.target or getattr(a.spec, "react_to", None))
            hard = getattr(a.spec, "hard", False) or (phase.rate is not None and middle(phase.rate) >= 4)
            limit = 1.2 if phase.action in ("swerve", "lane_change") else 4 if hard else 2
            return f"until need(self, {other}) > {limit}"
        if phase.action == "cut_in":
            return f"until 5 < lead_on(self, {a.ref(phase.target)}) - self.length < {scope.number(self._cut_in_gap())}"
        if phase.action == "overtake" and self.k is not None and self._same_lane(phase):
            return f"until (distance from self to {a.ref(phase.target)}) < 12 + 0.8 * self.speed"
        if obstacle := self._obstacle() if phase.action in ("swerve", "cut_out", "lane_change") else "":
            return f"until (distance from self to {obstacle}) < 12 + 1.3 * self.speed"
        if not first or phase.action not in DELAYED or a.value <= 0:
            return ""
        if self._oncoming():
            return f"until (distance from self to ego) < {scope.number(2.8 * (a.value + a.plan.ego_speed))}"
        return "for 3 seconds"

    def _obstacle(self) -> str:
        """What stands in its lane ahead of it, if anything does: another's evasion waits for that."""
        a = self.a
        if a.is_ego or self.k is None:
            return ""
        for c in a.structure.objects:
            spec = c.spec
            if c.id == a.cid or not isinstance(spec, ObjectSpec) or not is_static(spec):
                continue
            if (
                a.plan.lane_of.get(c.id) == self.k
                and spec.placement.position == "ahead"
                and spec.placement.of in (a.cid, "ego")
            ):
                return a.ref(c.id)
        return ""

    def _oncoming(self) -> bool:
        placement = getattr(self.a.spec, "placement", None)
        return bool(placement and placement.position in ("oncoming_lane", "opposite_approach"))

    def _confronted(self, phase: Phase) -> bool:
        """Whether the one that ego reacts to is, or comes, in its way."""
        a = self.a
        cid = phase.target or getattr(a.spec, "react_to", None)
        if cid is None:
            return bool(a.others)
        if cid == "ego" or cid not in a.structure:
            return False
        spec = a.structure[cid].spec
        if not isinstance(spec, ObjectSpec):
            return False
        if spec.placement.position == "behind" or spec.placement.along == "behind":
            return any(p.action in ("cut_in", "overtake") for p in spec.phases) and phase.action in ("brake", "stop")
        return spec.placement.position in IN_WAY or not is_static(spec)

    def _on_ramp(self) -> bool:
        """Whether it comes up the ramp and has not yet changed onto the motorway."""
        a = self.a
        if a.is_ego:
            return a.plan.place.kind == "on_ramp" and self.k == 0
        placement = getattr(a.spec, "placement", None)
        return bool(placement and placement.position == "on_ramp" and self.k is None)

    def _cut_in_gap(self) -> float:
        placement = getattr(self.a.spec, "placement", None)
        gap = middle(placement.gap) if placement and placement.gap is not None and placement.along != "behind" else 0
        slower = self.a.value < self.a.plan.ego_speed - 1
        return max(25.0, 0.0 if slower else gap + 8)

    def _same_lane(self, phase: Phase) -> bool:
        target = phase.target
        there = 0 if target in (None, "ego") else self.a.plan.lane_of.get(target)
        return self.k == there

    # The steps of one phase: statements, the last of them a `do`, and the condition that ends it.

    def _steps(self, p: Phase) -> list[tuple[list[str], str]]:
        method = getattr(self, f"_do_{p.action}", None) or self._do_keep_lane
        return method(p)

    def _to(self, p: Phase, default: float) -> float:
        return middle(p.speed) if p.speed is not None else default

    def _set(self, value: float) -> str:
        """Drive at another speed from now on; the cruising constant stays where it is the same."""
        if abs(value - self.value) < 0.05:
            self.speed = self.a.speed
        else:
            self.speed = scope.number(value)
        return self._cruise()

    def _ending(self, p: Phase, natural: str) -> str:
        return f"for {scope.quantity(p.duration)} seconds" if p.duration is not None else natural

    def _do_keep_lane(self, p: Phase) -> list[tuple[list[str], str]]:
        goal = self._set(self._to(p, self.value))
        return [([self._drive(goal, middle(p.rate) if p.rate else None)], self._ending(p, ""))]

    _do_run_red = _do_run_stop = _do_keep_lane

    def _do_turn_left(self, p: Phase) -> list[tuple[list[str], str]]:
        """The line already turns; the phase is over when the junction is behind."""
        goal = self._set(self._to(p, self.value))
        if not (self.a.plan.junction and (self.a.is_ego or self.a.approach or self.k is not None)):
            return [([self._drive(goal)], self._ending(p, ""))]
        return [
            ([self._drive(goal)], "until self._intersection"),
            ([self._drive(goal)], "until not self._intersection"),
        ]

    _do_turn_right = _do_go_straight = _do_turn_left

    def _do_stationary(self, p: Phase) -> list[tuple[list[str], str]]:
        return [([self._drive("0", 4)], self._ending(p, ""))]

    def _do_accelerate(self, p: Phase) -> list[tuple[list[str], str]]:
        goal = self._to(p, max(self.value * 1.4, self.value + 5))
        self._set(goal)
        self.value = goal
        return [
            (
                [self._drive(rate=middle(p.rate) if p.rate else 2.5)],
                self._ending(p, f"until self.speed > {scope.number(goal - 0.5)}"),
            )
        ]

    def _do_brake(self, p: Phase) -> list[tuple[list[str], str]]:
        goal = self._to(p, self.value / 2)
        rate = middle(p.rate) if p.rate else (6 if getattr(self.a.spec, "hard", False) else 3)
        self._set(goal)
        return [
            ([self._drive(scope.number(goal), rate)], self._ending(p, f"until self.speed < {scope.number(goal + 0.5)}"))
        ]

    def _do_stop(self, p: Phase) -> list[tuple[list[str], str]]:
        rate = middle(p.rate) if p.rate else (7 if getattr(self.a.spec, "hard", False) else 3.5)
        return [
            ([self._drive("0", rate)], "until self.speed < 0.2"),
            ([self._drive("0", rate)], self._ending(p, "for 1 seconds")),
        ]

    def _do_wait(self, p: Phase) -> list[tuple[list[str], str]]:
        return [([self._drive("0", 4)], self._ending(p, "for 3 seconds"))]

    def _do_start(self, p: Phase) -> list[tuple[list[str], str]]:
        goal = self._to(p, self.a.value or 8)
        self._set(goal)
        return [
            (
                [self._drive(scope.number(goal) if not self.a.value else None, 2)],
                self._ending(p, f"until self.speed > {scope.number(goal - 0.5)}"),
            )
        ]

    def _lane(self, k: int) -> str:
        return LANE_NAME[k]

    def _change(self, p: Phase, default: int) -> tuple[list[str], int]:
        """The statement that makes a neighbouring lane the line to follow."""
        if self.k is None:  # from a ramp, the kerb or a parking lane onto ego's lane
            self.k = 0
        else:
            step = -1 if p.side == "right" else 1 if p.side == "left" else default
            if self.k + step not in self.a.plan.offsets and self.k - step in self.a.plan.offsets:
                step = -step
            self.k += step
        leaving = ", egoTurn" if self.a.plan.place.kind == "off_ramp" and self.k == -1 and self.a.is_ego else ""
        return [f"line = way({self._lane(self.k)}{leaving})"], self.k

    def _do_lane_change(self, p: Phase) -> list[tuple[list[str], str]]:
        if self.k is not None and len(self.a.plan.offsets) == 1 and not self._on_ramp():
            side = -1 if p.side == "right" else 1
            return [
                (
                    [self._drive(self._set(self._to(p, self.value)), offset=scope.number(side * LANE_WIDTH))],
                    self._ending(p, "for 6 seconds"),
                )
            ]
        lines, _ = self._change(p, 1)
        return [([*lines, self._drive(self._set(self._to(p, self.value)))], self._ending(p, "for 5 seconds"))]

    _do_cut_out = _do_lane_change

    def _do_cut_in(self, p: Phase) -> list[tuple[list[str], str]]:
        target = p.target
        self.k = 0 if target in (None, "ego") else self.a.plan.lane_of.get(target) or 0
        change = [f"line = way({self._lane(self.k)})", self._drive(self._set(self._to(p, self.value)))]
        steps = [(change, self._ending(p, "for 4 seconds"))]
        ego = self.a.structure.ego.spec
        if (
            getattr(ego, "reaction", "") == "brake"
            and self.value > self.a.plan.ego_speed - 1
            and p == self.a.spec.phases[-1]
        ):
            slower = self._drive(scope.number(0.75 * min(self.value, self.a.plan.ego_speed)), 3)
            steps = [(change, "for 2.5 seconds"), ([slower], "for 3 seconds"), ([self._drive()], "")]
        return steps

    def _do_enter_road(self, p: Phase) -> list[tuple[list[str], str]]:
        self.k = 0
        goal = self._to(p, self.a.value or 7)
        self.value, self.speed = goal, scope.number(goal)
        return [
            (
                ["line = way(egoLane)", self._drive(scope.number(goal), middle(p.rate) if p.rate else 3)],
                self._ending(p, "for 5 seconds"),
            )
        ]

    def _do_overtake(self, p: Phase) -> list[tuple[list[str], str]]:
        other = self.a.ref(p.target)
        goal = self._to(p, max(self.value, self._target_speed(p) + 5))
        self._set(goal)
        past = f"until lead_on(self, {other}) > 12 + self.length"
        if not self._same_lane(p) or self.k is None:
            return [([self._drive()], past)]
        home = self.k
        if home + 1 in self.a.plan.offsets or home - 1 in self.a.plan.offsets:
            lines, _ = self._change(p, 1)
            self.k = home
            return [
                ([*lines, self._drive()], past),
                ([f"line = way({self._lane(home)})", self._drive()], "for 5 seconds"),
            ]
        return [([self._drive(offset=scope.number(LANE_WIDTH), shift=2)], past), ([self._drive()], "for 5 seconds")]

    def _target_speed(self, p: Phase) -> float:
        if p.target in (None, "ego"):
            return self.a.plan.ego_speed if not self.a.is_ego else 0
        spec = self.a.structure[p.target].spec
        return middle(speed_of(spec, self.a.plan.place)) if isinstance(spec, ObjectSpec) else 0

    def _do_follow(self, p: Phase) -> list[tuple[list[str], str]]:
        self._set(self._to(p, self.value))
        return [([self._drive(f"lambda: pace(self, {self.a.ref(p.target)}, {self.speed})", 4)], self._ending(p, ""))]

    def _sideways(self, p: Phase, metres: float, shift: float, seconds: float | None) -> list[tuple[list[str], str]]:
        side = -1 if p.side == "right" else 1 if p.side == "left" else -1 if metres < 0 else 1
        out = self._drive(self._set(self._to(p, self.value)), offset=scope.number(side * abs(metres)), shift=shift)
        if seconds is None:
            return [([out], self._ending(p, ""))]
        return [([out], self._ending(p, f"for {scope.number(seconds)} seconds")), ([self._drive()], "for 3 seconds")]

    def _do_swerve(self, p: Phase) -> list[tuple[list[str], str]]:
        return self._sideways(p, 2.2, 2.5, 2.5)

    def _do_lose_control(self, p: Phase) -> list[tuple[list[str], str]]:
        return self._sideways(p, 2.0, 4, 1.5)

    def _do_drift(self, p: Phase) -> list[tuple[list[str], str]]:
        return self._sideways(p, -3.2, 0.7, None)

    def _do_leave_road(self, p: Phase) -> list[tuple[list[str], str]]:
        k = self.k or 0
        width = LANE_WIDTH * (max(self.a.plan.offsets) - k if p.side == "left" else k - min(self.a.plan.offsets))
        return self._sideways(p, -(width + 5), 2, None)

    def _do_oncoming(self, p: Phase) -> list[tuple[list[str], str]]:
        return self._sideways(p, LANE_WIDTH, 2, middle(p.duration) if p.duration is not None else None)

    def _do_u_turn(self, p: Phase) -> list[tuple[list[str], str]]:
        return [(["do TurnRound()"], ""), (["line = way(oncomingLane)", self._drive(scope.number(self._to(p, 8)))], "")]

    def _do_reverse(self, p: Phase) -> list[tuple[list[str], str]]:
        return [([f"do Backwards({scope.number(self._to(p, 2))})"], self._ending(p, ""))]

    def _do_yield(self, p: Phase) -> list[tuple[list[str], str]]:
        other = self.a.ref(p.target)
        lane = self.a.approach or ("egoLane" if self.a.plan.junction else None)
        go = ([self._drive(self._set(self._to(p, self.a.value or 8)), 2)], "for 4 seconds")
        if lane is None:
            return [([self._drive("0", 4)], f"until passed({other}, self) or passed({other}, self, 0)"), go]
        if self._same_lane(p):  # it is ahead: behind it up to the junction
            go = (go[0], "")
            behind = f"do Drive(line, lambda: pace(self, {other}, {self.speed}), rate=4)"
            clear = f"passed({other}, self, 14)"
            if lane:  # it has gone on over the junction, and we are there
                end = f"{lane}.centerline[-1]"
                clear = f"(distance from {other} to {end}) > 14 and (distance from self to {end}) < 14"
            return [([behind], f"until {clear}"), go]
        near = f"until (distance from self to {lane}.centerline[-1]) < 5 + self.speed ** 2 / 6"
        return [([self._drive()], near), ([self._drive("0", 3)], f"until passed({other}, self)"), go]

    def _do_collide(self, p: Phase) -> list[tuple[list[str], str]]:
        other = self.a.ref(p.target)
        goal = self._to(p, self.value)
        self._set(goal)
        if self.k is None and not self.a.is_ego:
            turn = ", egoTurn" if self.a.plan.turning else ""
            return [
                (
                    [
                        f"spot = meeting(line, way(egoLane{turn}))",
                        f"do Drive(line, lambda: meet(self, {other}, spot, {self.speed}))",
                    ],
                    "",
                )
            ]
        faster = max(goal, self._target_speed(p) + 4) if self._same_lane(p) else goal
        return [([self._drive(scope.number(faster) if faster > goal else None)], "")]


def observed(structure: Structure, other: str, cid: str, action: str | None) -> str:
    """What can be seen of another's action while it is at it."""
    if action in ("stop", "stationary", "wait"):
        return f"{other}.speed < 0.3"
    if action in ("start", "accelerate", "enter_road", "cross_road", "move_along"):
        return f"{other}.speed > 0.5"
    if action == "brake":
        spec = structure.ego.spec if cid in ("E", "ego") else structure[cid].spec
        prefix = "EGO" if cid in ("E", "ego") else scope.constant(structure, cid)
        moving = cid in ("E", "ego") or isinstance(spec, ObjectSpec) and not is_static(spec)
        known = moving and getattr(spec, "speed", None) not in (None, 0)
        return f"{other}.speed < {prefix}_SPEED - 1.5" if known else f"{other}.speed < 3"
    if action in ("turn_left", "turn_right", "go_straight", "run_red", "run_stop"):
        return f"{other}._intersection is not None"
    if action == "cut_in":
        return f"{other}._lane is egoLane"
    if action in ("lane_change", "cut_out"):
        return f"{other}._lane is not egoLane"
    return f"(distance from ego to {other}) < 20"


def reaction(actor: Actor, statements: list[str]) -> list[str]:
    """Ego's reaction laid around its own way: what it does when something forces it to."""
    spec = actor.spec
    assert isinstance(spec, EgoSpec)
    threats = [scope.reference(actor.structure, spec.react_to)] if spec.react_to else list(actor.others)
    if spec.reaction != "brake" or not threats:
        return statements
    limit, rate = (4, 8) if spec.hard else (2, 5)
    if any(p.action == "collide" for p in spec.phases):  # it brakes, but too little
        limit, rate = 3, 2
    force = f"need(self, {threats[0]})"
    if len(threats) > 1 or threats[0].startswith("*"):
        force = f"most_need(self, [{', '.join(threats)}])"
    head, rest = statements[:1], statements[1:]
    return [
        *head,
        "try:",
        *(f"    {s}" for s in rest),
        f"interrupt when {force} > {limit}:",
        f"    do Drive(line, 0, rate={rate}) until {force} <= 0",
    ]


def reacting_phases(spec: EgoSpec, others: list[str], plan: Plan) -> tuple[Phase, ...]:
    """Ego's phases with those that its place and its reaction add: merging, leaving, yielding, evading."""
    phases = spec.phases
    changes = {"lane_change", "cut_in", "overtake"} & {p.action for p in phases}
    if plan.place.kind == "on_ramp" and not changes:
        spec = spec.model_copy(update={"phases": (*phases, Phase(action="lane_change", side="left"))})
    if plan.place.kind == "off_ramp" and -1 in plan.offsets and not changes:
        spec = spec.model_copy(update={"phases": (*phases, Phase(action="lane_change", side="right"))})
    actions = {p.action for p in spec.phases}
    if spec.reaction == "yield" and others and "yield" not in actions:
        return (Phase(action="yield", target=spec.react_to), *spec.phases)
    if spec.reaction == "evade" and others and not actions & {"lane_change", "swerve", "overtake", "oncoming"}:
        return (*spec.phases, Phase(action="lane_change", side="left", target=spec.react_to))
    return spec.phases


def threatening(structure: Structure) -> list[str]:
    """The objects that may come into ego's way: all that move, and what stands in its lane."""
    found = []
    for c in structure.objects:
        spec = c.spec
        if not isinstance(spec, ObjectSpec):
            continue
        if spec.placement.position in IN_WAY or not is_static(spec):
            name = scope.variables(structure)[c.id]
            many = spec.count > 1 or spec.type in ("construction_zone", "lane_closure")
            found.append(f"*{name}" if many else name)
    return found
