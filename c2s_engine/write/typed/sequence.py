"""Where those start, nobody says it, whom ego or an animal meets in S's order: who comes is there by then."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec
from c2s_engine.write.typed.tables import is_static, is_vehicle
from c2s_engine.write.typed.usual import LONGEST_VIEW, crosses, default_gap, speed_of

GOES_BY = 3.0
"""s after the start at which one that comes towards ego goes by."""
THEN = 1.0
"""s from then to what ego does next."""
LEFT = 1.6
"""s that one who comes has left to somebody who runs in front of it."""
WAITS = 2.0
"""s for which somebody on foot stands where nothing says how long."""


def in_sequence(structure: Structure) -> Structure:
    """S with the gaps of those who come towards ego, and of what ego comes to after them."""
    return _run_before(_gone_by(structure))


def _gone_by(structure: Structure) -> Structure:
    """Whom ego lets go by first comes before what ego then goes round."""
    ego, place = structure.ego.spec, structure.place.spec
    assert isinstance(ego, EgoSpec) and isinstance(place, PlaceSpec)
    for phase, then in zip(ego.phases, ego.phases[1:], strict=False):
        passed = phase.until.of if phase.until and phase.until.kind == "passed" else None
        coming, thing = _coming(structure, passed), _object(structure, then.target)
        if not passed or not then.target or coming is None or thing is None or not is_static(thing):
            continue
        own, other, at = middle(speed_of(ego, place)), middle(speed_of(coming, place)), then.trigger
        seen = middle(at.value) if at and at.kind == "distance" and at.value is not None else 2 * own
        structure = _with_gap(structure, passed, GOES_BY * (own + other))
        if thing.placement.gap is None and thing.placement.of == "ego":
            structure = _with_gap(structure, then.target, own * (GOES_BY + THEN) + seen)
    return structure


def _run_before(structure: Structure) -> Structure:
    """Who brakes for somebody that runs on from ego's lane is so near by then that it has to."""
    ego, place = structure.ego.spec, structure.place.spec
    assert isinstance(ego, EgoSpec) and isinstance(place, PlaceSpec)
    own = middle(speed_of(ego, place))
    for component in structure.objects:
        coming = _coming(structure, component.id)
        runs = next((p.trigger.of for p in coming.phases if p.trigger and p.trigger.action == "cross_road"), None) \
            if coming else None  # fmt: skip
        runner = _object(structure, runs)
        if coming is None or runner is None or not crosses(runner) or own <= 0 or runner.placement.hidden_by:
            continue
        gap = middle(runner.placement.gap) if runner.placement.gap is not None else default_gap(runner, own, place)
        waits = sum(middle(p.duration) if p.duration is not None else WAITS
                    for p in runner.phases if p.action in ("wait", "stop"))  # fmt: skip
        speed = middle(speed_of(coming, place))
        far = gap + speed * (gap / own + waits + LEFT)
        if far > LONGEST_VIEW and coming.speed is None:  # not as fast
            speed = max((LONGEST_VIEW - gap) / (gap / own + waits + LEFT), 8.0)
            structure = structure.with_spec(component.id, speed=round(speed, 1))
            far = gap + speed * (gap / own + waits + LEFT)
        structure = _with_gap(structure, component.id, far)
    return structure


def _object(structure: Structure, cid: str | None) -> ObjectSpec | None:
    spec = structure[cid].spec if cid and cid in structure else None
    return spec if isinstance(spec, ObjectSpec) else None


def _coming(structure: Structure, cid: str | None) -> ObjectSpec | None:
    """One that drives towards ego, nobody says from how far off."""
    spec = _object(structure, cid)
    if spec is None or not is_vehicle(spec.type) or is_static(spec) or spec.placement.position != "oncoming_lane":
        return None
    return spec if spec.placement.gap is None and spec.placement.of == "ego" else None


def _with_gap(structure: Structure, cid: str, metres: float) -> Structure:
    spec = _object(structure, cid)
    assert spec is not None
    return structure.with_spec(cid, placement=spec.placement.model_copy(update={"gap": round(metres, 1)}))
