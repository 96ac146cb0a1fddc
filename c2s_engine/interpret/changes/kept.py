"""What a change does not speak of stays: phases and numbers that it leaves alone; what goes all the same is named."""

import re
from collections.abc import Sequence
from typing import Any

from c2s_engine.interpret.changes.refer import doing
from c2s_engine.interpret.changes.scene_context import table
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import Edit, apply
from c2s_engine.structure.quantity import in_words
from c2s_engine.structure.specs import Phase

WAYS = {"go_straight": "straight", "turn_left": "left", "turn_right": "right", "u_turn": "u_turn"}
"""Ways through an intersection, as actions and as ego's manoeuvre."""
PACING = frozenset(("brake", "accelerate", "stop", "wait", "collide"))
"""Acts that say nothing of the way on which somebody does them."""
ASIDE = frozenset(("lane_change", "cut_in", "cut_out", "overtake", "swerve", "drift", "oncoming", "leave_road"))
"""Acts that say where somebody goes."""
NUMBERS = ("speed", "rate", "gap", "duration", "lateral_speed", "clearance")
"""Fields of a phase that are numbers."""


def with_old(old: Sequence[Phase], new: Sequence[Phase], clause: str) -> tuple[Phase, ...]:
    """What somebody does by a clause that tells of acts that he has: those become what is said of them, the others
    stay in their order. The new ones alone where the clause speaks of none of his acts or says that he does no other.
    """
    if re.search(table()["only_that"], clause) or re.search(table()["denies"], clause):
        return tuple(new)
    known = {p.action for p in old}
    again = [i for i, p in enumerate(new) if p.action in known]
    turns = any(p.action in WAYS for p in new)
    told = [i for i, p in enumerate(old) if doing(clause, (p.action,)) and not (turns and p.action in WAYS)]
    if not again:
        if len(new) == 1 and new[0].action in PACING and not re.search(table()["plainly"], clause):
            midway = re.search(table()["midway"], clause)
            beside = [p for p in old if p.action in ASIDE or midway and p.action == "cross_road"
                      or p.action == "follow" and p.target != new[0].target]  # fmt: skip
            if beside and not told and not re.search(r"\bbefore\b", clause):
                return (*beside, *new)  # how fast it goes says nothing of where it goes
        if not told or len(new) != 1:
            return tuple(new)
        at = told[0] if re.search(r"\bbefore\b", clause) else told[-1] + 1
        return (*old[:at], *new, *old[at:])
    ways = WAYS if any(p.action in WAYS for p in new) else ()
    found = [p for p in old if p.action not in ways]
    at = -1
    for phase in new:
        same = next((i for i, p in enumerate(found) if i > at and p.action == phase.action), None)
        if same is None:
            at += 1
            found.insert(at, phase)
        else:
            found[same], at = detailed(found[same], phase), same
    return tuple(found)


def detailed(old: Phase, new: Phase) -> Phase:
    """A phase with what is said of it now; what is not said stays."""
    return old.model_copy(update={k: v for k in Phase.model_fields if (v := getattr(new, k)) not in (None, False)})


def removed(before: Structure, edits: Sequence[Edit]) -> str:
    """The acts and numbers of those who stay that edits take away, in words; empty where nothing goes."""
    after = before
    for edit in edits:
        after = apply(after, edit)
    words: list[str] = []
    for component in before.components:
        if component.id in after and component.spec.component == after[component.id].spec.component:
            words += _gone(component, after[component.id])
    return f"removed: {', '.join(words)}" if words else ""


def _gone(before: Component, after: Component) -> list[str]:
    words: list[str] = []
    left: list[Phase] = list(getattr(after.spec, "phases", ()))
    for phase in getattr(before.spec, "phases", ()):
        same = next((p for p in left if p.action == phase.action), None)
        if same is None:
            words.append(phase.action.replace("_", " "))
        else:
            left.remove(same)
        words += [_number(name, now) for name in NUMBERS if (now := getattr(phase, name)) is not None
                  and (same is None or getattr(same, name) is None)]  # fmt: skip
    old, new = (getattr(c.spec, "placement", None) for c in (before, after))
    if old is not None and new is not None:
        words += [_number("gap", old.gap)] if old.gap is not None and new.gap is None else []
    return words


def _number(name: str, value: Any) -> str:
    return in_words("speed" if "speed" in name else "gap" if name == "clearance" else name, value)
