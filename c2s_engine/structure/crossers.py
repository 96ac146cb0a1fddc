"""Before whom somebody crosses the road: ego, or another in its lane."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase
from c2s_engine.structure.vocabulary import VEHICLES

ANSWERS = ("brake", "stop", "wait", "yield", "swerve", "lane_change", "overtake")
"""What one does for who is in its way."""


def crossed_vehicle(structure: Structure, cid: str) -> str:
    """Ego, or the vehicle ahead in its lane that is to touch somebody, or that answers to it where ego does not."""
    spec, ego = structure[cid].spec, structure.ego.spec
    assert isinstance(spec, ObjectSpec) and isinstance(ego, EgoSpec)
    own, struck = (_hit(phases) for phases in (ego.phases, spec.phases))
    if spec.placement.arrives is not None or not own.isdisjoint((cid, None)) or not struck.isdisjoint((EGO, None)):
        return EGO
    ahead = {c.id: c.spec.phases for c in structure.objects if isinstance(c.spec, ObjectSpec)
             and c.id != cid and c.spec.placement.position == "ahead" and c.spec.type in VEHICLES}  # fmt: skip
    touching = [other for other, phases in ahead.items() if other in struck or cid in _hit(phases)]
    answering = [other for other, phases in ahead.items() if any(_names(p, cid) for p in phases if p.action in ANSWERS)]
    noticed = ego.react_to == cid or any(_names(p, cid) for p in ego.phases)
    return next(iter(touching or ([] if noticed else answering)), EGO)


def _hit(phases: tuple[Phase, ...]) -> set[str | None]:
    return {p.target for p in phases if p.action == "collide"}


def _names(phase: Phase, cid: str) -> bool:
    return cid in (phase.target, phase.trigger.of if phase.trigger else None)
