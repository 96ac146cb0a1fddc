"""How hard somebody brakes ("hard", "gently"), by the words beside the verb, where the model says no number."""

import re

from c2s_engine.interpret import language
from c2s_engine.structure.components import Assumption, Component, Structure

NEAR = 3
"""Words between the verb and what says how hard it is done."""
ACTIONS = ("brake", "stop")


def with_rates(structure: Structure) -> Structure:
    """S with the rates of braking that words of its text say; by its links."""
    for component in structure.components:
        phases = getattr(component.spec, "phases", ())
        for number, phase in enumerate(phases):
            if phase.action in ACTIONS and phase.rate is None and (said := _said(structure.text, component, number)):
                rate, reason, words = said
                phases = (*phases[:number], phase.model_copy(update={"rate": rate}), *phases[number + 1 :])
                note = Assumption(field=f"phases.{number}.rate", value=f"{rate:g} m/s2", reason=reason, by="reader")
                structure = structure.with_spec(component.id, phases=phases)
                now = structure[component.id]
                structure = structure.with_component(now.model_copy(update={"assumed": (*now.assumed, note)}))
                missed = tuple(u for u in structure.not_understood if u.text.lower() not in words)
                structure = structure.model_copy(update={"not_understood": missed})
    return structure


def _said(text: str, component: Component, number: int) -> tuple[float, str, list[str]] | None:
    """The rate that words beside a phase's verb say, what it is, and the words that say it."""
    spans = [li.span for li in component.links if li.field == f"phases.{number}" and li.span]
    around = [*(text[e:] for _, e in spans), *(" ".join(reversed(text[:s].split())) for s, _ in spans)]
    near = {w for part in around for w in re.findall(r"[a-z]+", re.split(r"[.;,]", part.lower())[0])[:NEAR]}
    near |= {text[slice(*span)].lower() for span in spans}
    rows = language.table("trade")["rates"]
    return next(((r["rate"], r["reason"], r["words"]) for r in rows if near & set(r["words"])), None)
