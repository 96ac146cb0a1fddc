"""What lies ahead of those who change lanes: what stands there, and where a ramp's lane ends. m, s, m/s."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import called
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec, Trigger
from c2s_engine.write.typed.contradictions import ResolveError
from c2s_engine.write.typed.lateral import LATERAL, said, shift_of, sideways, to_line
from c2s_engine.write.typed.tables import LANE_WIDTH, LENGTH, WIDTH, is_static
from c2s_engine.write.typed.usual import UNDISTURBED, default_gap, row_length, speed_of

ANSWERS, BRAKES = 1.0, 3.5
"""s after which, and m/s2 with which, one brakes for who comes over in front of it."""
SLOW = 0.4
"""Of the speed of one that gets out of its way at the last moment, that of one that is slow."""
LETS_BY = 5.0
"""s in which one lets another in the next lane by."""
FOLLOWED = 4.3
"""s for which one follows before the other does something, so that it plainly follows until the other is gone."""
MERGES = 30.0
"""m before the end of the acceleration lane by which one begins to change lanes."""
TO_RAMP_END = 6.0
"""s from the start until ego is on the acceleration lane: a guess, too."""
ACCELERATION_LANE = 250.0
"""m, a guess while the map is not known: on longer or shorter lanes those that are let by come too early or late."""
RAMP, CONNECTS = 4.0, 80.0
"""s of its way on the ramp, and m from there to the acceleration lane, on which ego is before it: a guess, too."""
GAINS = 2.5
"""m/s2 at which it speeds up."""
PULLS_OUT, WARNED = 0.5, 2.2
"""Of the speed of who goes round it, that of one that pulls out; s before it is there at which that is seen."""
SLOWS = 3.0
"""m/s2 at which ego does."""
SETTLES = 0.5
"""s after a change of lane by which one is in the other."""
BEHIND = 1.5
"""s behind another that one still is then."""
CLEAR = 0.6
"""s between being out of the lane and being where somebody stands in it."""
TIGHT = 0.8
"""s: the time gap at which one cuts in, so that whoever is behind has to do something about it."""
GETS_PAST = ("swerve", "overtake", "collide", "lane_change")
AHEAD = ("ahead", "partly_in_lane", "roadside", "parked")
"""Where something is that is ahead of ego where nothing else is said."""
LEAST = 6.0
"""m between the two then, at least."""


def phases_of(structure: Structure, cid: str) -> tuple[Phase, ...]:
    return getattr(structure[cid].spec, "phases", ())


def with_phase(structure: Structure, cid: str, i: int, **changes: object) -> Structure:
    phases = phases_of(structure, cid)
    found = (*phases[:i], phases[i].model_copy(update=changes), *phases[i + 1 :])
    return structure.with_spec(cid, phases=found)


def begins(structure: Structure, cid: str) -> float:
    """s for which everybody drives on before what one does, nobody says when."""
    followed = any(p.action == "follow" and p.target == cid for p in getattr(structure.ego.spec, "phases", ()))
    followed = followed or _leaves_who_follows(structure, cid)
    return max(FOLLOWED if followed else UNDISTURBED, awaited(structure, cid))


def _leaves_who_follows(structure: Structure, cid: str) -> bool:
    """Whether one whom another follows leaves its lane, first of all that it does."""
    first = next((p for p in phases_of(structure, cid) if p.action not in ("keep_lane", "follow", "move_along")), None)
    if first is None or first.action not in {*LATERAL, "leave_road"}:
        return False
    others = [c for c in structure.objects if c.id != cid]
    return any(p.action == "follow" and p.target == called(cid) for c in others for p in phases_of(structure, c.id)[:1])


def awaited(structure: Structure, cid: str) -> float:
    """s that one who waits for what another does takes for what it does itself before; 0: nobody does."""
    found = [0.0]
    for component in structure.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        for i, phase in enumerate(spec.phases):
            t = phase.trigger
            if i and t is not None and t.kind == "action" and (t.of or "ego") == called(cid):
                moves = [p for p in spec.phases[:i] if p.action in LATERAL]
                own = sum(sideways(LANE_WIDTH, shift_of(p)) + SETTLES for p in moves)
                found.append(UNDISTURBED + own if moves else 0.0)
    return round(max(found), 1)


def level_then(structure: Structure) -> Structure:
    """With those who come up behind in the next lane, nobody says from how far, by when the one by whom they are placed
    comes over into it, or does what they wait for: level with it; where they then brake, so far behind that this is
    hard, and yet enough."""
    place = structure.place.spec
    assert isinstance(place, PlaceSpec)
    for component in structure.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        at = spec.placement
        waits = next((p for p in spec.phases[1:] if p.trigger and p.trigger.of == at.of), None)
        of = "E" if at.of == "ego" else at.of
        beside = at.position in ("left_lane", "right_lane") and at.along == "behind"
        if not beside or at.gap is not None or waits is None:
            continue
        closing = middle(speed_of(spec, place)) - middle(speed_of(structure[of].spec, place))  # type: ignore[arg-type]
        seconds = max(awaited(structure, of), moves_over(structure, of))
        if seconds and closing > 0:
            near = closing * ANSWERS + closing**2 / (2 * BRAKES) + LEAST if waits.action in ("brake", "stop") else 0.0
            changes = {"gap": round(near + closing * seconds, 1)}
            structure = structure.with_spec(component.id, placement=at.model_copy(update=changes))
    return structure


def moves_over(structure: Structure, cid: str, waiting: frozenset[str] = frozenset()) -> float:
    """s after the start at which one first moves aside, about; 0: it does not, or that cannot be told. `waiting`: who
    waits for it."""
    phase = next((p for p in phases_of(structure, cid) if p.action in {*LATERAL, "swerve"}), None)
    spec = structure[cid].spec
    if isinstance(spec, ObjectSpec) and spec.placement.position == "on_ramp":
        return TO_RAMP_END + 2.0
    if phase is None or phase.trigger is None:
        return begins(structure, cid) if phase is not None else 0.0
    of = "E" if phase.trigger.of == "ego" else phase.trigger.of or ""
    if phase.trigger.kind == "time":
        return middle(phase.trigger.value or 0.0)
    if phase.trigger.kind != "action" or of not in structure or of in {cid, *waiting}:
        return 0.0
    return moves_over(structure, of, waiting | {cid})


def gone_round(structure: Structure) -> Structure:
    """With those that come up behind ego at the kerb, nobody says from how far, near as that pulls out; where one of
    them swerves round it then, ego, nobody says how fast, is slow enough to be passed, and who comes the other way is
    there meanwhile."""
    place, ego = structure.place.spec, structure.ego.spec
    assert isinstance(place, PlaceSpec) and isinstance(ego, EgoSpec)
    pulls_out = bool(ego.phases) and ego.phases[0].action == "enter_road" and ego.phases[0].trigger is None
    for component in structure.objects if pulls_out else ():
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        waits = (p.trigger for p in spec.phases if p.action == "swerve" and p.target == "ego" and p.trigger)
        own, at = middle(speed_of(spec, place)), spec.placement
        if at.of != "ego" or "behind" not in (at.position, at.along) or is_static(spec):
            continue
        if at.gap is None and at.position in ("behind", "left_lane"):
            changes = {"gap": round(own * (UNDISTURBED + WARNED), 1)}
            structure = structure.with_spec(component.id, placement=at.model_copy(update=changes))
        if not any(t.of == "ego" and t.action == "enter_road" for t in waits):
            continue
        if ego.phases[0].speed is None:
            structure = with_phase(structure, "E", 0, speed=round(PULLS_OUT * own, 1))
        for other in structure.objects:
            there = other.spec.placement if isinstance(other.spec, ObjectSpec) else None
            if there is not None and there.position == "oncoming_lane" and there.gap is None:
                comes = middle(speed_of(other.spec, place)) * (UNDISTURBED + WARNED)  # type: ignore[arg-type]
                comes -= LENGTH[spec.type] + LENGTH[other.spec.type]  # type: ignore[union-attr]
                structure = structure.with_spec(other.id, placement=there.model_copy(update={"gap": round(comes, 1)}))
    return structure


def comes_first(structure: Structure) -> Structure:
    """With what stands beside the road or in the lane ahead, nobody says how far, beyond where one is, also ahead of
    ego, that gets past it or hits it: as far from there as that drives before it does something."""
    place = structure.place.spec
    assert isinstance(place, PlaceSpec)
    for component in structure.objects:
        spec = _starting_ahead(structure, component.id)
        for phase in spec.phases if spec is not None and not is_static(spec) else ():
            thing = _starting_ahead(structure, phase.target) if phase.action in GETS_PAST else None
            if spec is None or thing is None or not is_static(thing) or thing.placement.gap is not None:
                continue
            own, gap = middle(speed_of(spec, place)), spec.placement.gap
            first = middle(gap) if gap is not None else default_gap(spec, own, place)
            beyond = round(first + LENGTH[spec.type] + own * (UNDISTURBED + WARNED), 1)
            placement = thing.placement.model_copy(update={"gap": beyond})
            structure = structure.with_spec(str(phase.target), placement=placement)
    return structure


def _starting_ahead(structure: Structure, cid: str | None) -> ObjectSpec | None:
    """An object that starts ahead of ego, in its lane or beside the road; None: it does not, or is not there."""
    spec = structure[cid].spec if cid and cid in structure else None
    at = spec.placement if isinstance(spec, ObjectSpec) else None
    ahead = at is not None and at.of == "ego" and at.position in AHEAD and at.along != "behind"
    return spec if ahead and isinstance(spec, ObjectSpec) else None


def let_by(structure: Structure) -> Structure:
    """With those on the carriageway whom ego, on the ramp, lets by, nobody says where: the last of them comes by
    as ego has slowed down for that."""
    ego, place = structure.ego.spec, structure.place.spec
    assert isinstance(ego, EgoSpec) and isinstance(place, PlaceSpec)
    waits = (p.trigger for p in ego.phases if p.trigger and p.trigger.kind == "passed" and p.trigger.of == "ego")
    last = next((t.subject for t in waits if t.subject and t.subject in structure), None)
    if place.kind != "on_ramp" or last is None:
        return structure
    found = _first(structure, last)
    if found is None:
        return structure
    first, chain = found
    chain += row_length(structure[last].spec) - LENGTH[structure[last].spec.type]  # type: ignore[arg-type, union-attr]
    at_end = any(p.trigger and p.trigger.place == "merge_end" for p in ego.phases)
    own = middle(speed_of(ego, place))
    up = max([own, *(middle(p.speed) for p in ego.phases if p.action == "accelerate" and p.speed is not None)])
    seconds = TO_RAMP_END + (ACCELERATION_LANE / up if at_end else 0.0)
    spec = structure[first].spec
    assert isinstance(spec, ObjectSpec)
    gains = (middle(speed_of(spec, place)) - (own + 3 * up) / 4) * seconds
    slow = next((middle(p.speed) if p.speed is not None else up / 2 for p in ego.phases if p.action == "brake"), up)
    level = (LENGTH[ego.type] + LENGTH[spec.type]) / 2
    return _starting(structure, first, chain - level - gains - (up - slow) ** 2 / (2 * SLOWS), level)


def joined(structure: Structure) -> Structure:
    """With those on the carriageway, nobody says where, before one of whom ego comes over from the ramp: that one is so
    far behind it by then as is said, or ego is in the middle between it and who is ahead of it."""
    ego, place = structure.ego.spec, structure.place.spec
    assert isinstance(ego, EgoSpec) and isinstance(place, PlaceSpec)
    phase = next((p for p in ego.phases if p.action in LATERAL), None)
    whom = phase.target if phase is not None and not phase.abandoned else None
    found = _first(structure, whom) if place.kind == "on_ramp" and whom and whom in structure else None
    if phase is None or whom is None or found is None:
        return structure
    first, chain = found
    spec, behind = structure[first].spec, structure[whom].spec
    assert isinstance(spec, ObjectSpec) and isinstance(behind, ObjectSpec)
    own, level = middle(speed_of(ego, place)), (LENGTH[ego.type] + LENGTH[behind.type]) / 2
    up = max([own, *(middle(p.speed) for p in ego.phases if p.action == "accelerate" and p.speed is not None)])
    between = behind.placement.gap if first != whom else None
    gap = (middle(between) - LENGTH[ego.type]) / 2 if between is not None else TIGHT * own
    gap = middle(phase.gap) if phase.gap is not None else gap
    gained, on_it = (up - own) / GAINS, RAMP * own + CONNECTS
    rest = max(on_it - own * UNDISTURBED - (up + own) / 2 * gained, 0.0) / up
    over = to_line(ego.type, phase)
    seconds = UNDISTURBED + gained + rest + over
    travelled = own * UNDISTURBED + (up + own) / 2 * gained + (rest + over) * up
    start = travelled - gap - level - middle(speed_of(behind, place)) * seconds
    for i, then in enumerate(ego.phases):  # no further from whom it then follows than there is room
        if then.action == "follow" and then.gap is None and between is not None and then.target == behind.placement.of:
            structure = with_phase(structure, "E", i, gap=round(gap, 1))
    return _starting(structure, first, start + chain, (LENGTH[ego.type] + LENGTH[spec.type]) / 2)


def _first(structure: Structure, cid: str | None) -> tuple[str, float] | None:
    """The first of those behind whom one drives, in the lane beside ego's, and how far (m) it is ahead of that one;
    None: S says where they are."""
    place, chain = structure.place.spec, 0.0
    assert isinstance(place, PlaceSpec)
    while cid and (spec := structure[cid].spec) and isinstance(spec, ObjectSpec) and spec.placement.of in structure:
        of, gap = structure[spec.placement.of].spec, spec.placement.gap
        if spec.placement.position != "behind" or not isinstance(of, ObjectSpec):
            return None
        own = middle(gap) if gap is not None else default_gap(spec, middle(speed_of(spec, place)), place)
        chain, cid = chain + own + (LENGTH[spec.type] + LENGTH[of.type]) / 2, spec.placement.of
    first = structure[cid].spec if cid else None
    if not isinstance(first, ObjectSpec) or first.placement.position != "left_lane" or first.placement.gap is not None:
        return None
    return str(cid), chain


def _starting(structure: Structure, cid: str, ahead: float, level: float) -> Structure:
    """One in the next lane so far (m) ahead of ego, middle from middle, at the start; `level`: half of both lengths."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    changes = {"along": "ahead" if ahead >= 0 else "behind", "gap": round(max(abs(ahead) - level, 0.0), 1)}
    return structure.with_spec(cid, placement=spec.placement.model_copy(update=changes))


def clear_ahead(structure: Structure) -> Structure:
    """With what stands in ego's lane, or is slower there, nobody says how far ahead, where ego has left that lane by
    then or, where it breaks that off, still has not come up to it."""
    ego, place = structure.ego.spec, structure.place.spec
    assert isinstance(ego, EgoSpec) and isinstance(place, PlaceSpec)
    actions = [p.action for p in ego.phases]
    own = middle(speed_of(ego, place))
    if "lane_change" not in actions or own <= 0 or place.kind not in ("road", "straight", "motorway"):
        return structure
    phase = ego.phases[actions.index("lane_change")]
    before = LETS_BY if "yield" in actions[: actions.index("lane_change")] else 0.0
    seconds = UNDISTURBED + before + sideways(LANE_WIDTH, shift_of(phase)) + (4.0 if phase.abandoned else 2.0)
    for component in structure.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        at = spec.placement
        slow = 0.0 if is_static(spec) else middle(speed_of(spec, place))
        slower = not slow or phase.abandoned and slow < own
        if at.position == "ahead" and at.of == "ego" and at.gap is None and slower:
            changes = {"gap": round((own - slow) * seconds + BEHIND * slow, 1)}
            structure = structure.with_spec(component.id, placement=at.model_copy(update=changes))
    return structure


def revealing(structure: Structure, cid: str, i: int, phase: Phase) -> Structure:
    """One that leaves its lane before what stands in it: late, and yet out of it before it is there."""
    spec = structure[cid].spec
    stands = next((c for c in structure.objects if stands_before(structure, cid, c.id)), None)
    if stands is None or not isinstance(spec, ObjectSpec):
        return structure
    trigger, place, thing = phase.trigger, structure.place.spec, stands.spec
    assert isinstance(thing, ObjectSpec) and isinstance(place, PlaceSpec)
    if phase.action != "cut_out" and trigger is None and thing.placement.hidden_by != cid:
        return structure  # it does so in good time
    if trigger is not None and trigger.kind == "distance" and trigger.value is None:  # as near as that can be
        trigger = None
    speed, out = middle(speed_of(spec, place)), (WIDTH[spec.type] + WIDTH[thing.type]) / 2 + 0.2
    shift, closing = shift_of(phase), speed - (0.0 if is_static(thing) else middle(speed_of(thing, place)))
    told = _left(structure, cid, stands.id, trigger, closing)
    if told is None:
        left = sideways(out, shift) + CLEAR
    else:
        left = told
        over = to_line(spec.type, phase) if trigger.kind == "distance" else 0.0  # type: ignore[union-attr]
        if sideways(out, shift) + CLEAR / 2 > left and over:  # that near it is over the line, not still in the middle
            sooner = round(middle(trigger.value) + over * closing, 1)  # type: ignore[union-attr, arg-type]
            left += over
            earlier = trigger.model_copy(update={"value": sooner})  # type: ignore[union-attr]
            structure = with_phase(structure, cid, i, trigger=earlier)
        while said(phase) is None and shift < 3.5 and sideways(out, shift) + CLEAR / 2 > left:
            shift = round(shift + 0.1, 1)
    if sideways(out, shift) > left:
        raise ResolveError(
            f"{cid} has {left:g} s to {stands.id} as it begins to leave its lane, and needs "
            f"{sideways(out, shift):.1f} s: begin earlier or let it move sideways faster",
            (f"{cid}.phases.{i}.trigger", f"{cid}.phases.{i}.lateral_speed"),
        )
    if trigger is None:
        structure = with_phase(structure, cid, i, trigger=Trigger(kind="ttc", value=round(left, 1), of=stands.id))
    if shift != shift_of(phase):
        structure = with_phase(structure, cid, i, lateral_speed=shift)
    at = thing.placement
    if at.gap is not None or trigger is not None and trigger.kind != "ttc":
        return structure
    gap = closing * (left + begins(structure, cid))
    if at.of == "ego":
        gap += LENGTH[spec.type] + middle(spec.placement.gap if spec.placement.gap is not None else
                                          default_gap(spec, speed, place))  # fmt: skip
    return structure.with_spec(stands.id, placement=at.model_copy(update={"gap": round(gap, 1)}))


def _left(structure: Structure, cid: str, thing: str, trigger: Trigger | None, closing: float) -> float | None:
    """s that one has to what stands before it as its trigger comes true; None: that does not say how near it is."""
    if trigger is None or trigger.value is None or trigger.of != thing:
        return None
    value = middle(trigger.value)
    if trigger.kind == "ttc" and trigger.subject in (None, cid):
        return value
    if trigger.kind != "distance" or trigger.subject not in (None, cid, "ego") or closing <= 0:
        return None
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    at = spec.placement
    if trigger.subject == "ego":
        if at.position != "ahead" or at.of != "ego" or at.gap is None:
            return None
        value -= middle(at.gap) + LENGTH[spec.type]
    return value / closing


def stands_before(structure: Structure, cid: str, other: str) -> bool:
    """Whether another stands, or is far slower, in the lane ahead of an object that drives."""
    spec, own = structure[other].spec, structure[cid].spec
    if not isinstance(spec, ObjectSpec) or not isinstance(own, ObjectSpec) or other == cid:
        return False
    place = structure.place.spec
    assert isinstance(place, PlaceSpec)
    if not is_static(spec) and middle(speed_of(spec, place)) > SLOW * middle(speed_of(own, place)):
        return False
    at = spec.placement
    return at.position == "ahead" and (at.of == cid or at.of == "ego" and own.placement.position == "ahead")


def merging(structure: Structure, cid: str) -> tuple[float, float | None]:
    """Of one that comes up a ramp: how far (m) its middle is ahead of ego's where it begins to change onto ego's lane,
    and how far (m) that is before the end of the acceleration lane (None: as it comes onto it)."""
    spec, place = structure[cid].spec, structure.place.spec
    assert isinstance(spec, ObjectSpec) and isinstance(place, PlaceSpec)
    own, ego = middle(speed_of(spec, place)), middle(speed_of(structure.ego.spec, place))  # type: ignore[arg-type]
    half = (LENGTH[spec.type] + LENGTH[structure.ego.spec.type]) / 2  # type: ignore[union-attr]
    phase = next((p for p in spec.phases if p.action in LATERAL), None)
    trigger = phase.trigger if phase is not None else None
    at_end = trigger is not None and trigger.kind == "place" and trigger.place == "merge_end"
    end = max(middle(trigger.value or 0.0), MERGES) if trigger is not None and at_end else None
    late = middle(spec.placement.later or 0.0) * own
    if spec.placement.arrives is not None:
        return 0.0 - middle(spec.placement.arrives) * own - late, end
    if phase is None or phase.action != "cut_in":
        return 0.0 - late, end
    gap = middle(phase.gap) if phase.gap is not None else max(LEAST, TIGHT * min(own, ego))
    return gap + half + (ego - own) * to_line(spec.type, phase) - late, end
