"""A changed S that was written, checked and run beside the turn's own: shown and kept only where it is better."""

from dataclasses import dataclass
from typing import Any

from c2s_engine.check.protocol import CheckReport
from c2s_engine.session.requiring import Judged
from c2s_engine.session.steps import Emit
from c2s_engine.structure.components import Structure
from c2s_engine.structure.diagnostics import StageResult
from c2s_engine.structure.program import Program
from c2s_engine.structure.progress import ProgramChanged, RunDone, StageDone, StructureChanged


@dataclass(frozen=True)
class Tried:
    """A changed S, written, checked and run; `where`: what the graph's state says of its map."""

    structure: Structure
    program: Program
    written: list[str]
    stages: list[StageResult]
    report: CheckReport
    judged: Judged
    where: dict[str, Any]

    def show(self, emit: Emit, tracks: bool = True) -> None:
        """The events that were held back; with the runs' trajectories where `tracks`."""
        emit(StructureChanged(structure=self.structure))
        emit(ProgramChanged(program=self.program, rewritten=tuple(self.written)))
        for stage in (*self.stages, *self.report.stages):
            emit(StageDone(result=stage))
        for i, facts in enumerate(self.report.facts):
            ways = self.report.trajectories[i] if tracks and i < len(self.report.trajectories) else None
            emit(RunDone(facts=facts, trajectories=ways))

    def update(self, state: dict[str, Any], upto: tuple[str, ...] = ("interpret",)) -> dict[str, Any]:
        """Its part of the graph's state; of the stages so far those in `upto` stand."""
        before = [s for s in state["stages"] if s["name"] in upto]
        stages = [s.model_dump(mode="json") for s in (*self.stages, *self.report.stages)]
        return {
            "structure": self.structure.model_dump(mode="json"),
            "program": self.program.model_dump(mode="json"),
            "rewritten": list(dict.fromkeys([*state.get("rewritten", []), *self.written])),
            "report": self.report.model_dump(mode="json", exclude={"trajectories"}),
            "stages": [*before, *stages],
            **self.judged.as_state(),
            **self.where,
        }
