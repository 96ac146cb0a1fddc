"""What a run must show for S to hold, and what it showed: the data; c2s_engine.require derives and evaluates it.

A requirement is one statement about events and tracks, from S alone. Its `check` names the rule that decides it (the
table in c2s_engine/require), and the fields beside it are all that this rule reads. Values are SI.
"""

from collections import Counter
from collections.abc import Sequence
from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from c2s_engine.structure.components import ComponentId
from c2s_engine.structure.facts import RunFacts, Trajectories

Kind = Literal[
    "actors", "start", "phase", "order", "place", "outcome", "conflict", "reaction", "natural", "rules", "speed",
    "pace", "road", "settings", "limit",
]  # fmt: skip
Value = float | str | bool | tuple[float, ...] | tuple[str, ...]


class _Frozen(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class Requirement(_Frozen):
    """One thing that S requires of a run."""

    id: str = Field(description="stable under edits elsewhere: component, field, what: O1.phases.0.cut_in")
    kind: Kind
    component: ComponentId
    text: str = Field(description="one plain English sentence")
    clause: tuple[int, int] | None = Field(None, description="span in S.text, from the component's links")
    check: str = Field(description="the rule that decides it")
    actor: str = Field("ego", description="whom it is about: 'ego' or an object's id (O1)")
    other: str | None = Field(None, description="the other party: 'ego' or an object's id")
    values: dict[str, Value] = Field({}, description="what else the rule reads: bounds, events, sides, places")


class Result(_Frozen):
    """What a run showed of one requirement."""

    requirement: str = Field(description="the requirement's id")
    holds: bool | None = Field(description="None: not reached, or cannot be judged; `why` says which")
    robustness: float | None = Field(
        None, description="> 0: holds by so much, < 0: fails; normalised, 1 is a comfortable margin"
    )
    said: str = Field("", description="what is required, in a few words with units")
    seen: str = Field("", description="what the run showed, in a few words with units")
    time: float | None = Field(None, description="when it was decided, s since the start")
    value: float | None = Field(None, description="what was measured, where that is one number, SI units")
    bounds: tuple[float, float] | None = Field(None, description="between which it must lie")
    due: float | None = Field(
        None, description="s by which requirement.actor should be later (over 0) or earlier (below 0) for it to hold"
    )
    why: str = ""


SAME = 3
"""Requirements that one reason keeps from being judged, beyond which they are told together."""


def tally(results: Sequence[Result]) -> tuple[int, int]:
    """How many of the requirements were seen, of how many. What was not reached was not seen."""
    return sum(1 for r in results if r.holds), len(results)


def failures(requirements: Sequence[Requirement], results: Sequence[Result]) -> list[str]:
    """A line for each requirement that was not seen: the component, what is required, what was seen."""
    known = {r.id: r for r in requirements}
    lines, reasons = [], Counter(r.why for r in results if r.holds is None)
    for result in results:
        if not result.holds and (required := known.get(result.requirement)) is not None:
            often = reasons[result.why] if result.holds is None else 0
            if often > SAME:
                if (line := f"{often} requirements: {result.why}.") not in lines:
                    lines.append(line)
                continue
            seen = result.seen or result.why
            named = required.component in required.text or required.component == "E" and "ego" in required.text.lower()
            whose = "" if named else f"{required.component}: "
            lines.append(f"{whose}{required.text} Required: {result.said}; the run: {seen or 'not observed'}.")
    return lines


class Run(_Frozen):
    """A run with its tracks, as evaluation takes it (the counterfactual: the same scene, ego's reaction off)."""

    facts: RunFacts
    trajectories: Trajectories
