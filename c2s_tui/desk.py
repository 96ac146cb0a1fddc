"""What lies on the desk: everything the panes draw, as a pure fold over the engine's events."""

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from c2s_engine.check.protocol import CheckReport
from c2s_engine.structure.components import Component, Structure, Unmet
from c2s_engine.structure.diagnostics import Diagnostic, StageResult
from c2s_engine.structure.facts import RunFacts, Trajectories
from c2s_engine.structure.measures import Collision, Measures, SeedResult, collisions
from c2s_engine.structure.program import Program
from c2s_engine.structure.progress import (
    ComponentState,
    Finished,
    ProgramChanged,
    Progress,
    RunDone,
    StageDone,
    StageStarted,
    StructureChanged,
    Usage,
)
from c2s_engine.structure.requirements import Requirement, Result

if TYPE_CHECKING:
    from c2s_engine.session.requiring import Judged
    from c2s_engine.session.session import Session
    from c2s_engine.session.state import State

MEASURED = ("facts", "trajectories", "requirements", "results", "measures")
"""What a run brings."""


@dataclass(frozen=True)
class Desk:
    """The state that all panes share. Times in seconds."""

    structure: Structure = Structure()
    program: Program = Program(text="")
    before: str = ""  # the program before the last change, for the marks of what changed
    states: dict[str, str] = field(default_factory=dict)  # by component: what ComponentState said last
    rewritten: tuple[str, ...] = ()
    stages: tuple[StageResult, ...] = ()
    running: str | None = None  # the stage under way
    facts: tuple[RunFacts, ...] = ()
    trajectories: tuple[Trajectories, ...] = ()
    requirements: tuple[Requirement, ...] = ()
    results: tuple[Result, ...] = ()  # one for each requirement, once something has run
    required_before: tuple[Requirement, ...] = ()  # by the turn before, as the last one began
    text_before: str | None = None  # the description then; None: before any turn
    measures: tuple[Measures, ...] = ()  # one a run
    gaps: dict[str, list[float]] = field(default_factory=dict)  # m to ego at each step of the first run, by name
    seeds: tuple[SeedResult, ...] = ()  # of the series of runs under way, or done last with this program
    planned: int = 0  # seeds in that series
    prompt_tokens: int = 0
    answer_tokens: int = 0
    seconds: float = 0.0
    stale: bool = False  # a turn has begun and not yet measured anything: the verdicts are those before it
    folder: str | None = None  # where the program's map lies
    idle: tuple[Unmet, ...] = ()  # phrases of S's text without which S would be the same, once they were looked for

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        return tuple(d for stage in self.stages for d in stage.diagnostics)

    @property
    def making(self) -> bool:
        """Whether a program is being made or run."""
        return self.running is not None or any(s in ("writing", "dirty") for s in self.states.values())

    @property
    def collisions(self) -> tuple[Collision, ...]:
        """Those of the first run."""
        return collisions(next(iter(self.facts), None), self.requirements, bool(self.structure.text))

    def state(self, component: Component) -> str:
        """clean, dirty, writing, failed, by_hand or conflict."""
        if component.conflict is not None:
            return "conflict"
        said = self.states.get(component.id)
        if said in ("writing", "dirty", "failed"):
            return said
        if any(d.component == component.id and d.severity == "error" for d in self.diagnostics):
            return "failed"
        if component.origin in ("by_hand", "imported"):
            return "by_hand"
        return "clean" if component.code and component.key else "dirty"  # no key: what a turn failed to write


def begun(desk: Desk) -> Desk:
    """A turn begins: what the last one measured stays until this one measures anew."""
    return replace(
        desk, before=desk.program.text, rewritten=(), running=None, stale=True, prompt_tokens=0, answer_tokens=0,
        seconds=0.0, states={}, required_before=desk.requirements or desk.required_before,
        text_before=desk.structure.text,
    )  # fmt: skip


def _fresh(desk: Desk) -> Desk:
    """Without the verdicts of the turn before."""
    if not desk.stale:
        return desk
    empty: dict[str, Any] = dict.fromkeys(("stages", *MEASURED), ())
    return replace(desk, **empty, gaps={}, stale=False)


def _other(desk: Desk, structure: Structure) -> Desk:
    """With another S: what was measured of the one before goes."""
    specs = [c.spec for c in structure.components]
    same = specs == [c.spec for c in desk.structure.components]
    idle = desk.idle if structure.text == desk.structure.text else ()
    return replace(desk if same else _fresh(desk), structure=structure, idle=idle)


def opened(structure: Structure, program: Program) -> Desk:
    """The desk on which a session was laid as it was left."""
    return Desk(structure=structure, program=program, before=program.text)


def broken_off(desk: Desk, session: "Session") -> Desk:
    """A turn was cancelled: S and program are those from before it, and the verdicts on them, where it had begun with
    its own."""
    now, program = session.structure, session.program
    desk = replace(desk, structure=now, program=program, before=program.text, states={}, running=None)
    return desk if desk.stale else replace(restored(desk, session), trajectories=(), gaps={}, seconds=0.0)


def step(desk: Desk, event: Progress) -> Desk:
    """The desk after one event."""
    if isinstance(event, StageStarted):
        return replace(_fresh(desk), running=event.stage)
    if isinstance(event, StageDone):
        desk = _fresh(desk)
        others = tuple(s for s in desk.stages if s.name != event.result.name)
        return replace(desk, stages=(*others, event.result), running=None)
    if isinstance(event, ComponentState):
        structure = desk.structure
        if event.component.id in structure:
            structure = structure.with_component(event.component)
        return replace(desk, structure=structure, states={**desk.states, event.component.id: event.state})
    if isinstance(event, StructureChanged):
        return _other(desk, event.structure)
    if isinstance(event, ProgramChanged):
        same = event.program.text == desk.program.text
        gone: dict[str, Any] = {} if same else {**dict.fromkeys((*MEASURED, "seeds"), ()), "gaps": {}, "planned": 0}
        done = {*desk.rewritten, *event.rewritten}
        rewritten = tuple(cid for cid in desk.structure.ids if cid in done)
        return replace(desk, program=event.program, rewritten=rewritten, **gone)
    if isinstance(event, Usage):
        return replace(
            desk,
            prompt_tokens=desk.prompt_tokens + event.prompt_tokens,
            answer_tokens=desk.answer_tokens + event.answer_tokens,
        )
    if isinstance(event, RunDone):
        trajectories = (*desk.trajectories, event.trajectories) if event.trajectories else desk.trajectories
        return replace(desk, facts=(*desk.facts, event.facts), trajectories=trajectories)
    if isinstance(event, Finished):
        kept = desk.stages if event.details.get("unchanged") else ()
        return replace(
            desk, structure=event.structure, program=event.program, stages=event.stages or kept,
            facts=event.facts or desk.facts, requirements=event.requirements or desk.requirements,
            results=event.results or desk.results, measures=event.measures or desk.measures,
            seconds=event.seconds, running=None, states={},
            folder=event.details.get("folder") or desk.folder,
        )  # fmt: skip
    return desk


def expected(desk: Desk, structure: Structure) -> Desk:
    """S as edits under way will make it: what they touch is dirty until the engine says more."""
    states = {c.id: "dirty" for c in structure.components if c.id not in desk.structure or desk.structure[c.id] != c}
    return replace(_other(desk, structure), states=states)


def as_it_was(desk: Desk, session: "Session") -> Desk:
    """A turn that changed nothing is over: what was measured before it counts again, where the turn has cleared it."""
    if desk.stale or desk.facts or desk.program.text != session.program.text:
        return desk
    return replace(restored(desk, session), stages=desk.stages or session.stages)


def restored(desk: Desk, session: "Session | State") -> Desk:
    """With the verdicts that a session kept."""
    names = ("stages", "facts", "requirements", "results", "measures")
    kept = {name: tuple(getattr(session, name, ())) for name in names}
    return replace(desk, **kept)  # type: ignore[arg-type]


def checked(desk: Desk, report: CheckReport, judged: "Judged") -> Desk:
    """With what a check of the program as it stands has found, and what S requires with what was seen of it."""
    return replace(
        desk, requirements=judged.requirements, results=judged.results, measures=judged.measures, gaps={},
        stages=report.stages, facts=report.facts,
        trajectories=report.trajectories, stale=False, running=None, seconds=sum(s.seconds for s in report.stages),
    )  # fmt: skip
