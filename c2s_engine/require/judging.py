"""Requirements against runs."""

from collections.abc import Iterable, Sequence

from c2s_engine.require.deriving import PARTS
from c2s_engine.require.evidence import Evidence
from c2s_engine.require.results import unknown
from c2s_engine.structure.facts import RunFacts, Trajectories
from c2s_engine.structure.requirements import Requirement, Result, Run

SO_FAR = ("actors", "start", "road", "settings")
"""Kinds that are decided at the start."""
MOMENTS = ("phase", "order", "place")
"""Kinds that are decided at a moment: what was seen before a run broke off was seen."""
CHECKS = {name: check for part in PARTS for name, check in part.CHECKS.items()}


def evaluate(requirements: Iterable[Requirement], facts: RunFacts, trajectories: Trajectories,
             counterfactual: Run | None = None) -> tuple[Result, ...]:  # fmt: skip
    """One result for each requirement, in their order.

    `counterfactual`: the same scene with ego's reaction switched off; without it, what needs it cannot be judged.
    """
    without = Evidence(counterfactual.facts, counterfactual.trajectories) if counterfactual else None
    evidence = Evidence(facts, trajectories, without)
    return tuple(_judged(r, evidence) for r in requirements)


def whole(results: Sequence[Result]) -> bool:
    """Whether everything that is required was seen. What could not be judged was not seen."""
    return bool(results) and all(r.holds for r in results)


def majority(runs: Sequence[Sequence[Result]]) -> tuple[Result, ...]:
    """One result for each requirement over several runs: that of most runs, shown by the run nearest to its middle."""
    return tuple(_of_most(list(column)) for column in zip(*runs, strict=True))


def _judged(requirement: Requirement, evidence: Evidence) -> Result:
    if not evidence.facts.objects:
        why = evidence.facts.reason or "the run did not begin"
        return unknown(requirement, requirement.text, f"not judged: {why}")
    result = CHECKS[requirement.check](requirement, evidence)
    if evidence.facts.ran or (result.holds and requirement.kind in SO_FAR):
        return result
    if result.holds is False and requirement.kind in (*SO_FAR, "natural", "rules", "limit"):
        return result
    seen_first = result.holds and requirement.kind in MOMENTS
    return result if seen_first else unknown(requirement, result.said, f"not judged: {_broke_off(evidence.facts)}")


def _broke_off(facts: RunFacts) -> str:
    return f"the run stopped early, after {facts.duration:.1f} s ({facts.reason or facts.ended_by})"


def _of_most(column: list[Result]) -> Result:
    holding = [r for r in column if r.holds]
    failing = [r for r in column if r.holds is False]
    unknown = [r for r in column if r.holds is None]
    chosen = holding if 2 * len(holding) > len(column) else failing or unknown
    chosen.sort(key=lambda r: r.robustness or 0.0)
    return chosen[len(chosen) // 2]
