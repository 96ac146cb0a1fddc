"""Changes of when somebody does what he does anyway: later, earlier, too early."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, name_of, quantity_of
from c2s_engine.interpret.changes.refer import actions_of, doing, refer, spec_of
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import SetField
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import Phase, Trigger


def shifted(clause: str, structure: Structure) -> Found | None:
    """ "The car brakes later", "the child starts 2 s earlier", "he comes too early": another moment of what is done."""
    table = language.table("refine")["timing"]
    match = re.match(table["said"], clause)
    component = _timed_actor(clause, match["who"], structure) if match else None
    if match is None or component is None:
        return None
    later = bool(re.search(table["later"], match["way"]))
    phases = spec_of(component).phases
    waits = [i for i, p in enumerate(phases) if p.trigger]
    told = [i for i, p in enumerate(phases) if doing(clause, (p.action,))]
    acts = [i for i, p in enumerate(phases) if p.action not in table["lasting"]]
    named = [i for i in told if i in waits] or (told if len(told) < len(phases) else [])
    comes = [0] if phases and spec_of(component).placement.position in table["coming"] else []
    number = next(iter(named or waits or told or acts or comes), None)
    seconds, metres = quantity_of(clause, "time"), quantity_of(clause, "distance")
    if number is None:
        return None
    begins = middle(component.amount(f"phases.{number}.trigger") or 0.0)
    if (moved := another_moment(phases[number], seconds, metres, later, begins)) is None:
        return None
    value = (*phases[:number], moved, *phases[number + 1 :])
    edit = SetField(component=component.id, path="phases", value=value)
    return [edit], f"{name_of(component)}: {moved.action.replace('_', ' ')} {'later' if later else 'earlier'}"


def _timed_actor(clause: str, who: str | None, structure: Structure) -> Component | None:
    """Who is meant: by name, or by what is done."""
    named = refer(who, structure, alone=False) if who else None
    doers = [c for c in structure.objects if doing(clause, actions_of(c))] if named is None and not who else []
    found = named or (doers[0] if len(doers) == 1 else None)
    return found if found is not None and found.id != "E" else None


def another_moment(
    phase: Phase, seconds: dict[str, Any] | None, metres: dict[str, Any] | None, later: bool, begins: float
) -> Phase | None:
    """The phase with another moment; `begins`: s after the start at which the run shows it, where it waits for nothing
    (0: there is no run); None where it cannot begin any earlier, or waits for another's act."""
    old = phase.trigger
    if old is None:
        by = seconds["low"] if seconds else 2.0
        moment = round(begins + (by if later else -by), 1)
        trigger = Trigger(kind="time", value=moment)
        return phase.model_copy(update={"trigger": trigger}) if moment > 0 and not metres else None
    if old.kind == "action" or old.value is None:
        return None
    value = middle(old.value)
    told: dict[str, Any] | None = seconds if old.kind == "ttc" else metres
    value = value + told["low"] * (-1 if later else 1) if told else value * (0.7 if later else 1.4)
    kept = old.model_copy(update={"value": round(value, 1)}) if value > 0 else None
    return phase.model_copy(update={"trigger": kept})
