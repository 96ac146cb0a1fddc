"""Sampling scenes within bounds, and saying what stood in the way."""

import re
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
        self.drawn: Any = None
        self.messages: Counter[str] = Counter()
        self.iterations = 0
        self.deadline = 0.0
        outer = self

        class Checker(WeightedAcceptanceChecker):
            def checkRequirementsInner(self, sample: Any) -> Any:
                outer.drawn = sample
                return super().checkRequirementsInner(sample)

            def updateMetrics(self, req: Any, new_metrics: tuple[int, float]) -> None:
                if not new_metrics[0]:
                    outer.counts[outer._key(req)] += 1
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
        reasons = [(count, *self._reason(req)) for req, count in self.counts.items()]
        reasons += [
            (count, f"a value could not be drawn ({said})", None, "draw") for said, count in self.messages.items()
        ]
        merged: Counter[tuple[str, int | None, str]] = Counter()
        for count, text, line, kind in reasons:
            merged[text, line, kind] += count
        ranked = merged.most_common(4)
        said = "; ".join(f"{count} times {text}" for (text, _, _), count in ranked)
        (_, line, kind), _ = ranked[0] if ranked else (("", None, "draw"), 0)
        diagnostic = Diagnostic(
            stage="sample",
            code=f"rejected_{kind}",
            message=f"no scene was found in {self.iterations} tries ({seconds:.1f} s): {said}",
            fix=RELAX["speed" if kind == "requirement" and _of_speed(self.program.line(line)) else kind],
            line=line,
        )
        return self.program.locate(diagnostic)

    def _key(self, req: Any) -> Any:
        """What a rejection is counted under: the requirement, or the two objects that a collision was found for."""
        pair = getattr(req, "_collidingObjects", None)
        if not pair:
            return req
        return tuple(o for o in req.objects if any(self.drawn[o] is p for p in pair))

    def _reason(self, req: Any) -> tuple[str, int | None, str]:
        """What a requirement rejects, in words; the line to look at; the kind of requirement."""
        from scenic.core import requirements as r

        if isinstance(req, tuple):
            return self._overlap(list(req))
        if isinstance(req, r.IntersectionRequirement):
            return self._overlap([req.objA, req.objB])
        if isinstance(req, r.ContainmentRequirement):
            what = self.names.label(req.obj)
            return f"{what} was not wholly within its region (the road, by default)", self._line(req.obj), "containment"
        if isinstance(req, r.VisibilityRequirement | r.NonVisibilityRequirement):
            word = "hidden" if isinstance(req, r.VisibilityRequirement) else "visible"
            return f"{self.names.label(req.target)} was {word}", self._line(req.target), "visibility"
        line = getattr(req, "line", None)
        text = self.program.line(line).strip()
        return f"the requirement of line {line} did not hold ({text})", line, "requirement"

    def _overlap(self, objects: list[Any]) -> tuple[str, int | None, str]:
        labels = sorted(self.names.label(o) for o in objects)
        lines = [n for n in map(self._line, objects) if n is not None]
        return f"{' and '.join(labels)} overlapped", max(lines, default=None), "overlap"

    def _line(self, obj: Any) -> int | None:
        return self.names.lines.get(id(obj))


def _of_speed(line: str) -> bool:
    """Whether a requirement on the scene asks that something moves."""
    return bool(re.match(r"\s*require\s+(?!always|eventually|monitor)[^#]*\.speed\s*>=?\s*[\d.]*[1-9]", line))


RELAX = {
    "speed": "objects do not move while a scene is sampled: check speeds in the run "
             "('require eventually', 'terminate when')",
    "requirement": "weaken that requirement, or place the objects so that it holds more often",
    "overlap": "place them further apart, or let one of them have 'with allowCollisions True'",
    "containment": "place it where it fits, choose a wider lane or a longer road, or add 'with regionContainedIn None'",
    "visibility": "place it within the view of the other, or leave the condition on its visibility out",
    "draw": "draw only from elements of the map that have what is asked for (filter them first)",
}
