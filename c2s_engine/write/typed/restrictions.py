"""T: requirements at the start, and the end of the run."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import Condition, ObjectSpec, RestrictionsSpec
from c2s_engine.write.typed import scope, stations
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.threats import observed

AT_START = {"distance", "visible", "not_visible"}


def write_restrictions(structure: Structure, plan: Plan) -> str:
    """Requirements hold in the sampled scene; what only a run can show must happen in it (`require eventually`)."""
    spec = structure.restrictions.spec
    assert isinstance(spec, RestrictionsSpec)
    lines = []
    for c in spec.require:
        if c.kind == "closest":  # judged by what the run shows: a program that forbade it would only be rejected
            one, other = scope.reference(structure, c.subject), scope.reference(structure, c.other or "ego")
            lines.append(f"record gap({one}, {other}) as gap_{c.subject}_{c.other or 'ego'}")
            continue
        when = "" if c.kind in AT_START else "eventually "
        lines.append(f"require {when}{_condition(structure, c)}")
    for c in spec.terminate_when:
        guard = "" if c.kind == "time" else "clock() > 1 and "  # a run does not end as it begins
        lines.append(f"terminate when {guard}{_done(structure, c) or _condition(structure, c)}")
    lines.append(f"terminate after {scope.number(plan.duration)} seconds")
    return "\n".join(lines)


def _hiding(structure: Structure, c: Condition) -> str:
    """What hides the one that ego is not to see, where S says what does: of a row one; "": nothing."""
    seen = structure[c.other].spec if c.kind == "not_visible" and c.subject == "ego" and c.other else None
    by = seen.placement.hidden_by if isinstance(seen, ObjectSpec) else None
    if by is None or not isinstance(seen, ObjectSpec):
        return ""
    return scope.reference(structure, by).replace("[0]", stations.hiding_member(structure, seen))


def _done(structure: Structure, c: Condition) -> str:
    """That somebody has done something which takes a while: overtaken and come back, crossed the junction; "": the
    action is over as soon as it can be seen."""
    subject = scope.reference(structure, c.subject)
    if c.kind == "action" and c.action in ("turn_left", "turn_right", "go_straight"):
        return f"has_crossed({subject})"
    if c.kind != "action" or c.action != "overtake":
        return ""
    phases = getattr(structure["E" if c.subject == "ego" else c.subject].spec, "phases", ())
    whom = next((p.target for p in phases if p.action == "overtake"), None) or "ego"
    other = scope.reference(structure, whom)
    past = f"lead_on({subject}, {other}) > 10 + {subject}.length"
    return f"{past} and {subject}._lane is {other}._lane and not off_lane({subject})"


def _condition(structure: Structure, c: Condition) -> str:
    subject = scope.reference(structure, c.subject)
    other = scope.reference(structure, c.other) if c.other else "ego"
    if by := _hiding(structure, c):  # Scenic's `can see` looks through everything in 2D
        return f"hides({by}, {subject}.position, {other}.position)"
    if c.kind in ("visible", "not_visible"):
        return f"{'' if c.kind == 'visible' else 'not '}({subject} can see {other})"
    if c.kind == "time":
        return f"(clock() >= {scope.number(c.minimum or 0)})"
    if c.kind == "stopped":
        return f"({subject}.speed < 0.2)"
    if c.kind == "collision":
        return f"({subject} intersects {other})"
    if c.kind == "travelled":
        start = "place.lane.centerline.pointAlongBy(EGO_AT)"
        return f"((distance from ego to {start}) >= {scope.number(c.minimum or 0)})"
    if c.kind == "action":
        return f"({observed(structure, subject, c.subject, c.action)})"
    parts = []
    if c.minimum is not None:
        parts.append(f"gap({subject}, {other}) >= {scope.number(c.minimum)}")
    if c.maximum is not None:
        parts.append(f"gap({subject}, {other}) <= {scope.number(c.maximum)}")
    return f"({' and '.join(parts)})" if parts else "True"
