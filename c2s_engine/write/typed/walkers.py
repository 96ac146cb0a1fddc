"""What somebody on foot, or on a bicycle from beside the road, does: the behaviour of each, phase by phase."""

from dataclasses import dataclass, field

from c2s_engine.structure.components import Structure
from c2s_engine.structure.crossers import crossed_vehicle
from c2s_engine.structure.quantity import Quantity, high, low, middle
from c2s_engine.structure.specs import ObjectSpec, Phase, Trigger
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.meetings import way_of_ego
from c2s_engine.write.typed.people import (
    ACROSS,
    ON_LANE,
    comes_again,
    ego_reacts,
    ego_stays,
    egos_part,
    stays_there,
    tells_when,
)
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.stations import inside
from c2s_engine.write.typed.tables import LANE_NAME
from c2s_engine.write.typed.usual import pace_of, walks_first
from c2s_engine.write.typed.watching import watched, watches

SLOWED = 0.25
"""m/s within which ego has slowed down to what is said."""
AT_CORNER = 0.7
"""m from the middle of ego's way to who stands before a corner of ego."""
RIDER_GAINS = 1.5
"""m/s2"""
SHORT_OF_LANE = 2.5
"""m from the middle of ego's way to where those stand who let it pass."""
SHORT_OF_KERB = 0.5
"""m before the road's edge where those halt who do not cross after all."""
STARTLED = 0.5
"""s in which somebody on foot does something about what comes into view."""
STEPS_BACK = 1.5
"""m that somebody on foot goes back who has come too far."""
RUN_OUT = 14
"""m by which a rider's line goes on beyond the road: it slows down on the last of them."""
BACK = "self.heading + 180 deg"
"""The direction in which somebody goes back."""


def walker(structure: Structure, cid: str, plan: Plan) -> list[str]:
    """The behaviour of somebody on foot."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    return _Walker(structure, cid, plan, spec).statements()


@dataclass
class _Walker:
    """Somebody on foot, as far as its behaviour is written: the statements, the direction in which it then goes, and
    whether it is on its way across."""

    structure: Structure
    cid: str
    plan: Plan
    spec: ObjectSpec
    lines: list[str] = field(default_factory=list)
    heading: str = "self.heading"
    begun: bool = False

    def statements(self) -> list[str]:
        """One or more for each phase."""
        spec = self.spec
        phases = spec.phases or (Phase(action="stationary" if spec.speed == 0 else "move_along"),)
        if walks_first(spec):
            self.heading = f"self.heading {'-' if spec.placement.side == 'left' else '+'} 90 deg"
        if any(map(_by_egos_way, phases)):
            self.lines.append(f"line = {_egos_way(self.plan)}")
        for i, phase in enumerate(phases):
            if phase.action != "collide" or not self.begun:  # else it is on its way already
                self._does(phase, phases[i - 1] if i else None, phases[i + 1] if i + 1 < len(phases) else None)
        return self.lines

    def _does(self, phase: Phase, before: Phase | None, then: Phase | None) -> None:
        own = f"{scope.constant(self.structure, self.cid)}_SPEED"
        own = scope.quantity(phase.speed) if phase.speed is not None and before is not None else own
        waits, until = then is not None and self._waits(phase, then), self._until(phase, then, own)
        if phase.action in ACROSS:
            self._crosses(phase, before is None, then, own, until)
        elif phase.action == "reverse":
            self._goes_back(phase, before, own, until)
        elif phase.action == "leave_road":
            self._leaves(phase, own, until)
        elif phase.action in ("stop", "stationary", "wait", "yield"):
            self._stands(phase, then, until)
        else:
            self.lines.append(f"do Walk(self.heading, {own}){until or ('' if then is None else ' for 2 seconds')}")
        if then is not None and waits and then.trigger and (delay := _delay(then.trigger)):
            self.lines.append(f"{self.lines[-1].removesuffix(until)} for {scope.quantity(delay)} seconds")

    def _waits(self, phase: Phase, then: Phase) -> bool:
        """Whether what comes next has a moment of its own, at which the phase ends."""
        if then.trigger and phase.duration is None:
            return True
        again = comes_again(self.structure, self.cid, self.spec)
        sets_out = then.action in ACROSS and then.trigger is None  # so that ego is met
        return sets_out and (then is again or not self.begun) and phase.action not in ACROSS

    def _until(self, phase: Phase, then: Phase | None, own: str) -> str:
        """How long a phase lasts; "": until what it does is done."""
        if phase.until is not None:
            return f" until {watched(self.structure, self.plan, phase.until, self.cid)}"
        if then is not None and self._waits(phase, then):
            return f" until {self._sets_out(then, own)}"
        return f" for {scope.quantity(phase.duration)} seconds" if phase.duration is not None else ""

    def _sets_out(self, phase: Phase, own: str) -> str:
        return sets_out(self.structure, self.cid, self.spec, phase, self.plan, own)

    def _crosses(self, phase: Phase, first: bool, then: Phase | None, own: str, until: str) -> None:
        if first:
            waits = f"do Stand() until {self._sets_out(phase, own)}"
            self.lines.append(waits + _as_it_comes_out(self.structure, self.spec, phase, self.plan))
            if phase.trigger and phase.trigger.delay is not None:
                self.lines.append(f"do Stand() for {scope.quantity(phase.trigger.delay)} seconds")
        far = _how_far(self.structure, self.cid, phase, then, self.heading)
        self.lines.append(f"do Walk({self.heading}, {own}, {far}){until}")
        self.heading, self.begun = "self.heading", True
        if until and then is not None and then.action == "reverse":
            self.lines.append(f"do Stand(){until}")

    def _goes_back(self, phase: Phase, before: Phase | None, own: str, until: str) -> None:
        lasts = until if phase.duration is not None or phase.until is not None else ""
        off = before is not None and before.action in ACROSS  # to where it came from
        metres = f"to_far_side(self, line, {BACK})" if off else f"{STEPS_BACK}"
        self.lines.append(f"do Walk({BACK}, {own}{'' if lasts else f', {metres}'}){lasts}")
        self.heading = BACK
        if until != lasts:
            self.lines.append(f"do Stand(){until}")

    def _leaves(self, phase: Phase, own: str, until: str) -> None:
        if not self.begun:  # it is in the lane, and has come along it
            left = (phase.side == "left") != (self.spec.placement.facing == "against")
            back = f"self.heading {'+' if left else '-'} 90 deg"
        else:
            back = BACK if phase.side in (None, self.spec.placement.side or "right") else "self.heading"
        self.lines.append(f"do Walk({back}, {own}, to_far_side(self, line, {back})){until}")

    def _stands(self, phase: Phase, then: Phase | None, until: str) -> None:
        if phase.action == "yield" and not until:
            other = scope.reference(self.structure, phase.target) if phase.target else "ego"
            until = f" until passed({other}, self, 0)"
        lasts = until or ("" if then is None else _stands_until(self.structure, self.cid, then))
        self.lines.append(f"do Stand(){lasts}")


def _stands_until(structure: Structure, cid: str, then: Phase) -> str:
    """How long one stands before what comes next: 2 s, or until ego, which answers to that, has slowed down before."""
    ego = getattr(structure.ego.spec, "phases", ())
    for before, phase in zip(ego, ego[1:], strict=False):
        t = phase.trigger
        if t and (t.kind, t.of, t.action) == ("action", cid, then.action) and before.action == "brake" and before.speed:
            return f" until ego.speed < {scope.number(round(middle(before.speed) + SLOWED, 1))}"
    return " for 2 seconds"


def _delay(t: Trigger) -> Quantity | None:
    """How long after what it waits for somebody on foot does something (s): what it sees takes it by surprise."""
    return t.delay if t.delay is not None or t.kind != "seen" else STARTLED


def _by_egos_way(phase: Phase) -> bool:
    """Whether what somebody does, or when, is told by ego's way."""
    return phase.action in {*ACROSS, "leave_road"} or phase.trigger is not None and phase.trigger.kind == "ttc"


def rider(structure: Structure, cid: str, plan: Plan) -> list[str]:
    """The behaviour of a cyclist that crosses the road from beside it."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    i = next(i for i, p in enumerate(spec.phases) if p.action in ACROSS)
    then = spec.phases[i + 1] if i + 1 < len(spec.phases) else None
    own = f"{scope.constant(structure, cid)}_SPEED"
    drive = f"Drive(straight_on(self, far), {own}, rate={RIDER_GAINS})"
    stops = then is not None and then.action in ON_LANE
    due = sets_out(structure, cid, spec, spec.phases[i], plan, own, RIDER_GAINS)
    return [
        f"line = {_egos_way(plan)}",
        f"do Stop(straight_on(self)) until {due}",
        f"far = to_far_side(self, line, self.heading) + {RUN_OUT}",
        f"do {drive} until along_line(line, self.position)[1] < 1.5" if stops else f"do {drive}",
        *(["do Stop(straight_on(self))"] if stops else []),
    ]


def _egos_way(plan: Plan) -> str:
    """The way on which somebody meets ego."""
    return way_of_ego(plan) if plan.turning else f"route({LANE_NAME[0]})"


def _how_far(structure: Structure, cid: str, phase: Phase, then: Phase | None, heading: str) -> str:
    """To the other side of the road, or as far as what comes next asks; who comes onto it is in ego's way then."""
    if phase.abandoned:
        return f"to_kerb(self, {heading}, {scope.number(middle(phase.clearance or SHORT_OF_KERB))})"
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    remains = then is None and phase.action == "enter_road" and ego_reacts(structure, spec)
    returns = then is not None and then.action in ("leave_road", "reverse")
    if remains or returns or then is not None and stays_there((then,)):
        corner = {"front_left": 1, "front_right": -1}.get(egos_part(structure, cid, spec) or "", 0)
        further = corner * (-1 if spec.placement.side == "left" else 1) * AT_CORNER
        return "along_line(line, self.position)[1]" + (f" {'+' if further > 0 else '-'} {AT_CORNER}" if corner else "")
    if then is not None and then.trigger is None and then.action == "yield":
        return f"along_line(line, self.position)[1] - {SHORT_OF_LANE}"
    return f"to_far_side(self, line, {heading})"


def _come_out(structure: Structure, spec: ObjectSpec, t: Trigger, plan: Plan) -> Trigger:
    """The trigger of somebody hidden: it is as it comes out that ego is so far away, which it does some steps later."""
    hider = structure[spec.placement.hidden_by].spec if spec.placement.hidden_by else None
    if t.kind != "distance" or t.of not in (None, "ego") or t.value is None or not isinstance(hider, ObjectSpec):
        return t
    sooner = plan.ego_top * inside(hider) / max(middle(pace_of(spec)), 0.5)
    return t.model_copy(update={"value": (round(low(t.value) + sooner, 1), round(high(t.value) + sooner, 1))})


def _as_it_comes_out(structure: Structure, spec: ObjectSpec, phase: Phase, plan: Plan) -> str:
    """A comment that says why somebody hidden sets out sooner than at the distance that S says; "": it does not."""
    t = phase.trigger
    if t is None or t.value is None or not tells_when(t) or _come_out(structure, spec, t, plan) == t:
        return ""
    return f"  # {scope.number(middle(t.value))} m away as it comes out from behind what hides it"


def sets_out(
    structure: Structure, cid: str, spec: ObjectSpec, phase: Phase, plan: Plan, speed: str, rate: float = 0
) -> str:
    """When somebody goes over to a phase: the stated trigger, or so that ego meets it on its way."""
    t = phase.trigger
    if t and t.kind == "ttc" and t.value is not None and not watches(t):  # of who stands until then
        other, value = scope.reference(structure, t.of or "ego"), scope.number(middle(t.value))
        if other != "ego":
            return f"gap(self, {other}) < {value} * max({other}.speed, 3)"
        return f"seconds_to(ego, line, along_line(line, self.position)[0]) < {value}"
    if t and tells_when(t):
        return watched(structure, plan, _come_out(structure, spec, t, plan), cid)
    if ego_stays(structure, plan):
        return "clock() >= 2"
    gained = f", {scope.number(rate)}" if rate else ""
    when = "RETURNS" if phase is comes_again(structure, cid, spec) else "ARRIVES"
    if phase.abandoned:
        gained += f", metres={_how_far(structure, cid, phase, None, 'self.heading')}"
    whom = scope.reference(structure, crossed_vehicle(structure, cid))
    found = f"sets_out(self, {whom}, line, {speed}, {scope.constant(structure, cid)}_{when}{gained})"
    return f"{found} or {scope.reference(structure, cid)}.speed > 0.3" if spec.count > 1 else found
