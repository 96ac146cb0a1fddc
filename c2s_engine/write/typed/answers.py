"""What ego does besides its own phases: what its place and its reaction add to them."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase
from c2s_engine.structure.triggers import gives_way_by
from c2s_engine.write.typed.lanes import leaves_lane
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import AT_REST
from c2s_engine.write.typed.threats import ASIDE, hits_ego, is_hit, threatening
from c2s_engine.write.typed.usual import crosses, rides_beside


def _stands_first(spec: EgoSpec) -> int:
    """How many of ego's phases, the first of them, are about standing before the junction."""
    moves = (i for i, p in enumerate(spec.phases) if p.action not in AT_REST or p.trigger is not None)
    return next(moves, 0)


def _cut_off(spec: EgoSpec, structure: Structure, plan: Plan) -> str | None:
    """The rider beside the road whose way ego would cut off by its turn to the right, and whom it lets pass first."""
    if not plan.junction or plan.place.manoeuvre != "right" or spec.reaction not in ("brake", "yield"):
        return None
    objects = [(c.id, c.spec) for c in structure.objects if isinstance(c.spec, ObjectSpec)]
    riders = [(cid, o) for cid, o in objects if rides_beside(o) and not (hits_ego(o) or is_hit(spec, cid))]
    riders = [(cid, o) for cid, o in riders if not AT_REST & {p.action for p in o.phases}]
    coming = [cid for cid, o in riders if o.placement.along in ("behind", "abreast") and o.placement.of == "ego"]
    return next((cid for cid in coming if cid != spec.react_to or spec.reaction == "brake"), None)


def _behind(structure: Structure, cid: str) -> bool:
    """Whether an object starts behind ego, or in the queue there."""
    spec = structure[cid].spec if cid in structure else None
    if not isinstance(spec, ObjectSpec) or spec.placement.position != "behind":
        return False
    return spec.placement.of == "ego" or _behind(structure, spec.placement.of)


def reacting_phases(spec: EgoSpec, others: list[str], structure: Structure, plan: Plan) -> tuple[Phase, ...]:
    """Ego's phases with those that its place and its reaction add: merging, leaving, yielding, evading."""
    phases = spec.phases
    changes = {"lane_change", "cut_in", "overtake"} & {p.action for p in phases}
    if plan.place.kind == "on_ramp" and not changes:
        spec = spec.model_copy(update={"phases": (*phases, Phase(action="lane_change", side="left"))})
    if plan.place.kind == "off_ramp" and -1 in plan.offsets and not changes:
        spec = spec.model_copy(update={"phases": (*phases, Phase(action="lane_change", side="right"))})
    actions = {p.action for p in spec.phases}
    hit = {p.target for p in spec.phases if p.action == "collide"}
    if "yield" not in actions and (rider := _cut_off(spec, structure, plan)):
        spec = spec.model_copy(update={"phases": (Phase(action="yield", target=rider), *spec.phases)})
    whom, yields = spec.react_to or next(iter(others), ""), spec.reaction == "yield" and "yield" not in actions
    slows = ("brake", "stop", "wait")
    named = (whom,) if plan.junction else (whom, None)
    told = any(p.abandoned or p.action in slows and about(p) in named for p in spec.phases)  # it says how
    yields = yields and not told
    if yields and _behind(structure, whom) and leaves_lane(spec):
        return spec.phases  # out of the way of who comes from behind: that lets it pass
    if yields and whom not in ("", *hit) and not gives_way_by(spec) and not waits_for(spec, whom):
        yielding = Phase(action="yield", target=whom)
        if plan.junction and (stands := _stands_first(spec)):
            return (*spec.phases[:stands], yielding, *spec.phases[stands:])
        return (yielding, *spec.phases)
    if spec.reaction == "evade" and others and not actions & {*ASIDE, "overtake", "oncoming"}:
        return (*spec.phases, Phase(action="swerve", target=spec.react_to or threatening(structure)[0]))
    walks = [c for c in others if isinstance(o := structure[c].spec, ObjectSpec) and crosses(o)]
    if spec.reaction != "brake" or plan.junction or len(walks) != 1:
        return spec.phases
    bare = [p for p in spec.phases if p.action == "stop" and not (p.target or p.trigger or p.until or p.clearance)]
    return tuple(p.model_copy(update={"target": walks[0]}) if p in bare else p for p in spec.phases)  # for that one


def waits_for(spec: EgoSpec, cid: str) -> bool:
    """Whether ego's phases say themselves that it stands for somebody, or until that one has gone by."""
    for i, p in enumerate(spec.phases):
        after = [q.trigger for q in spec.phases[i + 1 : i + 2]]
        ends = [t for t in (p.until, *after) if t is not None and t.kind in ("passed", "place")]
        if p.action in AT_REST and (p.target == cid or any(t.subject == cid for t in ends)):
            return True
    return False


def about(phase: Phase) -> str | None:
    """Whom one answers in a phase: whom it names, or for what it waits to be done."""
    return phase.target or (phase.trigger.of if phase.trigger and phase.trigger.kind == "action" else None)
