"""What a trigger watches, as a condition of the program: of any road user, whoever waits for it."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import called
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec, Trigger
from c2s_engine.structure.triggers import is_watched, other_of
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import APPROACH_ANGLE, APPROACH_NAME, LANE_NAME
from c2s_engine.write.typed.threats import observed, once_seen

METRES, SECONDS, SPEED = 25.0, 3.0, 5.0
"""m, s, m/s where no value is given."""
USUAL = {"time": SECONDS, "ttc": SECONDS, "distance": METRES, "apart": METRES, "speed": SPEED}
"""The value of a kind of trigger that is given none."""
ONTO_ROAD = ("cross_road", "enter_road")
"""What ego can answer only once it sees it."""
MIRROR = 50
"""m within which a driver sees who comes from behind."""
SAME = 0.45
"""m/s within which a speed is reached."""
FLASHES = {"flashing": "yellow", "dark": "off"}
"""What a light is set to that flashes, or is out of order."""


def watches(t: Trigger) -> bool:
    """Whether a trigger is of those that are worded here."""
    return is_watched(t) or t.place == "crosswalk"


def with_value(t: Trigger) -> Trigger:
    """The trigger with the value that it is watched by where S gives none; only a speed can be 0."""
    given = t.value is not None if t.kind == "speed" else bool(t.value)
    return t if given or t.kind not in USUAL else t.model_copy(update={"value": USUAL[t.kind]})


def watched(structure: Structure, plan: Plan, t: Trigger, own: str, name: str = "self") -> str:
    """The condition of a trigger. `own`: the component whose phase it is, which the code calls `name`."""
    subject = name if t.subject in (None, called(own)) else scope.reference(structure, str(t.subject))
    cid = called(own) if t.subject is None else t.subject
    first = structure.objects[0].id if structure.objects else "ego"
    other = _name(structure, other_of(t, called(own), first), own, name)
    value = middle(with_value(t).value or 0.0)
    match t.kind:
        case "time":
            return f"clock() >= {scope.number(value)}"
        case "ttc":
            return f"ttc({subject}, {other}) < {scope.number(value)}"
        case "distance":
            return f"gap({subject}, {other}) < {scope.number(value)}"
        case "apart":
            return f"gap({subject}, {other}) > {scope.number(value)}"
        case "passed":
            row = [subject, subject.replace("[0]", "[-1]")] if subject.endswith("[0]") else [subject]
            return " and ".join(f"passed({one}, {other}, 0)" for one in row)
        case "contact":
            return f"touch({subject}, {other})"
        case "speed":
            off = f"abs({subject}.speed - {scope.number(value)})"
            return f"clock() > 0.5 and {off} < {SAME}"
        case "light":
            state = FLASHES.get(t.light or "green", t.light or "green")
            return f"getClosestTrafficLightStatus({subject}) == '{state}'"
        case "seen":
            return _seen(structure, subject, other, (t.of, cid))
        case "action":
            comes_out = own == "E" and t.of and t.of in structure and t.action in ONTO_ROAD
            seen = once_seen(structure, [str(t.of)])[0] if comes_out else ""
            if seen.startswith("*in_view"):  # it comes out
                return seen[1:]
            shows = observed(structure, other, t.of or "ego", t.action)
            return f"{shows} and {seen[1:]}" if seen.startswith("*in_") else shows
        case _:
            return _there(structure, plan, t, subject, cid, value)


def _name(structure: Structure, cid: str, own: str, name: str) -> str:
    return name if cid == called(own) else scope.reference(structure, cid)


def _seen(structure: Structure, subject: str, other: str, cids: tuple[str | None, ...]) -> str:
    """That nothing is in the line of sight that S names as hiding one of the two; near enough where nothing does."""
    specs = [structure[cid].spec for cid in cids if cid and cid in structure]
    by = next((s.placement.hidden_by for s in specs if isinstance(s, ObjectSpec) and s.placement.hidden_by), None)
    if by is None and any(isinstance(s, ObjectSpec) and s.placement.position == "behind" for s in specs):
        return f"gap({subject}, {other}) < {MIRROR}"  # Scenic's drivers see 45 degrees to either side
    if by is None:
        return f"({subject} can see {other})"
    return f"not hides({scope.reference(structure, by)}, {subject}.position, {other}.position)"


def _there(structure: Structure, plan: Plan, t: Trigger, subject: str, cid: str, value: float) -> str:
    """That somebody has come to a place."""
    if t.place == "in_intersection":
        return f"{subject}._intersection is not None"
    if t.place == "past_intersection":
        return f"has_crossed({subject})"
    if t.place == "merge_end":
        end = "place.acceleration_lane"
        return f"{subject}._lane is {end} and (distance from {subject} to {end}.centerline[-1]) < {value + METRES:g}"
    if t.place == "bend" or t.place == "crosswalk" and plan.place.kind == "crosswalk":
        before = f" - {scope.number(value)}" if value else ""
        return f"along(place.lane, {subject}.position) + {subject}.length / 2 > place.mark{before}"
    lane = _lane(structure, plan, cid)
    if lane is None:
        return f"clock() >= {SECONDS:g}"
    if t.place == "intersection":
        return f"(distance from {subject} to {lane}.centerline[-1]) < {scope.number(value)} + {subject}.length / 2"
    return f"to_line({subject}, {lane}) < {scope.number(value + 0.3)}"


def _lane(structure: Structure, plan: Plan, cid: str) -> str | None:
    """The lane by which somebody comes to the junction."""
    spec = structure[cid].spec if cid != "ego" and cid in structure else None
    if isinstance(spec, ObjectSpec) and spec.placement.position in APPROACH_ANGLE:
        return APPROACH_NAME[spec.placement.position]
    if not plan.junction:
        return None
    return LANE_NAME.get(0 if cid == "ego" else plan.lane_of.get(cid) or 0)
