"""Who meets ego at a junction: where one starts, or when one sets out, so that both are there together as they drive.

All of it is solved when a scene is sampled, by `start_to_meet` and `setting_out_to_meet` of the driving library; nobody
is steered in the run.
"""

from dataclasses import dataclass

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import high, middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import LENGTH, WIDTH, is_static
from c2s_engine.write.typed.threats import hits_ego, is_hit
from c2s_engine.write.typed.usual import SETS_OUT, speed_of

TOGETHER = (-0.3, 0.3)
"""s between them at the spot where their ways cross, if neither reacts: they would collide."""
CONTACT = (-0.15, 0.15)
"""s, the same where they do collide: the one that is struck is struck in its side."""
INTO_TURN = 3.0
"""m by which ego is past the spot when it is struck in its turn: its front gets there long before."""
APART = 1.5
"""s between one leaving where their ways meet and the other's coming, where S says no conflict."""
STAYS = {"yield", "stop", "wait", "stationary"}
"""What one does that lets the moment at which it comes to the junction matter little."""


@dataclass(frozen=True)
class Meeting:
    """`ahead`: s by which it is there before ego; `clear`: s between them, over 0 where it goes first (None: they
    meet); `front`, `ego_front`: m by which the middle of the one that strikes is short of the other's path."""

    ahead: tuple[float, float] = TOGETHER
    clear: float | None = None
    front: float = 0.0
    ego_front: float = 0.0


def meeting(structure: Structure, cid: str, plan: Plan) -> Meeting | None:
    """How an object on an approach meets ego; None: S leaves open when it comes, or says where it starts."""
    spec, ego = structure[cid].spec, structure.ego.spec
    assert isinstance(spec, ObjectSpec) and isinstance(ego, EgoSpec)
    timed = plan.junction and plan.ego_speed > 0 and high(speed_of(spec, plan.place)) > 0
    if not timed or is_static(spec) or spec.placement.gap is not None or cid in plan.set_out or cid in plan.pocketed:
        return None
    if hits_ego(spec):
        across = plan.place.manoeuvre == "left" and spec.placement.position == "opposite_approach"
        past = -INTO_TURN if across else 0.0
        return Meeting(CONTACT, front=LENGTH[spec.type] / 2 + WIDTH[ego.type] / 2, ego_front=past)
    if is_hit(ego, cid):
        return Meeting(CONTACT, ego_front=LENGTH[ego.type] / 2 + WIDTH[spec.type] / 2)
    if STAYS & {p.action for p in spec.phases}:
        return None
    if ego.reaction in ("brake", "yield") or {"yield", "brake", "stop"} & {p.action for p in ego.phases}:
        return Meeting()
    return Meeting(clear=APART if plan.place.manoeuvre == "straight" else -APART)


def start(structure: Structure, cid: str, plan: Plan, lane: str, line: str) -> list[str] | None:
    """The constants that place somebody on an approach, the last of them the m from its start to the junction."""
    found, prefix = meeting(structure, cid, plan), scope.constant(structure, cid)
    if found is None:
        return None
    if found.clear is None:
        name = f"{prefix}_AHEAD"
        first = f"{name} = {scope.quantity(found.ahead)}  # s before ego where their ways cross, if neither reacts"
        how = f"ahead={name}"
    else:
        name = f"{prefix}_CLEAR"
        who = "it goes first" if found.clear > 0 else "ego goes first"
        first = f"{name} = {scope.number(found.clear)}  # s between them where their ways meet: {who}"
        how = f"clear={name}"
    solved = f"{prefix}_TO_JUNCTION = start_to_meet("
    ego = f"{way_of_ego(plan)}, EGO_AT, EGO_SPEED"
    return [first, solved, f"    {lane}, {line}, {prefix}_SPEED,", f"    {ego}, {how}{_fronts(found)})  # m"]


def sets_out(structure: Structure, cid: str, plan: Plan, lane: str, line: str) -> list[str]:
    """The constant that says how far ego is from the junction when one that stands at its line sets out."""
    spec, ego, prefix = structure[cid].spec, structure.ego.spec, scope.constant(structure, cid)
    assert isinstance(spec, ObjectSpec) and isinstance(ego, EgoSpec)
    own = middle(speed_of(spec, plan.place))
    speed = f"{prefix}_SPEED" if own > 0 else scope.number(SETS_OUT)
    strikes = Meeting(front=LENGTH[spec.type] / 2 + WIDTH[ego.type] / 2)
    struck = Meeting(ego_front=LENGTH[ego.type] / 2 + WIDTH[spec.type] / 2)
    fronts = _fronts(strikes if hits_ego(spec) else struck)
    return [
        f"{prefix}_SETS_OUT = setting_out_to_meet(",
        f"    {lane}, {line}, {scope.number(1 + LENGTH[spec.type] / 2)}, {speed},",
        f"    place.lane, {way_of_ego(plan)}, EGO_SPEED{fronts})  # m from ego to the junction",
    ]


def _fronts(found: Meeting) -> str:
    own = f", front={scope.number(found.front)}" if found.front else ""
    return own + (f", other_front={scope.number(found.ego_front)}" if found.ego_front else "")


BEARING = {"left": "90 deg", "right": "-90 deg", "u_turn": "180 deg"}
"""Where ego leaves a roundabout, to the left of where it came from."""


def way_of_ego(plan: Plan) -> str:
    """Ego's way, in the program."""
    if not plan.turning:
        return "way(place.lane)"
    bearing = BEARING.get(plan.place.manoeuvre or "") if plan.place.kind == "roundabout" else None
    return f"way(place.lane, place.turn, {bearing})" if bearing else "way(place.lane, place.turn)"
