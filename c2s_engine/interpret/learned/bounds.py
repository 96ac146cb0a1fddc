"""Limits by the words before their amounts: "at least" is no maximum, whatever the model says."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.learned.account import Span, same
from c2s_engine.interpret.learned.units import OF_LIMIT, quantities
from c2s_engine.structure.components import Structure, Unmet
from c2s_engine.structure.objects import SLOWS
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, Limit, Phase, RestrictionsSpec

RATES = {"deceleration": SLOWS, "acceleration": ("accelerate", "start")}
"""Limits that say, with a minimum, how an action is done, by these actions."""
NOT_BRAKING = "no action of S has it as its rate"


def with_bounds(structure: Structure) -> Structure:
    """S, its limits on the side that the text says; at least so many m/s2 is the rate of an action."""
    spec = structure.restrictions.spec
    assert isinstance(spec, RestrictionsSpec)
    sides, limits = _sides(structure.text), []
    for limit in spec.limits:
        amount = limit.maximum if limit.maximum is not None else limit.minimum
        near = [(s, at) for value, unit, s, at in sides
                if amount is not None and unit == OF_LIMIT.get(limit.kind, "m") and same(amount, value)]  # fmt: skip
        side = near[0][0] if near else ""
        both = limit.minimum is not None and limit.maximum is not None
        if both or not side or side == ("most" if limit.minimum is None else "least") and limit.kind not in RATES:
            limits.append(limit)
        elif side == "least" and limit.kind in RATES:
            structure = _with_rate(structure, limit, float(amount or 0.0), near[0][1])
        else:
            bound = {"minimum": None, "maximum": amount} if side == "most" else {"minimum": amount, "maximum": None}
            limits.append(limit.model_copy(update=bound))
    return structure if tuple(limits) == spec.limits else structure.with_spec("T", limits=tuple(limits))


def _with_rate(structure: Structure, limit: Limit, rate: float, at: Span) -> Structure:
    """S with a rate of the first such action of somebody that has none; or with what is not understood, `at` its
    place."""
    cid = "E" if limit.subject == "ego" else limit.subject
    phases: list[Phase] = list(getattr(structure[cid].spec, "phases", ())) if cid in structure else []
    actions = RATES[limit.kind]
    if any(p.action in actions and p.rate is not None and middle(p.rate) >= rate for p in phases):
        return structure
    for number, phase in enumerate(phases):
        if phase.action in actions and phase.rate is None:
            phases[number] = phase.model_copy(update={"rate": rate})
            return structure.with_spec(cid, phases=tuple(phases))
    ego = structure.ego.spec
    if cid == "E" and limit.kind == "deceleration" and isinstance(ego, EgoSpec) and ego.reaction == "brake":
        return structure.with_spec("E", phases=(*phases, Phase(action="brake", target=ego.react_to, rate=rate)))
    missed = Unmet(text=structure.text[slice(*at)], reason=NOT_BRAKING, span=at)
    return structure.model_copy(update={"not_understood": (*structure.not_understood, missed)})


def _sides(text: str) -> list[tuple[float, str, str, Span]]:
    """The amounts of a text with a bound before them: SI value and unit, side, where the amount stands."""
    words = {side: language.alternatives(found) for side, found in language.table("trade")["bounds"].items()}
    ends = {side: re.compile(rf"(?:{found})\s*$", re.IGNORECASE) for side, found in words.items()}
    return [(value, unit, side, span) for span, value, unit in quantities(text)
            for side, before in ends.items() if before.search(text[: span[0]])]  # fmt: skip
