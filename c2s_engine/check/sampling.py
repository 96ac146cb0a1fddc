"""Sampling scenes within bounds, and saying what stood in the way."""

import time
from collections import Counter
from typing import Any

from c2s_engine.check import diagnose, warm
from c2s_engine.check.naming import Names
from c2s_engine.structure.diagnostics import Diagnostic


class _Stopped(Exception):
    """The bound on iterations or time was reached."""


class Sampler:
    """Draws scenes as Scenic does (same random numbers), and counts what was rejected by what."""

    def __init__(self, scenario: Any, program: diagnose.Program, limits: dict[str, Any], names: Names) -> None:
        from scenic.core import scenarios
        from scenic.core.sample_checking import WeightedAcceptanceChecker

        self.scenario, self.program, self.limits, self.names = scenario, program, limits, names
        self.counts: Counter[Any] = Counter()
        self.messages: Counter[str] = Counter()
        self.iterations = 0
        self.deadline = 0.0
        outer = self

        class Checker(WeightedAcceptanceChecker):
            def updateMetrics(self, req: Any, new_metrics: tuple[int, float]) -> None:
                if not new_metrics[0]:
                    outer.counts[req] += 1
                super().updateMetrics(req, new_metrics)

        checker = scenario.checker
        if isinstance(checker, WeightedAcceptanceChecker):
            scenario.setSampleChecker(Checker(checker.bufferSize))
        scenarios.optionallyDebugRejection = self._rejected

    def _rejected(self, error: Any = None) -> None:
        self.iterations += 1
        if error is not None:
            self.messages[str(error) or "a value could not be drawn"] += 1
        if self.iterations >= self.limits["iterations"] or time.monotonic() > self.deadline:
            raise _Stopped

    def sample(self, seed: int) -> tuple[Any, int, list[Diagnostic]]:
        """A scene (or None), the iterations that it took, and why there is none."""
        self.counts.clear()
        self.messages.clear()
        self.iterations = 0
        begun = time.monotonic()
        self.deadline = begun + self.limits["sample_seconds"]
        warm.reseed(seed)
        try:
            scene, iterations = self.scenario.generate(maxIterations=float("inf"))
            return scene, iterations, []
        except _Stopped:
            return None, self.iterations, [self._explain(time.monotonic() - begun)]
        except BaseException as error:
            return None, self.iterations + 1, [diagnose.diagnose(error, "sample", self.program)]

    def _explain(self, seconds: float) -> Diagnostic:
        reasons: list[tuple[int, str, int | None]] = []
        for req, count in self.counts.items():
            line = getattr(req, "line", None)
            reasons.append((count, f"{req.violationMsg}", line))
        reasons += [(count, message, None) for message, count in self.messages.items()]
        reasons.sort(key=lambda r: -r[0])
        said = "; ".join(f"{count} x {text}" for count, text, _ in reasons[:4])
        diagnostic = Diagnostic(
            stage="sample",
            code="rejection",
            message=f"no scene was found in {self.iterations} iterations ({seconds:.1f} s): {said}",
            line=reasons[0][2] if reasons else None,
        )
        return self.program.locate(diagnostic)
