"""Who meets ego at a junction: where one starts, or when one sets out, so that both are there together as they drive.

All of it is solved when a scene is sampled, by `start_to_meet` and `setting_out_to_meet` of the driving library; nobody
is steered in the run.
"""

from dataclasses import dataclass
from itertools import takewhile

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import high, low, middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Trigger
from c2s_engine.write.typed import pockets, scope
from c2s_engine.write.typed.alongside import offset
from c2s_engine.write.typed.answers import reacting_phases
from c2s_engine.write.typed.at_junction import phases_of
from c2s_engine.write.typed.course import Actor
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.reactions import late_rate
from c2s_engine.write.typed.tables import BEARING, LENGTH, TURN, WIDTH, is_static
from c2s_engine.write.typed.threats import hits_ego, is_hit, threatening
from c2s_engine.write.typed.towards import stops_in_way
from c2s_engine.write.typed.usual import SETS_OUT, speed_of, turn_of

TOGETHER = (-0.3, 0.3)
"""s between them at the spot where their ways cross, if neither reacts: they would collide."""
WAITED_FOR = (0.7, 1.3)
"""s by which one is there before ego, which has stopped for it and would set out."""
WAITED_FOR_INSIDE = (-2.8, -2.2)
"""s, the same of one for whom ego stops in the junction: by then it stands there, which it does not on its way."""
STANDS_BEFORE, EASES = (0.3, 0.8), 2.5
"""s by which one that ego hits stands in its way before that, and m/s2 with which it comes to a stand, as
`short_of_ways` has it."""
COMES_IN_WAY = (1.5, 2.0)
"""s by which one would be there before ego that stops in its way, still on the move as ego has to do something."""
CONTACT = (-0.05, 0.05)
"""s, the same where they do collide, by the parts that touch."""
NARROWLY = 0.7
"""s, the same where S says that neither reacts, and no contact."""
DRAG = 1.0
"""m/s2 at which the air and the wheels slow who brakes, besides."""
STAYS = {"yield", "stop", "wait", "stationary"}
"""What one does that lets the moment at which it comes to the junction matter little."""
STANDS_FOR = {"stop": 1.0, "wait": 3.0, "stationary": 3.0}
"""s for which one stands where nothing says how long."""


@dataclass(frozen=True)
class Meeting:
    """`ahead`: s by which it is there before ego; `clear`: s between them, over 0 where it goes first (None: they
    meet); `parts`: those of it and of ego that touch (None: their middles are there together)."""

    ahead: tuple[float, float] = TOGETHER
    clear: float | None = None
    parts: tuple[str, str] | None = None


def meeting(structure: Structure, cid: str, plan: Plan) -> Meeting | None:
    """How an object meets ego where their ways cross; None: S leaves open when it comes, or says where it starts."""
    spec, ego = structure[cid].spec, structure.ego.spec
    assert isinstance(spec, ObjectSpec) and isinstance(ego, EgoSpec)
    if not plan.junction or high(speed_of(spec, plan.place)) <= 0 or is_static(spec):
        return None
    if spec.placement.gap is not None or cid in plan.set_out or cid in plan.pocketed:
        return None
    arrives, later = spec.placement.arrives, middle(spec.placement.later or 0.0)
    if any(map(stops_in_way, spec.phases)) and not hits_ego(spec):
        slows = middle(speed_of(spec, plan.place)) / (2 * EASES)
        stands = slows + STANDS_BEFORE[0], slows + STANDS_BEFORE[1]
        return Meeting(_earlier(stands if is_hit(ego, cid) else COMES_IN_WAY, later))
    if hits_ego(spec) or is_hit(ego, cid):
        return Meeting(_earlier(CONTACT, later), parts=contact(structure, cid))
    aside = offset(spec, ego, plan.place)
    own = "side" if turn_of(spec.phases) == "STRAIGHT" else f"rear_{'right' if aside > 0 else 'left'}"
    beside = (_part(own, spec), _part("front", ego)) if aside else None
    if arrives is not None or beside:
        ahead = (0.0 - high(arrives), 0.0 - low(arrives)) if arrives is not None else TOGETHER
        return Meeting(_earlier(ahead, later), parts=beside)
    if STAYS & {p.action for p in spec.phases}:
        return None
    if ego.reaction != "none" or {"yield", "brake", "stop"} & {p.action for p in ego.phases}:
        gives_way = ego.reaction == "yield" or any(p.action == "yield" for p in ego.phases)
        stops = gives_way and bool({"stop", "wait"} & {p.action for p in ego.phases})
        places = [p.trigger.place for p in ego.phases if p.action in STANDS_FOR and p.trigger]
        waited_for = WAITED_FOR_INSIDE if "in_intersection" in places else WAITED_FOR
        return Meeting(_earlier(waited_for if stops else TOGETHER, later))
    return Meeting(clear=(NARROWLY if plan.place.manoeuvre == "straight" else -NARROWLY) - later)


def _earlier(ahead: tuple[float, float], later: float) -> tuple[float, float]:
    return round(ahead[0] - later, 2), round(ahead[1] - later, 2)


def contact(structure: Structure, cid: str) -> tuple[str, str]:
    """The parts of an object and of ego that touch: as S says, else the front of the one that strikes and the other's
    side."""
    spec, ego = structure[cid].spec, structure.ego.spec
    assert isinstance(spec, ObjectSpec) and isinstance(ego, EgoSpec)
    by_it = hits_ego(spec)
    phases = [p for p in (spec if by_it else ego).phases if p.action == "collide"]
    phase = next(p for p in phases if p.target in (None, "ego", cid))
    parts = [phase.part or "front", phase.target_part or "side"]
    own, egos = parts if by_it else parts[::-1]
    return _part(own, spec), _part(egos, ego)


def _part(name: str, spec: EgoSpec | ObjectSpec) -> str:
    return f"Part('{name}', {LENGTH[spec.type]}, {WIDTH[spec.type]})"


def start(structure: Structure, cid: str, plan: Plan, lane: str, line: str, at: str = "") -> list[str] | None:
    """The constants that place somebody who meets ego, the last of them the m from its start to the junction, or `at`
    where it starts on ego's lane."""
    found, prefix, spec = meeting(structure, cid, plan), scope.constant(structure, cid), structure[cid].spec
    egos = _egos_way(structure, cid, plan)
    if found is None or egos is None:
        return None
    if found.clear is None:
        ends, after = (low(found.ahead), high(found.ahead)), high(found.ahead) < 0
        name = f"{prefix}_AFTER" if after else f"{prefix}_AHEAD"
        seconds = scope.quantity((-ends[1], -ends[0]) if after else ends)
        order = "after" if after else "before"
        first = f"{name} = {seconds}  # s {order} ego where their ways cross, if neither reacts"
        how = f"ahead={'-' * after}{name}{_parts(found.parts)}{_too_late(structure, cid)}"
    else:
        name = f"{prefix}_CLEAR"
        who = "it goes first" if found.clear > 0 else "ego goes first"
        first = f"{name} = {scope.number(found.clear)}  # s between them where their ways meet: {who}"
        how = f"clear={name}"
    solved = f"{at} = place.length - start_to_meet(" if at else f"{prefix}_TO_JUNCTION = start_to_meet("
    driver = Actor(cid, spec, structure, plan, "", None, "", middle(speed_of(spec, plan.place)), None if at else lane)  # type: ignore[arg-type]
    own = _slower(phases_of(driver), lane)
    slows = f",\n    slows={own}" if own else ""
    last = f"    {egos[0]}, {how}{egos[1]}{slows}{_moved(structure, cid, plan)})  # m"
    return [first, solved, f"    {lane}, {line}, {prefix}_SPEED,", last]


def sets_out(structure: Structure, cid: str, plan: Plan, lane: str, line: str) -> list[str]:
    """The constant that says how far ego is from the junction when one that stands at its line sets out."""
    spec, prefix = structure[cid].spec, scope.constant(structure, cid)
    assert isinstance(spec, ObjectSpec)
    own = middle(speed_of(spec, plan.place))
    speed = f"{prefix}_SPEED" if own > 0 else scope.number(SETS_OUT)
    touch = hits_ego(spec) or is_hit(structure.ego.spec, cid)  # type: ignore[arg-type]
    parts = _parts(contact(structure, cid)) + _too_late(structure, cid) if touch else ""
    later = round(middle(spec.placement.later or 0.0), 2)
    moved = f" {'-' if later > 0 else '+'} EGO_SPEED * {scope.number(abs(later))}" if later else ""
    return [
        f"{prefix}_SETS_OUT = setting_out_to_meet(",
        f"    {lane}, {line}, {scope.number(1 + LENGTH[spec.type] / 2)}, {speed},",
        f"    place.lane, {way_of_ego(plan)}, EGO_SPEED{parts}){moved}"
        "  # m from ego to the junction",
    ]


def _parts(parts: tuple[str, str] | None) -> str:
    """The parts that touch, as arguments."""
    return f",\n    strikes={parts[0]}, struck={parts[1]}" if parts else ""


def _moved(structure: Structure, cid: str, plan: Plan) -> str:
    """How far (m) to the left of its line one drives, as an argument."""
    spec, ego = structure[cid].spec, structure.ego.spec
    assert isinstance(spec, ObjectSpec) and isinstance(ego, EgoSpec)
    aside = offset(spec, ego, plan.place)
    moved = scope.number(aside) if aside else pockets.aside(structure, plan, cid)
    return f", moved={moved}" if moved else ""


def _too_late(structure: Structure, cid: str) -> str:
    """How ego brakes for whom it touches, as an argument."""
    spec, ego = structure[cid].spec, structure.ego.spec
    assert isinstance(spec, ObjectSpec) and isinstance(ego, EgoSpec)
    brakes = (hits_ego(spec) or is_hit(ego, cid)) and ego.reaction == "brake"
    return f", late={scope.number(late_rate(ego.hard) + DRAG)}" if brakes else ""


def _egos_way(structure: Structure, cid: str, plan: Plan) -> tuple[str, str] | None:
    """How ego drives to where its way and that of an object cross, as arguments: its way, start and speed, then where
    it stands or is slower on it; None where that is not known before the run."""
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    own = ego.model_copy(update={"phases": reacting_phases(ego, threatening(structure), structure, plan)})
    phases = phases_of(Actor("E", own, structure, plan, "", 0, "EGO_SPEED", plan.ego_speed))
    speed, more = "EGO_SPEED", ""
    before = list(takewhile(lambda p: _up_to_it(p) and not _for_it(p, ego, cid), phases))  # what it does on its way
    standing = next((i for i, p in enumerate(before) if p.action in STANDS_FOR), len(phases))
    if standing < len(phases) and not (standing and plan.ego_speed <= 0):
        held = _stands_for(phases[standing:], structure if plan.ego_speed <= 0 else None)
        if held is None:
            return None
        at_line = f"stop_line(place.lane) - {scope.number(1 + LENGTH[ego.type] / 2)}"
        more = f", stop={at_line if plan.ego_speed > 0 else 'EGO_AT'}, held={scope.number(held)}"
    elif plan.ego_speed > 0 and (slower := _slower(phases)):
        more = f", slow={slower}"
    if plan.ego_speed <= 0:
        speed = scope.number(next((middle(p.speed) for p in phases if p.speed), SETS_OUT))
    return f"{way_of_ego(plan)}, EGO_AT, {speed}", more


def _up_to_it(phase: Phase) -> bool:
    """Whether one does that before it is in the junction, or touches anybody."""
    t = phase.trigger
    return phase.action not in TURN and not (t and (t.kind == "contact" or t.place == "in_intersection"))


def _for_it(phase: Phase, ego: EgoSpec, cid: str) -> bool:
    """Whether ego stops there for an object as that comes: unhindered it would drive on."""
    whom = phase.target or (ego.react_to if ego.reaction == "brake" else None)
    return phase.action == "stop" and phase.trigger is None and whom == cid


def _stands_for(phases: list[Phase], structure: Structure | None) -> float | None:
    """How long one stands (s) that begins so until it would go on, or lets another pass; None where that is not known
    before the run. With the structure of one that stands from the first: until the moment that S says."""
    held = 0.0
    for phase in phases:
        gives_way = phase.action == "yield" or any(t and t.kind == "passed" for t in (phase.trigger, phase.until))
        if gives_way or phase.action not in STANDS_FOR:
            if gives_way or phase.trigger is None:
                return held
            return _moment(structure, phase.trigger) if structure else None
        held += middle(phase.duration) if phase.duration is not None else STANDS_FOR[phase.action]
    return None


def _moment(structure: Structure, t: Trigger) -> float | None:
    """When (s) something comes about of which S says the time, as of a light that changes then; None: it says none."""
    if t.kind == "light":
        changes = getattr(structure.settings.spec, "light_changes", ())
        return next((_moment(structure, c.when) for c in changes if c.to == t.light), None)
    return middle(t.value) + middle(t.delay or 0.0) if t.kind == "time" and t.value is not None else None


def _slower(phases: list[Phase], lane: str = "place.lane") -> str:
    """From where one on its lane is slower before the junction, and how fast, where it says so; "": nowhere."""
    phase = next((p for p in phases if p.action == "brake" and p.speed is not None), None)
    if phase is None or phase.speed is None or phase.trigger is None or phase.trigger.kind != "place":
        return ""
    before, goal = middle(phase.trigger.value or 0) + 4, middle(phase.speed or 0)
    end = "place.length" if lane == "place.lane" else f"{lane}.centerline.length"
    return f"({end} - {scope.number(before)}, {scope.number(goal)})"



def way_of_ego(plan: Plan) -> str:
    """Ego's way, in the program."""
    if not plan.turning:
        return "route(place.lane)"
    bearing = BEARING.get(plan.place.manoeuvre or "") if plan.place.kind == "roundabout" else None
    return f"route(place.lane, place.turn, {bearing})" if bearing else "route(place.lane, place.turn)"
