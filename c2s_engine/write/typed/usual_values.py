"""The values that are written where S leaves them open, as numbers: where a search for better ones begins."""

from dataclasses import dataclass, field

from c2s_engine.structure.components import ComponentId, Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec
from c2s_engine.write.typed.alongside import offset
from c2s_engine.write.typed.beside import before_crosswalk
from c2s_engine.write.typed.people import states_when
from c2s_engine.write.typed.planning import make_plan, usual_duration
from c2s_engine.write.typed.spread import spread
from c2s_engine.write.typed.stations import hides_beside
from c2s_engine.write.typed.tables import TIMED, is_static
from c2s_engine.write.typed.usual import crosses, default_gap, has_marking, right_behind, speed_of, uses_crosswalk


@dataclass(frozen=True)
class Usual:
    """Starting speeds (m/s) of ego (`E`) and of the objects, those of their kinds at such a place, their gaps (m), by
    how much (s) those come later who are timed to meet it, the m to the junction, the s of a run, and of one that
    is as long as anybody would take it."""

    speeds: dict[ComponentId, float] = field(default_factory=dict)
    typical: dict[ComponentId, float] = field(default_factory=dict)
    gaps: dict[ComponentId, float] = field(default_factory=dict)
    later: dict[ComponentId, float] = field(default_factory=dict)
    distance: float | None = None
    duration: float = 20.0
    open_duration: float = 20.0


def usual_values(structure: Structure, room: float) -> Usual:
    """What the writer takes for S; raises ResolveError where S contradicts itself."""
    written = spread(structure)
    plan = make_plan(written, room)
    ego = written.ego.spec
    assert isinstance(ego, EgoSpec)
    speeds, gaps, later = {"E": middle(speed_of(ego, plan.place))}, {}, {}
    open_ = {"speed": None}
    typical = {c.id: middle(speed_of(c.spec.model_copy(update=open_), plan.place))  # type: ignore[arg-type]
               for c in (written.ego, *written.objects)}  # fmt: skip
    for component in written.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        speeds[component.id] = 0.0 if is_static(spec) else middle(speed_of(spec, plan.place))
        timed = spec.placement.position in TIMED or offset(spec, ego, plan.place)
        meets = timed and spec.placement.gap is None or crosses(spec)
        if meets and not any(p.trigger for p in spec.phases[:1]) and not (crosses(spec) and states_when(spec)):
            later[component.id] = middle(spec.placement.later or 0.0)
        elsewhere = right_behind(spec) or hides_beside(written, spec) is not None
        by_crosswalk = has_marking(plan.place) and uses_crosswalk(spec)
        elsewhere = elsewhere or by_crosswalk or bool(before_crosswalk(written, component.id, plan))
        if spec.placement.position not in TIMED and not elsewhere:
            gap = spec.placement.gap
            gaps[component.id] = middle(gap) if gap is not None else default_gap(spec, plan.ego_speed, plan.place)
    distance = None if plan.distance is None else middle(plan.distance)
    objects = {c.id: c.spec for c in written.objects if isinstance(c.spec, ObjectSpec)}
    whole = usual_duration(plan.place, ego, objects)
    return Usual(speeds, typical, gaps, later, distance, plan.duration, whole)
