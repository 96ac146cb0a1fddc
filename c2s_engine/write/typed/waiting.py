"""Who waits for whom: of those that wait for each other's action, which S says of what happens at once, nobody waits;
whom another waits for to go by comes from behind that one."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import Phase

Moment = tuple[str, int]
"""The id of a component, and which of its phases begins."""


def together(structure: Structure) -> Structure:
    """S without the triggers of those that wait for each other."""
    phases = {c.id: getattr(c.spec, "phases", ()) for c in (structure.ego, *structure.objects)}
    awaited = dict(_awaited(phases))
    for moment in [m for m in awaited if _waits_for_itself(m, awaited)]:
        cid, i = moment
        changed = phases[cid][i].model_copy(update={"trigger": None})
        phases[cid] = (*phases[cid][:i], changed, *phases[cid][i + 1 :])
        structure = structure.with_spec(cid, phases=phases[cid])
    return structure


def coming_by(structure: Structure) -> Structure:
    """S in which those in the next lane that are to pass somebody first, where S does not say how far along they start,
    start behind that one."""
    phases = (p for c in (structure.ego, *structure.objects) for p in getattr(c.spec, "phases", ()))
    for trigger in (t for p in phases for t in (p.trigger, p.until) if t and t.kind == "passed"):
        spec = structure[trigger.subject].spec if trigger.subject in structure else None
        placement = getattr(spec, "placement", None)
        if placement is None or placement.position not in ("left_lane", "right_lane") or placement.along is not None:
            continue
        if placement.of == (trigger.of or "ego") and placement.facing != "against":
            behind = placement.model_copy(update={"along": "behind"})
            structure = structure.with_spec(str(trigger.subject), placement=behind)
    return structure


def _awaited(phases: dict[str, tuple[Phase, ...]]) -> list[tuple[Moment, Moment]]:
    """For each phase that waits for another's action: when that begins."""
    found = []
    for cid, own in phases.items():
        for i, phase in enumerate(own):
            trigger = phase.trigger
            if trigger is None or trigger.kind != "action" or trigger.of is None:
                continue
            other = "E" if trigger.of == "ego" else trigger.of
            j = next((j for j, p in enumerate(phases.get(other, ())) if p.action == trigger.action), None)
            if j is not None:
                found.append(((cid, i), (other, j)))
    return found


def _waits_for_itself(moment: Moment, awaited: dict[Moment, Moment]) -> bool:
    """Whether a phase begins only after itself: by what it waits for, and what comes before that."""
    todo, seen = [awaited[moment]], set()
    while todo:
        cid, i = todo.pop()
        if (cid, i) == moment:
            return True
        if (cid, i) not in seen:
            seen.add((cid, i))
            todo += [awaited[(cid, k)] for k in range(i + 1) if (cid, k) in awaited]
    return False
