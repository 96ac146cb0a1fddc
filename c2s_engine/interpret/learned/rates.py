"""How hard somebody brakes ("hard", "gently"), by the words beside the verb, where the model says no number."""

import re
from itertools import takewhile
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.learned.account import is_said, numbers_of, words_of_fields
from c2s_engine.structure.components import WORDS, Assumption, Component, Structure, Unmet

NEAR = 3
"""Words between the verb and what says how hard it is done."""
ACTIONS = ("brake", "stop")


def with_rates(structure: Structure) -> Structure:
    """S with the rates of braking that words of its text say; by its links."""
    for component in structure.components:
        phases = list(getattr(component.spec, "phases", ()))
        for number, phase in enumerate(phases):
            if phase.action not in ACTIONS or phase.rate is not None:
                continue
            word, row = _said(structure.text, component, number)
            if row is not None:
                phases[number] = phase.model_copy(update={"rate": row["rate"]})
                note = Assumption(field=f"phases.{number}.rate", value=f"{row['rate']:g} m/s2", reason=row["reason"],
                                  by=WORDS)  # fmt: skip
                now = structure.with_spec(component.id, phases=tuple(phases))[component.id]
                structure = structure.with_component(now.model_copy(update={"assumed": (*now.assumed, note)}))
                missed = tuple(u for u in structure.not_understood if not _is_said(u, word, structure))
                structure = structure.model_copy(update={"not_understood": missed})
    return structure


def _is_said(unmet: Unmet, word: tuple[int, int], structure: Structure) -> bool:
    """Whether a phrase that counts as not understood is this word, and what S says besides."""
    start, end = unmet.span or (0, 0)
    rest = structure.text[start : word[0]] + " " + structure.text[word[1] : end]
    return start <= word[0] and word[1] <= end and (
        not rest.strip() or is_said(rest, numbers_of(structure), words_of_fields(structure))
    )


def _said(text: str, component: Component, number: int) -> tuple[tuple[int, int], Any]:
    """The word beside a phase's verb that says how hard it is done, and its row; None where there is none."""
    rows = language.table("trade")["rates"]
    for start in (li.span[0] for li in component.links if li.field == f"phases.{number}" and li.span):
        words = list(re.finditer(r"[a-z]+|[.;,]", text.lower()))
        verb = next((i for i, w in enumerate(words) if w.start() >= start), len(words))
        behind = list(takewhile(lambda w: w[0].isalpha(), words[verb : verb + NEAR + 1]))
        before = list(takewhile(lambda w: w[0].isalpha(), reversed(words[max(0, verb - NEAR) : verb])))
        for word in (*behind, *before):
            if (row := next((r for r in rows if word[0] in r["words"]), None)) is not None:
                return word.span(), row
    return (0, 0), None
