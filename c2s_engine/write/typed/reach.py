"""How far apart two start so that a trigger between them comes true at its value: neither at once nor never.

Lengths in m, times in s, speeds in m/s.
"""

from dataclasses import dataclass

from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import called, component_of
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec, Trigger
from c2s_engine.write.typed.lanes import oncoming
from c2s_engine.write.typed.stations import along
from c2s_engine.write.typed.tables import MOVES_OFF_ROAD, TIMED, is_static
from c2s_engine.write.typed.threats import beside_way
from c2s_engine.write.typed.usual import LONGEST_VIEW, default_gap, speed_of
from c2s_engine.write.typed.watching import METRES, SECONDS

BEFORE = 2.5
"""s for which everybody drives on before a trigger comes true."""
LASTS = 3.0
"""s that something takes which somebody does before: the search corrects what this is off by."""
OUT = 2.5
"""s that something has gone on for by when it is ended by that."""
CLOSE_BY = 0.8
"""m across the road between ego, were it to drive on, and whom it gets round who is beside its lane."""
EVADED_AT = 4.0
"""s before ego would be there at which it begins to do something about that."""
CALM = {"keep_lane", "move_along", "follow", "go_straight", "stationary", "wait"}
"""What goes on until a trigger comes true."""


@dataclass(frozen=True)
class _Pair:
    """Who waits in a phase (`E` or an object's id) for two to come so near (m, or s for `ttc`) to one another;
    `placed`: the one of the two whose open gap says how far apart they start; `seconds`: how long that takes."""

    actor: str
    placed: str
    phase: Phase
    kind: str
    near: float
    seconds: float


def reached(structure: Structure) -> Structure:
    """S with the gaps that are open and that a stated distance or time to collision follows from, and with those near
    enough to ego's way whom it gets round."""
    structure = _beside_the_way(structure)
    for actor in ("E", *(c.id for c in structure.objects)):
        pair = _pair(structure, actor)
        if pair is not None:
            spec = structure[pair.placed].spec
            assert isinstance(spec, ObjectSpec)
            changes = {"gap": round(_gap(structure, pair, spec), 1)}
            structure = structure.with_spec(pair.placed, placement=spec.placement.model_copy(update=changes))
    return structure


def _beside_the_way(structure: Structure) -> Structure:
    """S whose ego passes those close by, nobody says how close, who are at the roadside and whom it evades."""
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    evaded = {p.target for p in ego.phases if p.action == "swerve"}
    evaded.add(ego.react_to if ego.reaction == "evade" else None)
    for component in structure.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        at, place = spec.placement, structure.place.spec
        if component.id in evaded and beside_way(structure, component.id) and at.lateral is None:
            gap = round((EVADED_AT + BEFORE) * middle(speed_of(ego, place)), 1)  # type: ignore[arg-type]
            changes = {"lateral": CLOSE_BY, "gap": at.gap if at.gap is not None else gap}
            structure = structure.with_spec(component.id, placement=at.model_copy(update=changes))
    return structure


def _pair(structure: Structure, actor: str) -> _Pair | None:
    seconds = BEFORE
    for phase in getattr(structure[actor].spec, "phases", ()):
        for trigger, lasts in ((phase.trigger, 0.0), (phase.until, OUT)):
            near = _near(trigger, actor)
            if trigger is not None and near is not None:
                one = component_of(trigger.subject or actor)
                other = "E" if trigger.of == "ego" or trigger.of is None and one != "E" else trigger.of
                pairs = ((one, other), (other, one)) if other and other in structure and other != one else ()
                placed = next((a for a, b in pairs if a != "E" and _open_to(structure, str(a), str(b))), None)
                return _Pair(actor, placed, phase, trigger.kind, near, seconds + lasts) if placed else None
            if trigger is not None and trigger.kind == "time":
                seconds = max(middle(trigger.value or 0.0), seconds)
            elif trigger is not None:
                return None
        seconds += LASTS if phase.action not in CALM else middle(phase.duration) if phase.duration is not None else 0.0
    return None


def _near(trigger: Trigger | None, actor: str) -> float | None:
    """How near (m or s) one comes as a trigger comes true; of two others, nobody says how near, as is written."""
    if trigger is None or trigger.kind not in ("distance", "ttc"):
        return None
    others = trigger.subject is not None and component_of(trigger.subject) != actor
    usual = {"distance": METRES, "ttc": SECONDS}[trigger.kind] if others else None
    return middle(trigger.value) if trigger.value is not None else usual


def _open_to(structure: Structure, one: str, two: str) -> bool:
    """Whether it is open how far one starts from another by which it is placed."""
    at = structure[one].spec.placement  # type: ignore[union-attr]
    near = at.position in TIMED or at.position == "beside" or at.along == "abreast" or at.hidden_by is not None
    return at.of == called(two) and at.gap is None and not near


def _gap(structure: Structure, pair: _Pair, spec: ObjectSpec) -> float:
    place = structure.place.spec
    assert isinstance(place, PlaceSpec)
    closing = _closing(structure, pair.placed, spec, place)
    near = pair.near * max(closing, 0.0) if pair.kind == "ttc" else pair.near
    if closing <= 0.5 and _slows(structure, pair):  # it comes up then
        return default_gap(spec, middle(speed_of(structure.ego.spec, place)), place)  # type: ignore[arg-type]
    if closing <= 0.5 and pair.phase.action != "cut_in":  # it is as near from the start
        return max(near - 0.5, 1.0)
    gap = min(max(near + pair.seconds * closing, 1.0), max(LONGEST_VIEW, near))
    return max(gap, default_gap(spec, closing, place)) if _stands(pair, spec) else gap


def _closing(structure: Structure, placed: str, spec: ObjectSpec, place: PlaceSpec) -> float:
    """m/s by which one comes nearer to whom it is placed by, both driving on as they do at first."""
    by = structure.ego.spec if spec.placement.of == "ego" else structure[spec.placement.of].spec
    own, other = (0.0 if isinstance(s, ObjectSpec) and _waits(s) else middle(speed_of(s, place)) for s in (spec, by))  # type: ignore[arg-type]
    if oncoming(spec, {c.id: c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)}):
        return own + other
    return own - other if along(spec) < 0 else other - own


def _slows(structure: Structure, pair: _Pair) -> bool:
    """Whether the one whom a follower comes up to slows down before that."""
    phases: tuple[Phase, ...] = getattr(structure[pair.actor].spec, "phases", ())
    follows = bool(phases) and phases[0].action == "follow" and pair.kind == "distance"
    ahead = component_of(phases[0].target or "ego") if follows else ""
    doings = getattr(structure[ahead].spec, "phases", ()) if ahead in structure else ()
    return any(p.action in ("brake", "stop") for p in doings)


def _stands(pair: _Pair, spec: ObjectSpec) -> bool:
    return pair.placed == pair.actor and _waits(spec)


def _waits(spec: ObjectSpec) -> bool:
    """Whether one stands until something makes it act."""
    beside = spec.placement.position in MOVES_OFF_ROAD and bool(spec.phases) and spec.phases[0].trigger is not None
    return is_static(spec) or spec.speed == 0 or beside
