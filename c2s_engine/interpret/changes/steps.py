"""Changes of one step of what somebody does: "2 s more before the second lane change", "it brakes, then cuts in"."""

import re
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, name_of
from c2s_engine.interpret.changes.motion import rate
from c2s_engine.interpret.changes.refer import refer, spec_of
from c2s_engine.interpret.changes.timing import another_moment
from c2s_engine.interpret.changes.told import acting
from c2s_engine.interpret.entities import PERSONS
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import SetField
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Trigger

Steps = tuple[Phase, ...]


def _table() -> dict[str, Any]:
    found: dict[str, Any] = language.table("turns")["steps"]
    return found


def step(clause: str, structure: Structure) -> Found | None:
    """ "Delay the second lane change by 2 s", "skip the last stop", "the truck brakes before it goes back"."""
    if not re.search(_table()["telling"], clause):
        return None
    for sort, forms in _forms():
        match = next((m for form in forms if (m := form.fullmatch(clause))), None)
        found = _doer(sort, match, structure) if match else None
        if match is None or found is None:
            continue
        component, number = found
        phases = _changed(sort, match, component, number, structure)
        if phases is not None and phases != _phases(component):
            edit = SetField(component=component.id, path="phases", value=phases)
            return [edit], f"{name_of(component)}: {', '.join(p.action.replace('_', ' ') for p in phases)}"
    return None


@cache
def _forms() -> list[tuple[str, list[re.Pattern[str]]]]:
    table = _table()
    acts = "|".join(said for said, _ in table["acts"])
    words = {**table["words"], "acts": f"(?:{acts})"}
    sorts = ("returned", "later", "delayed", "shifted", "at", "left_out", "once", "harder", "sided", "inserted")
    between = [re.compile(table["in_between"])]
    return [
        *((sort, [re.compile(language.filled(form, words)) for form in table[sort]]) for sort in sorts),
        ("inserted", between),
    ]


def _doer(sort: str, match: re.Match[str], structure: Structure) -> tuple[Component, int] | None:
    """Whose step is meant, and the how manieth of his; None where it is not clear."""
    said = match.groupdict() | {"whole": match.string}
    who = said.get("who") or said.get("of") or said.get("rest")
    meant = refer(who, structure, alone=False) if who else None
    if meant is None and (said.get("who") or said.get("of")) and not re.fullmatch(r"it|he|she|they", who or ""):
        return None
    found = [
        (c, number)
        for c in ([meant] if meant is not None else [structure.ego, *structure.objects])
        if (number := _number(sort, said, _phases(c))) is not None
    ]
    return found[0] if len(found) == 1 else None


def _acts(words: str) -> list[str]:
    """The actions that the words for an act can mean."""
    return next((list(actions) for pattern, actions in _table()["acts"] if re.fullmatch(pattern, words)), [])


def _alone(component: Component, structure: Structure) -> Structure:
    """S with nobody else who does anything, so that "brake harder" is about this one."""
    for other in (structure.ego, *structure.objects):
        if other.id != component.id and _phases(other):
            idle = other.model_copy(update={"spec": other.spec.model_copy(update={"phases": ()})})
            structure = structure.with_component(idle)
    return structure


def _number(sort: str, said: dict[str, Any], phases: Steps) -> int | None:
    """Which of the phases the words mean."""
    if sort == "returned":
        sideways = [i for i, p in enumerate(phases) if p.action in _table()["sideways"] and p.side]
        return sideways[0] if len(sideways) == 1 and re.search(_table()["back"], said["whole"]) else None
    if "act" not in said:
        return 1 if len(phases) == 2 else None
    table = _table()
    acts = _acts(said["act"] or "braking")
    there = [i for i, p in enumerate(phases) if p.action in acts]
    if sort == "once":
        return there[0] if len(there) > 1 else None
    if said.get("rel") == "between":
        return there[1] if len(there) == 2 else None
    if said.get("nth"):
        index = table["nth"][said["nth"]]
        return there[index] if -len(there) <= index < len(there) and len(there) > 1 else None
    if len(there) > 1 and (said.get("again") or re.search(table["back"], said["act"])):
        return there[-1]
    first = [i for i in there if phases[i].action == acts[0]]
    return there[0] if len(there) == 1 else first[0] if len(first) == 1 else None


def _changed(sort: str, match: re.Match[str], component: Component, number: int, structure: Structure) -> Steps | None:
    """The phases as the match asks for them; None where it asks for something else."""
    phases, said = _phases(component), match.groupdict()
    if sort == "returned":
        return _returned(phases, number, said)
    clear = bool(said.get("nth")) or len(phases) > 1
    seconds = float(said["t"]) if said.get("t") else None
    if sort == "delayed" or sort == "later" and (said.get("nth") or said.get("more")):
        return _moved(component, number, seconds, True)
    if sort == "shifted":
        return _moved(component, number, seconds, said["way"] == "later")
    if sort == "at" and said.get("nth"):
        return _with(phases, number, phases[number].model_copy(update={"trigger": _after(seconds or 0.0)}))
    if sort == "left_out" and clear:
        return (*phases[:number], *phases[number + 1 :])
    if sort == "once":
        return tuple(p for i, p in enumerate(phases) if i <= number or p.action not in _acts(said["act"]))
    if sort == "harder" and said.get("nth") and (found := rate(f"brake {said['how']}", _alone(component, structure))):
        edit = found[0][0]
        return _with(phases, number, edit.value[number]) if isinstance(edit, SetField) else None
    if sort == "sided" and said.get("nth"):
        return _with(phases, number, phases[number].model_copy(update={"side": said["side"]}))
    if sort == "inserted":
        return _with_another(match, component, number, structure)
    return None


def _moved(component: Component, number: int, seconds: float | None, later: bool) -> Steps | None:
    """The phases with one of them so much later or earlier."""
    phases = _phases(component)
    phase, far = phases[number], seconds if seconds is not None else _table()["delay"]
    if phase.trigger is not None or number == 0:
        moved = another_moment(phase, {"low": far} if seconds is not None else None, None, later)
        return _with(phases, number, moved) if moved else None
    before = phases[number - 1]
    if before.duration is not None and isinstance(before.duration, float | int):
        lasts = before.duration + (far if later else -far)
        kept = (before.model_copy(update={"duration": round(lasts, 1)}),) if lasts > 0 else ()
        return (*phases[: number - 1], *kept, *phases[number:])
    if not later:
        return None
    stands = before.action in _table()["standing"] or component.id != "E" and spec_of(component).type in PERSONS
    pause = Phase(action="wait" if stands else "keep_lane", duration=far)
    return (*phases[:number], pause, *phases[number:])


def _with_another(match: re.Match[str], component: Component, number: int, structure: Structure) -> Steps | None:
    """The phases with what the rest of the clause tells of the same one, before or behind one of them."""
    phases, rest = _phases(component), match["rest"]
    doer = refer(rest, structure, alone=False)
    if doer is None or doer.id != component.id or not phases or "but" in rest.split():
        return None
    idle = component.model_copy(update={"spec": component.spec.model_copy(update={"phases": ()})})
    told = acting(re.sub(r"\bin between\b|\balso\b", "", rest), structure.with_component(idle))
    found = [e for e in told[0] if isinstance(e, SetField) and e.path == "phases"] if told else []
    if len(found) != 1 or found[0].component != component.id or not found[0].value:
        return None
    at = number + 1 if match.groupdict().get("rel") == "after" else number
    return (*phases[:at], *found[0].value, *phases[at:])


def _returned(phases: Steps, number: int, said: dict[str, Any]) -> Steps:
    """The phases, and that he then goes back to the lane that he left in one of them."""
    side = "left" if phases[number].side == "right" else "right"
    trigger = _after(float(said["at"])) if said.get("at") else None
    back = Phase(action="lane_change", side=side, trigger=trigger)
    pause = (Phase(action="keep_lane", duration=float(said["t"])),) if said.get("t") else ()
    return (*phases, *pause, back)


def _with(phases: Steps, number: int, phase: Phase) -> Steps:
    return (*phases[:number], phase, *phases[number + 1 :])


def _after(seconds: float) -> Trigger:
    return Trigger(kind="time", value=seconds)


def _phases(component: Component) -> Steps:
    return component.spec.phases if isinstance(component.spec, EgoSpec | ObjectSpec) else ()
