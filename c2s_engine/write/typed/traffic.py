"""Those who drive in one direction: how fast, and where they start, in closed form, so that the gap between two of them
is what S says (or what is usual) at its moment: as one comes over the lane line, as it begins to brake, all along.
Everybody keeps its speed until then; nothing is steered for it in the run. Lengths in m, times in s, speeds in m/s.
"""

from dataclasses import dataclass
from itertools import takewhile

from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import called
from c2s_engine.structure.quantity import high, low, middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed.ahead import (
    LEAST,
    TIGHT,
    begins,
    clear_ahead,
    comes_first,
    gone_round,
    joined,
    let_by,
    level_then,
    phases_of,
    revealing,
    with_phase,
)
from c2s_engine.write.typed.contradictions import ResolveError
from c2s_engine.write.typed.lateral import LATERAL, to_line
from c2s_engine.write.typed.tables import DEFAULT_SPEED, LENGTH, is_static, is_vehicle
from c2s_engine.write.typed.threats import stops_ego
from c2s_engine.write.typed.usual import default_gap, speed_of, stopping

ALIKE = 0.4
"""m by which two gaps are the same."""
FORCED, LATE = 4.5, 5.0
"""m/s2 with which ego comes to a stand that somebody forces to it, and with which one brakes then that looks up too
late."""
AFTER_IT, STILL = 0.6, 1 / 3
"""s after ego stands by which that one reaches it, and how fast it still is, of its own speed."""
FURTHEST_BEHIND = 150.0
"""m"""
LATEST = 12.0
"""s after the start by which two have come as near as is said."""
SLOWER, FASTER = 0.8, 1.15
"""Of the other's speed, where nothing says how fast one cuts in from ahead, from behind or beside."""
SLOWED = 0.7
"""Of ego's speed, down to which one brakes that cut in, where ego has to brake and nothing else makes it."""
CALM = {"keep_lane", "follow", "move_along"}
LANES = {"ahead", "behind", "beside", "left_lane", "right_lane"}
SLOWS_BY = 2.0
"""m/s by which one brakes at least that does so to a speed, and whose own nothing says."""
LIGHT = ("car", "pickup", "van", "motorcycle", "police_car")
PLAIN = {*CALM, *LATERAL, "brake", "stop", "swerve", "drift", "reverse", "lose_control", "leave_road", "turn_left",
         "turn_right"}  # fmt: skip
"""What one that drives along as the others do may do then."""


def solved(structure: Structure) -> Structure:
    """S with the speeds, gaps and starts that are open and follow from those that are said; raises ResolveError where
    they do not go together."""
    structure = joined(gone_round(comes_first(let_by(level_then(clear_ahead(_late_behind(_at_pace(structure))))))))
    for cid in ("E", *(c.id for c in structure.objects)):
        for i, phase in enumerate(phases_of(structure, cid)):
            if any(p.action not in CALM for p in phases_of(structure, cid)[:i]):
                break
            if phase.action == "overtake" and [p.action for p in phases_of(structure, cid)[i + 1 :]] == ["cut_in"]:
                structure = _braking(structure, cid, i + 1, FASTER)  # it comes by, and draws away
            if phase.action in (*LATERAL, "swerve", "brake", "stop", "follow"):
                structure = _with_phase_gap(structure, cid, i, phase)
                break
    return structure


# How fast.


def _at_pace(structure: Structure) -> Structure:
    """Those who drive plainly on ego's road, nobody says how fast, as fast as the one they are placed by; ego as
    fast as the one beside it or that it follows."""
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    if (ego.speed is None or ego.pace is not None) and (pace := _pace_for_ego(structure, ego)) is not None:
        structure = structure.with_spec("E", speed=pace)
    for component in structure.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        of_ego = spec.placement.of == "ego"
        by = structure.ego.spec if of_ego else structure[spec.placement.of].spec
        speed = getattr(by, "speed", None)
        if speed is None and isinstance(by, ObjectSpec) and spec.placement.position == "behind" and _drives(by):
            speed = speed_of(by, structure.place.spec)  # type: ignore[arg-type]
        if not (_open_pace(spec) or _runs_up(spec, ego)) or speed is None or middle(speed) <= 0:
            continue
        behind_another = of_ego and [p.action for p in ego.phases[:1]] == ["follow"]
        if spec.placement.position == "oncoming_lane" and (getattr(by, "pace", None) or behind_another):
            continue  # a word, or whom ego follows, says how one drives, and not how all do
        followed = any(p.action == "follow" and p.target == component.id for p in ego.phases)
        calm = {p.action for p in spec.phases} <= CALM and not followed
        first = spec.placement.position == "ahead" and spec.placement.of == "ego"
        if first and spec.type not in LIGHT and calm:
            continue  # caught up with
        structure = structure.with_spec(component.id, speed=_pace(spec, middle(speed)))
    return structure


def _late_behind(structure: Structure) -> Structure:
    """Those behind ego that look up too late and hit it once it stands, nobody says from how far: so far off that they
    still have a part of their speed then."""
    ego, place = structure.ego.spec, structure.place.spec
    assert isinstance(ego, EgoSpec) and isinstance(place, PlaceSpec)
    own, stop = middle(speed_of(ego, place)), next((p for p in ego.phases if p.action == "stop"), None)
    forced = ego.reaction in ("brake", "yield") and stops_ego(structure)
    if own <= 0 or stop is None and not forced:
        return structure
    rate = FORCED if stop is None or forced and stop.rate is None else stopping(ego, stop)
    begun = max(begins(structure, cid) for cid in ("E", *(c.id for c in structure.objects if forced)))
    stands, metres = begun + own / rate, own * begun + own**2 / (2 * rate)
    for component in structure.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        at, speed = spec.placement, middle(speed_of(spec, place))
        only_hits = [(p.action, p.target or "ego", p.speed) for p in spec.phases] == [("collide", "ego", None)]
        if (at.position, at.of, at.gap) != ("behind", "ego", None) or not only_hits or not _drives(spec):
            continue
        brakes = (1 - STILL) * speed / LATE
        gap = speed * (stands + AFTER_IT - brakes) + (1 + STILL) / 2 * speed * brakes - metres
        gap = round(min(max(gap, default_gap(spec, own, place)), FURTHEST_BEHIND), 1)
        structure = structure.with_spec(component.id, placement=at.model_copy(update={"gap": gap}))
    return structure


def _pace_for_ego(structure: Structure, ego: EgoSpec) -> float | None:
    if any(p.action == "accelerate" for p in ego.phases[:1]):  # it comes to its speed
        return None
    at_first = takewhile(lambda p: p.action in CALM and (p.trigger is None or p is ego.phases[0]), ego.phases)
    followed = {p.target for p in at_first if p.action == "follow"}
    if ego.pace is not None:  # drawn as that one's speed is, it would now and then fall behind whom it follows
        drawn = [c.spec.speed for c in structure.objects if c.id in followed and isinstance(c.spec, ObjectSpec)]
        return high(drawn[0]) if drawn and drawn[0] is not None and ego.phases[0].action == "follow" else None
    for component in structure.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        level = spec.placement.position == "beside" or spec.placement.along == "abreast"
        if component.id not in followed and not (level and spec.placement.of == "ego"):
            continue
        own, usual = (middle(speed_of(s, structure.place.spec)) for s in (ego, spec))  # type: ignore[arg-type]
        if level and {p.action for p in spec.phases} <= CALM and _open_pace(spec) and usual < own:  # it stays there
            return usual
        if is_vehicle(spec.type) and spec.speed is not None and middle(spec.speed) > 0 and spec.type != "bicycle":
            return middle(spec.speed)
    return None


def _open_pace(spec: ObjectSpec) -> bool:
    placed = spec.placement.position in {*LANES, "oncoming_lane"} and spec.placement.facing in (None, "along")
    others = {p.action for p in spec.phases if p.action != "collide" or p.target in (None, "ego")}
    follows = spec.phases[:1] and spec.phases[0].action == "follow" and spec.phases[0].trigger is None
    plain = (follows or others <= PLAIN) and all(p.speed is None or p.action == "brake" for p in spec.phases[:1])
    return placed and bool(plain) and is_vehicle(spec.type) and spec.type != "bicycle" and spec.speed is None


def _runs_up(spec: ObjectSpec, ego: EgoSpec) -> bool:
    """Whether one behind ego runs into it because ego slows down."""
    slows = ego.reaction in ("brake", "yield") or {"brake", "stop"} & {p.action for p in ego.phases}
    behind = (spec.placement.position, spec.placement.of) == ("behind", "ego")
    phases = tuple(p for p in spec.phases if p.action != "collide")
    stops = any(p.action == "stop" for p in ego.phases)  # then it still has that speed as it hits ego
    hits = len(phases) < len(spec.phases) and all(p.speed is None for p in (phases if stops else spec.phases))
    return bool(behind and hits and slows) and _open_pace(spec.model_copy(update={"phases": phases}))


def _pace(spec: ObjectSpec, of: float) -> float:
    """The speed of one that drives by another at `of`: who cuts in is slower from ahead, faster from behind."""
    actions, down = [p.action for p in spec.phases], [p.speed for p in spec.phases[:1] if p.speed is not None]
    if down and middle(down[0]) > of - SLOWS_BY:  # to which it brakes
        return round(middle(down[0]) + SLOWS_BY, 1)
    of = of if spec.type in LIGHT else min(of, DEFAULT_SPEED["truck"]["motorway"])
    if "cut_in" not in actions or spec.placement.gap is not None or any(p.speed is not None for p in spec.phases):
        return round(of, 2)
    from_ahead = _along(spec) == "ahead"
    if from_ahead and {"brake", "stop"} & set(actions[actions.index("cut_in") :]):
        return round(of, 2)
    return round(of * (SLOWER if from_ahead else FASTER), 1)


# Where, and when.


def _along(spec: ObjectSpec) -> str:
    at = spec.placement
    return at.along or {"behind": "behind", "beside": "abreast"}.get(at.position, "ahead")


@dataclass(frozen=True)
class _Pair:
    """An actor and whom its phase is about. `placed`: the one of the two whose placement says where it is to the other;
    `sign`: +1 where that is the actor."""

    actor: str
    other: str
    placed: str
    sign: int
    bodies: float  # half of both lengths
    gains: float  # m/s by which the actor comes further ahead of the other
    rear: float  # m/s of the one behind


def _pair(structure: Structure, cid: str, phase: Phase) -> _Pair | None:
    """The two whose gap a phase is about, if both drive in ego's direction and one is placed by the other."""
    own, other = structure[cid].spec, phase.target if phase.target not in (None, "ego") else "E"
    if other == cid or other is None or other not in structure:
        return None
    specs = own, structure[other].spec
    placed = [(a, b) for a, b in ((cid, other), (other, cid)) if a != "E" and _placed_by(structure, a, b)]
    place = structure.place.spec
    if not placed or any(isinstance(s, ObjectSpec) and not _drives(s) for s in specs):
        return None
    assert isinstance(place, PlaceSpec)
    one, two = (middle(speed_of(s, place)) for s in specs)  # type: ignore[arg-type]
    lengths = [LENGTH[s.type] for s in specs]  # type: ignore[union-attr]
    at, half = placed[0][0], sum(lengths) / 2
    return _Pair(cid, other, at, 1 if at == cid else -1, half, one - two, min(one, two) if one * two else max(one, two))


def _placed_by(structure: Structure, a: str, b: str) -> bool:
    at = structure[a].spec.placement  # type: ignore[union-attr]
    return at.position in LANES and at.of == called(b)


def _drives(spec: ObjectSpec) -> bool:
    along = spec.placement.facing in (None, "along") and spec.count == 1
    return along and is_vehicle(spec.type) and not is_static(spec)


def _with_phase_gap(structure: Structure, cid: str, i: int, phase: Phase) -> Structure:
    """S with what makes the gap of a phase hold at its moment."""
    if phase.action in ("cut_out", "lane_change", "swerve"):
        structure = revealing(structure, cid, i, phase)
    pair = _pair(structure, cid, phase)
    if pair is None and phase.action == "cut_in" and _from_ramp(structure, cid):
        one, ego = (middle(speed_of(structure[c].spec, structure.place.spec)) for c in (cid, "E"))  # type: ignore[arg-type]
        return _braking(structure, cid, i, one - ego)
    wanted = phase.gap is not None or phase.action == "cut_in"
    if pair is None or not wanted or _sideways_into(structure, cid, i):
        return structure
    at = structure[pair.placed].spec.placement  # type: ignore[union-attr]
    if phase.action == "follow" and (phase.trigger is not None or at.position not in ("ahead", "behind")):
        return structure  # it comes to that gap
    front = _in_front(structure, pair, phase)
    time = _time(structure, cid, phase)
    if phase.gap is None and phase.trigger is not None and phase.trigger.kind not in ("time", "action"):
        return structure  # it begins as that says
    if phase.gap is not None:
        gap = middle(phase.gap)
    elif at.gap is not None and abs(pair.gains) < 0.3:
        gap = middle(at.gap)
    else:
        gap = round(max(LEAST, TIGHT * pair.rear), 1)
    then = gap + pair.bodies if front else -gap - pair.bodies  # of the actor's middle ahead of the other's
    timed = with_phase(structure, cid, i, gap=phase.gap if phase.gap is not None else gap)
    try:
        structure = (_start if at.gap is None else _kept)(timed, pair, i, phase, then, time)
    except ResolveError:
        if phase.gap is not None:
            raise
        return _getting_by(structure, cid, pair)
    return _braking(structure, cid, i, pair.gains) if phase.action == "cut_in" else structure


def _from_ramp(structure: Structure, cid: str) -> bool:
    spec = structure[cid].spec
    return isinstance(spec, ObjectSpec) and spec.placement.position == "on_ramp"


def _getting_by(structure: Structure, cid: str, pair: _Pair) -> Structure:
    """One that is no faster than whom it cuts in front of, and not ahead of it, speeds up first."""
    faster = round(FASTER * middle(speed_of(structure[pair.other].spec, structure.place.spec)), 1)  # type: ignore[arg-type]
    return structure.with_spec(cid, phases=(Phase(action="accelerate", speed=faster), *phases_of(structure, cid)))


def _time(structure: Structure, cid: str, phase: Phase) -> float:
    """s after the start at which a phase has its moment."""
    trigger = phase.trigger
    first = begins(structure, cid)
    if trigger is not None and trigger.kind == "time" and trigger.value is not None:
        first = middle(trigger.value)
    delay = middle(trigger.delay) if trigger is not None and trigger.delay is not None else 0.0
    return first + delay + to_line(structure[cid].spec.type, phase)  # type: ignore[union-attr]


def in_front(structure: Structure, cid: str, phase: Phase) -> bool:
    """Whether an actor is ahead of whom a phase is about as it comes over the lane line."""
    pair = _pair(structure, cid, phase)
    return pair is None or _in_front(structure, pair, phase)


def _in_front(structure: Structure, pair: _Pair, phase: Phase) -> bool:
    """Whether the actor is ahead of the other at the moment."""
    if phase.action in ("cut_in", "cut_out"):
        return True
    if phase.action == "follow":
        return False
    along = _along(structure[pair.placed].spec)  # type: ignore[arg-type]
    if along == "abreast":
        return pair.gains >= 0
    return (along == "ahead") == (pair.sign > 0)


def _start(structure: Structure, pair: _Pair, i: int, phase: Phase, then: float, time: float) -> Structure:
    """With an open gap at the start: where both are at the moment, less what they gain on one another until then."""
    spec = structure[pair.placed].spec
    assert isinstance(spec, ObjectSpec)
    said, gains, half = spec.placement.along, pair.sign * pair.gains, pair.bodies
    then *= pair.sign  # of the placed one's middle ahead of the other's
    along = _along(spec)
    nearest = {"ahead": half + 1, "behind": -half - 1, "abreast": 0.0}[along]
    start = then - gains * time
    fits = {"ahead": start >= nearest, "behind": start <= nearest, "abreast": abs(start) < half / 2}[along]
    if not fits and abs(gains) > 0.3 and phase.trigger is None:
        later = (then - nearest) / gains
        soonest = to_line(structure[pair.actor].spec.type, phase) + 0.2  # type: ignore[union-attr]
        if soonest <= later <= LATEST:
            start, fits = nearest, True
        elif said is None and spec.placement.position in ("left_lane", "right_lane"):
            start, fits = (start if abs(start) > half else -half - 1), True
    if not fits:
        raise _apart(pair, phase, f"starts {along}")
    new = "ahead" if start > half else "behind" if start < -half else "abreast"
    gap = round(abs(start) - half, 1) if new != "abreast" else None
    changes: dict = {"gap": gap}
    if new != along or said is not None:
        changes["along"] = new if spec.placement.position not in ("ahead", "behind", "beside") else said
    return structure.with_spec(pair.placed, placement=spec.placement.model_copy(update=changes))


def _apart(pair: _Pair, phase: Phase, how: str) -> ResolveError:
    """Two who do not come to be as far from one another as is said."""
    who, other = map(called, (pair.actor, pair.other))
    gap = f"{middle(phase.gap):g} m" if phase.gap is not None else "close"
    ahead = "ahead of" if phase.action != "follow" else "behind"
    return ResolveError(
        f"{who} is never {gap} {ahead} {other} for its {phase.action.replace('_', ' ')}: it {how} and the two drive "
        "at these speeds. Change one of them: a speed, where it starts, or the gap",
        (f"{pair.actor}.speed", f"{pair.placed}.placement", f"{pair.actor}.phases"),
    )


def _kept(structure: Structure, pair: _Pair, i: int, phase: Phase, then: float, time: float) -> Structure:
    """With the gap at the start said: it must come to that of the moment, or that follows from it."""
    spec = structure[pair.placed].spec
    assert isinstance(spec, ObjectSpec) and spec.placement.gap is not None
    along = _along(spec)
    sign = {"ahead": 1, "behind": -1, "abreast": 0}[along]
    start = pair.sign * sign * (middle(spec.placement.gap) + pair.bodies)
    room = max(2.0, 0.15 * abs(then), (high(spec.placement.gap) - low(spec.placement.gap)) / 2)
    if phase.gap is not None and phase.action != "follow":
        off = then - start
        if abs(pair.gains) <= 0.3 and ALIKE < abs(off) <= room and time > off:  # within what "as fast" means
            own = middle(speed_of(structure[pair.actor].spec, structure.place.spec))  # type: ignore[arg-type]
            return structure.with_spec(pair.actor, speed=round(own + off / time, 2))
        if abs(off) <= room or abs(pair.gains) > 0.3 and 0.5 <= (then - start) / pair.gains <= LATEST:
            return structure
        if structure[pair.actor].spec.speed is None:  # type: ignore[union-attr]
            other = middle(speed_of(structure[pair.other].spec, structure.place.spec))  # type: ignore[arg-type]
            return structure.with_spec(pair.actor, speed=round(max(other + (then - start) / time, 1.0), 2))
        raise _apart(pair, phase, f"starts {middle(spec.placement.gap):g} m {along}")
    if phase.gap is None:
        gap = start + pair.gains * time - pair.bodies
        if abs(pair.gains) > 0.3 and gap > LEAST:
            return with_phase(structure, pair.actor, i, gap=round(gap, 1))
    return structure


def _braking(structure: Structure, cid: str, i: int, gains: float) -> Structure:
    """One that cuts in and draws away is no reason to brake: where ego is to, and nothing else makes it, it brakes."""
    ego, phases = structure.ego.spec, phases_of(structure, cid)
    assert isinstance(ego, EgoSpec)
    aimed = cid != "E" and phases[i].target in (None, "ego") and not phases[i].abandoned
    if not aimed or ego.reaction != "brake" or gains < -1 or len(phases) > i + 1:
        return structure
    if ego.react_to not in (None, cid) or any(p.action not in {*CALM, "brake", "stop"} for p in ego.phases):
        return structure
    slower = round(SLOWED * middle(speed_of(ego, structure.place.spec)), 1)  # type: ignore[arg-type]
    return structure.with_spec(cid, phases=(*phases, Phase(action="brake", speed=slower, rate=4.0)))


def _sideways_into(structure: Structure, cid: str, i: int) -> bool:
    """Whether one comes over to hit whom it comes to: there is no gap for which it waits."""
    return any(p.action == "collide" for p in phases_of(structure, cid)[i + 1 :])
