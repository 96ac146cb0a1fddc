"""Who crosses ego's way from beside the road, on foot or riding: when they set out, how far they go."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.meetings import way_of_ego
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import LANE_NAME, is_walker
from c2s_engine.write.typed.threats import is_hit
from c2s_engine.write.typed.usual import crosses, pace_of, walks_first

ACROSS = {"cross_road", "enter_road", "collide"}
ON_LANE = {"stop", "stationary", "wait", "move_along"}
"""What somebody does on ego's lane who came onto it."""
IN_WAY = 1.5
"""m from the middle of ego's way, within which somebody is in it."""
CLEAR = (0.2, 0.6)
"""s by which somebody is out of ego's way before ego is there that does nothing about it."""
RIDER_GAINS = 1.5
"""m/s2"""
ANSWERS = {"brake", "stop", "wait", "yield", "swerve", "lane_change", "overtake"}
"""What ego does of its own accord for who is in its way."""
SHORT_OF_LANE = 2.5
"""m from the middle of ego's way to where those stand who let it pass."""
RUN_OUT = 14
"""m by which a rider's line goes on beyond the road: it slows down on the last of them."""


def constants(structure: Structure, cid: str, plan: Plan) -> list[str]:
    """`X_AHEAD`, where it is open when somebody sets out across ego's way."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    first = next((p for p in spec.phases if p.action in ACROSS), None)
    walks_into = is_walker(spec.type) and first is not None and first.action == "collide"
    if not (crosses(spec) or walks_into) or _ego_stays(structure, plan) or _stated(spec):
        return []
    most = min(0.5, IN_WAY / max(middle(pace_of(spec)), 0.5))  # who runs is soon out of it
    least = 0.0
    if not _ego_reacts(structure):  # they just miss each other
        least, most = (IN_WAY / max(middle(pace_of(spec)), 0.5) + margin for margin in CLEAR)
    ahead = "0" if _meets(structure, cid, spec) else f"Range({scope.number(least)}, {scope.number(most)})"
    return [f"{scope.constant(structure, cid)}_AHEAD = {ahead}  # s in the middle of ego's way before ego is there"]


def walker(structure: Structure, cid: str, plan: Plan) -> list[str]:
    """The behaviour of somebody on foot."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    phases = spec.phases or (Phase(action="stationary" if spec.speed == 0 else "move_along"),)
    across = f"self.heading {'-' if spec.placement.side == 'left' else '+'} 90 deg"
    heading = across if walks_first(spec) else "self.heading"
    usual = f"{scope.constant(structure, cid)}_SPEED"
    lines = [f"line = {_egos_way(plan)}"] if any(p.action in ACROSS for p in phases) else []
    begun = False
    for i, phase in enumerate(phases):
        then = phases[i + 1] if i + 1 < len(phases) else None
        own = scope.quantity(phase.speed) if phase.speed is not None and i > 0 else usual
        until = f" for {scope.quantity(phase.duration)} seconds" if phase.duration is not None else ""
        if then is not None and (then.trigger and not until or _crosses_next(then) and not begun):
            until = f" until {_sets_out(structure, cid, spec, then, plan, own)}"
        if phase.action in ACROSS:
            if i == 0:
                lines.append(f"do Stand() until {_sets_out(structure, cid, spec, phase, plan, own)}")
            lines.append(f"do Walk({heading}, {own}, {_how_far(then, heading)}){until}")
            heading, begun = "self.heading", True
        elif phase.action in ("stop", "stationary", "wait", "yield"):
            if phase.action == "yield" and not until:
                other = scope.reference(structure, phase.target) if phase.target else "ego"
                until = f" until passed({other}, self, 0)"
            lines.append(f"do Stand(){until or ('' if then is None else ' for 2 seconds')}")
        else:
            lines.append(f"do Walk(self.heading, {own}){until or ('' if then is None else ' for 2 seconds')}")
    return lines


def _crosses_next(then: Phase) -> bool:
    """Whether what comes next is to set out so that ego is met: what comes before lasts until then."""
    return then.action in ACROSS and then.trigger is None


def rider(structure: Structure, cid: str, plan: Plan) -> list[str]:
    """The behaviour of a cyclist that crosses the road from beside it."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    i = next(i for i, p in enumerate(spec.phases) if p.action in ACROSS)
    then = spec.phases[i + 1] if i + 1 < len(spec.phases) else None
    own = f"{scope.constant(structure, cid)}_SPEED"
    drive = f"Drive(straight_on(self, far), {own}, rate={RIDER_GAINS})"
    stops = then is not None and then.action in ON_LANE
    due = _sets_out(structure, cid, spec, spec.phases[i], plan, own, RIDER_GAINS)
    return [
        f"line = {_egos_way(plan)}",
        f"do Drive(straight_on(self), 0) until {due}",
        f"far = to_far_side(self, line, self.heading) + {RUN_OUT}",
        f"do {drive} until along_line(line, self.position)[1] < 1.5" if stops else f"do {drive}",
        *(["do Drive(straight_on(self), 0)"] if stops else []),
    ]


def _egos_way(plan: Plan) -> str:
    """The way on which somebody meets ego."""
    return way_of_ego(plan) if plan.turning else f"way({LANE_NAME[0]})"


def _stated(spec: ObjectSpec) -> bool:
    """Whether S says when somebody sets out."""
    first = next((p for p in spec.phases if p.action in ACROSS), None)
    return first is not None and first.trigger is not None


def _ego_stays(structure: Structure, plan: Plan) -> bool:
    """Whether ego stands there all the time."""
    phases = getattr(structure.ego.spec, "phases", ())
    return plan.ego_speed <= 0 and all(p.action in ON_LANE | {"yield"} for p in phases)


def _ego_reacts(structure: Structure) -> bool:
    ego = structure.ego.spec
    return isinstance(ego, EgoSpec) and (ego.reaction != "none" or bool({p.action for p in ego.phases} & ANSWERS))


def _meets(structure: Structure, cid: str, spec: ObjectSpec) -> bool:
    """Whether ego is to hit it, or it ego."""
    ego = structure.ego.spec
    return isinstance(ego, EgoSpec) and is_hit(ego, cid) or any(p.action == "collide" for p in spec.phases)


def _how_far(then: Phase | None, heading: str) -> str:
    """To the other side of the road, or as far as what comes next asks."""
    if then is not None and then.trigger is None and then.action in ON_LANE:
        return "along_line(line, self.position)[1]"
    if then is not None and then.trigger is None and then.action == "yield":
        return f"along_line(line, self.position)[1] - {SHORT_OF_LANE}"
    return f"to_far_side(self, line, {heading})"


def _sets_out(
    structure: Structure, cid: str, spec: ObjectSpec, phase: Phase, plan: Plan, speed: str, rate: float = 0
) -> str:
    """When somebody goes over to a phase: the stated trigger, or so that ego meets it on its way."""
    t = phase.trigger
    other = scope.reference(structure, t.of) if t and t.of else "ego"
    value = scope.number(middle(t.value)) if t and t.value is not None else ""
    if t and t.kind == "time":
        return f"simulation().currentTime * simulation().timestep >= {value or 2}"
    if t and t.kind == "ttc" and value and other == "ego":
        return f"seconds_to(ego, line, along_line(line, self.position)[0]) < {value}"
    if t and t.kind == "distance" and value:
        return f"gap(self, {other}) < {value}"
    if t and t.kind == "ttc" and value:
        return f"gap(self, {other}) < {value} * max({other}.speed, 3)"
    if t and t.kind == "action":
        return f"{other}.speed < 0.5" if t.action in ("stop", "stationary") else f"(distance from self to {other}) < 25"
    if _ego_stays(structure, plan):
        return "simulation().currentTime * simulation().timestep >= 2"
    gained = f", {scope.number(rate)}" if rate else ""
    found = f"sets_out(self, ego, line, {speed}, {scope.constant(structure, cid)}_AHEAD{gained})"
    return f"{found} or {scope.reference(structure, cid)}.speed > 0.3" if spec.count > 1 else found
