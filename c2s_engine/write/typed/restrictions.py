"""T: requirements at the start, and the end of the run."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import Condition, RestrictionsSpec
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.plan import Plan


def write_restrictions(structure: Structure, plan: Plan) -> str:
    spec = structure.restrictions.spec
    assert isinstance(spec, RestrictionsSpec)
    lines = [f"require {_condition(structure, c)}" for c in spec.require]
    lines += [f"terminate when {_condition(structure, c)}" for c in spec.terminate_when]
    lines.append(f"terminate after {scope.number(plan.duration)} seconds")
    return "\n".join(lines)


def _condition(structure: Structure, c: Condition) -> str:
    subject = scope.reference(structure, c.subject)
    other = scope.reference(structure, c.other) if c.other else "ego"
    if c.kind in ("visible", "not_visible"):
        return f"{'' if c.kind == 'visible' else 'not '}({subject} can see {other})"
    if c.kind == "time":
        return f"simulation().currentTime * simulation().timestep >= {scope.number(c.minimum or 0)}"
    if c.kind == "stopped":
        return f"({subject}.speed < 0.2 and simulation().currentTime * simulation().timestep > 2)"
    if c.kind == "collision":
        return f"({subject} intersects {other})"
    if c.kind == "travelled":
        return f"(distance from {subject} to {subject}.start) >= {scope.number(c.minimum or 0)}"
    parts = []
    if c.minimum is not None:
        parts.append(f"(distance from {subject} to {other}) >= {scope.number(c.minimum)}")
    if c.maximum is not None:
        parts.append(f"(distance from {subject} to {other}) <= {scope.number(c.maximum)}")
    return " and ".join(parts) or "True"
