"""The typed events that the facade yields while it works (an async iterator; cancelling it stops the work)."""

from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field

from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.diagnostics import Diagnostic, StageName, StageResult
from c2s_engine.structure.facts import RunFacts, Trajectories
from c2s_engine.structure.measures import Measures
from c2s_engine.structure.program import Program
from c2s_engine.structure.requirements import Requirement, Result


class _Progress(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class StageStarted(_Progress):
    type: Literal["stage_started"] = "stage_started"
    stage: StageName
    run: int = Field(0, description="which of its runs begins, where it has several")
    most: int = Field(0, description="how many of them there may be")

    @property
    def runs(self) -> str:
        """` (run 3 of at most 12)`; empty where there are none."""
        return f" (run {self.run} of at most {self.most})" if self.run else ""


class StageDone(_Progress):
    type: Literal["stage_done"] = "stage_done"
    result: StageResult


class Token(_Progress):
    """A piece of a model's answer, as it streams; `component` where it writes one."""

    type: Literal["token"] = "token"
    text: str
    component: ComponentId | None = None
    thinking: bool = False


class Usage(_Progress):
    """Tokens and seconds of one model call (the ledger's row)."""

    type: Literal["usage"] = "usage"
    purpose: str
    component: ComponentId | None = None
    prompt_tokens: int = 0
    answer_tokens: int = 0
    seconds: float = 0.0


class ComponentState(_Progress):
    type: Literal["component"] = "component"
    component: Component
    state: Literal["dirty", "writing", "clean", "failed", "by_hand"]


class StructureChanged(_Progress):
    type: Literal["structure"] = "structure"
    structure: Structure


class ProgramChanged(_Progress):
    """A newly assembled program, and which components were written anew for it."""

    type: Literal["program"] = "program"
    program: Program
    rewritten: tuple[ComponentId, ...] = ()


class RunDone(_Progress):
    """One rollout of the dry run."""

    type: Literal["run"] = "run"
    facts: RunFacts
    trajectories: Trajectories | None = None


class Passage(_Progress):
    """A retrieved passage or snippet: an answer's source."""

    type: Literal["passage"] = "passage"
    kind: Literal["snippet", "doc"]
    title: str
    text: str
    score: float
    source: str = ""
    clause: str = ""
    component: str = ""
    id: str = Field("", description="of the snippet or chunk in its store")
    page: int | None = None
    ranks: dict[str, int] = Field({}, description="its rank (from 1) in each list that held it: embedding, bm25")


class Say(_Progress):
    """A sentence for the user: what was understood, changed, refused; an answer."""

    type: Literal["say"] = "say"
    text: str
    severity: Literal["info", "warning", "error"] = "info"


class Finished(_Progress):
    """The end of a turn: everything as it now stands."""

    type: Literal["finished"] = "finished"
    ok: bool
    structure: Structure
    program: Program
    stages: tuple[StageResult, ...] = ()
    facts: tuple[RunFacts, ...] = ()
    requirements: tuple[Requirement, ...] = ()
    results: tuple[Result, ...] = ()  # one for each requirement: what most runs showed; none where nothing ran
    measures: tuple[Measures, ...] = ()  # one a run that has tracks
    seconds: float = 0.0
    details: dict[str, Any] = {}

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        return tuple(d for s in self.stages for d in s.diagnostics)


Progress = Annotated[
    StageStarted | StageDone | Token | Usage | ComponentState | StructureChanged | ProgramChanged
    | RunDone | Passage | Say | Finished,
    Field(discriminator="type"),
]  # fmt: skip
