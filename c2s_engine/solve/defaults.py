"""What anybody would take for granted of an S that somebody else made, said in `assumed`."""

from c2s_engine.solve.unknowns import PLANNER
from c2s_engine.structure.components import Assumption, Structure
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase

HOLDS = ("keep_lane", "accelerate", "collide", "drift", "run_red", "run_stop", "oncoming", "lose_control", "reverse")
"""What ego does of its own accord whatever the others do."""

EVADES = ("brake", "stop", "swerve", "lane_change", "yield", "leave_road")
"""What others do because of what ego does."""


MEETS = ("crossing_left", "crossing_right", "opposite_approach", "oncoming_lane", "circulating")
"""Where those start who come across ego's way, or towards it."""


def _goes_round_ego(phase: Phase) -> bool:
    """Whether one gets out of ego's way of its own."""
    by_ego = phase.target == EGO or phase.target is None and phase.action == "swerve"
    return phase.action in EVADES and by_ego and phase.trigger is None


def with_usual_reaction(structure: Structure) -> Structure:
    """S whose ego brakes for what comes into its way, where S says neither how it reacts nor that it does not (it
    drives on of its own accord, is hit, or the others get out of its way)."""
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    objects = [c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)]
    struck = any(p.action == "collide" and p.target in (None, EGO) for o in objects for p in o.phases)
    evaded = any(p.action in EVADES and p.trigger and p.trigger.kind == "action" and p.trigger.of == EGO
                 for o in objects for p in o.phases)  # fmt: skip
    evaded |= any(o.placement.position in MEETS and any(map(_goes_round_ego, o.phases)) for o in objects)
    if ego.reaction != "none" or struck or evaded or not objects or any(p.action in HOLDS for p in ego.phases):
        return structure
    note = Assumption(field="reaction", value="brake", by=PLANNER,
                      reason="ego's reaction is not specified: it brakes for anything entering its path")  # fmt: skip
    changed = {"spec": ego.model_copy(update={"reaction": "brake"}), "assumed": (*structure.ego.assumed, note)}
    return structure.with_component(structure.ego.model_copy(update=changed))
