"""A scripted engine with the facade's face: real S, specs, edits and regeneration; words, checks and runs by script."""

import asyncio
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

from c2s_engine.check.protocol import CheckReport
from c2s_engine.require import evaluate, require
from c2s_engine.require.measured import gaps, measured
from c2s_engine.session.citing import uncited
from c2s_engine.structure.components import Assumption, Component, Link, Structure, Unmet
from c2s_engine.structure.diagnostics import Diagnostic, StageResult, TextEdit
from c2s_engine.structure.edits import Replace, apply, references
from c2s_engine.structure.facts import ContactFact, Course, EventFact, ObjectFacts, RunFacts, Track, Trajectories
from c2s_engine.structure.measures import SeedResult
from c2s_engine.structure.offers import Offer
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import (
    ComponentState,
    Finished,
    Passage,
    ProgramChanged,
    Progress,
    RunDone,
    Say,
    StageDone,
    StageStarted,
    StructureChanged,
    Token,
    Usage,
)
from c2s_engine.structure.regenerate import dirty, reach, regenerate
from c2s_engine.structure.specs import (
    Condition,
    EgoSpec,
    ObjectSpec,
    Phase,
    Placement,
    PlaceSpec,
    RestrictionsSpec,
    SettingsSpec,
    Trigger,
)

CUT_IN = (
    "Ego drives at 50 km/h in the right lane of a two-lane road in the rain. A van in the left lane cuts in 15 m ahead."
)


def cut_in() -> Structure:
    """The S that the script reads from CUT_IN."""

    def link(words: str) -> tuple[Link, ...]:
        at = CUT_IN.find(words)
        return (Link(kind="text", label=words, span=(at, at + len(words))),)

    return Structure(
        text=CUT_IN,
        settings=Component(
            id="G", description="It rains.", spec=SettingsSpec(weather=("rain",)), links=link("in the rain"),
            assumed=(Assumption(field="time", value="day", reason="the text names no time"),),
        ),
        place=Component(
            id="R", description="The right lane of a two-lane road.", spec=PlaceSpec(lanes=2, ego_lane="rightmost"),
            links=link("the right lane of a two-lane road"),
        ),
        ego=Component(
            id="E", description="Ego drives at 50 km/h.", spec=EgoSpec(speed=13.8889, reaction="brake"),
            links=link("Ego drives at 50 km/h"),
        ),
        objects=(
            Component(
                id="O1", description="A van in the left lane cuts in ahead of ego.",
                spec=ObjectSpec(
                    name="van", type="van", placement=Placement(position="left_lane", gap=15.0),
                    speed=(9.7222, 11.1111),
                    phases=(
                        Phase(action="cut_in", side="right", trigger=Trigger(kind="distance", value=15.0, of="ego")),
                    ),
                ),
                links=link("A van in the left lane cuts in 15 m ahead"),
                assumed=(Assumption(field="speed", value="35-40 km/h", reason="slower than ego"),),
            ),
        ),
        restrictions=Component(
            id="T", description="The run ends after the van has cut in.",
            spec=RestrictionsSpec(terminate_when=(Condition(kind="time", minimum=20.0),)),
        ),
        not_understood=(Unmet(text="two-lane", reason="whether both lanes lead one way is left open"),),
    )  # fmt: skip


class Writer:
    """Renders a fragment from its spec; enough of Scenic to look at."""

    def config(self) -> dict[str, Any]:
        return {"writer": "scripted"}

    def reads(self, structure: Structure, cid: str) -> frozenset[str]:
        own = {"E": {"R"}, "T": {"E"}}.get(cid, {"E"} if cid.startswith("O") else set())
        return frozenset(own | {r for r in references(structure[cid]) if r in structure})

    def inputs(self, structure: Structure, cid: str) -> Any:
        return [structure[o].spec.model_dump(mode="json").get("speed") for o in sorted(self.reads(structure, cid))]

    def write(self, structure: Structure, cid: str) -> Component:
        component = structure[cid]
        body = getattr(self, f"_{component.kind.lower()}")(component)
        code = f"## {cid}: {component.description}\n{body}"
        return component.model_copy(update={"code": code, "origin": "rendered", "conflict": None})

    def _g(self, component: Component) -> str:
        weather = "HardRainNoon" if "rain" in component.spec.weather else "ClearNoon"
        return f"param map = localPath('town.xodr')\nmodel scenic.simulators.carla.model\nparam weather = '{weather}'\n"

    def _r(self, component: Component) -> str:
        return f"places = [s for s in network.laneSections if len(s.group.lanes) >= {component.spec.lanes or 1}]\n" \
               "place = Uniform(*places)\n"  # fmt: skip

    def _e(self, component: Component) -> str:
        return (
            f"behavior EgoBehavior():\n    try:\n        do FollowLaneBehavior(target_speed={component.spec.speed})\n"
            "    interrupt when withinDistanceToAnyObjs(self, 10):\n        take SetBrakeAction(0.8)\n\n"
            "ego = new Car on place.centerline,\n    with behavior EgoBehavior()\n"
        )

    def _o(self, component: Component) -> str:
        spec = component.spec
        return (
            f"behavior {spec.name.title()}Behavior():\n    while (distance from self to ego) > {spec.placement.gap}:\n"
            f"        wait\n    do LaneChangeBehavior(place.lane)\n\n"
            f"{spec.name} = new {spec.type.title()} left of ego by 3.5,\n"
            f"    with behavior {spec.name.title()}Behavior()\n"
        )

    def _t(self, component: Component) -> str:
        return "require ego can see van\nterminate after 20 seconds\n"


@dataclass
class Script:
    """What the engine says to a text, in events; `gate` names an event that must be set before it goes on."""

    read: Callable[[Structure], Structure] | None = None
    events: tuple[Progress, ...] = ()
    fail: str = ""


@dataclass
class ScriptedEngine:
    """The facade's face over scripts; `gate` holds a turn between its words and its writing until it is set."""

    scripts: dict[str, Script] = field(default_factory=dict)
    gate: asyncio.Event | None = None
    gated_at: str = ""  # "say", "write" or "run"
    broken_code: str = "VanBehaviour"  # a program that contains it does not compile
    passages: list[Passage] = field(default_factory=list)
    calls: list[tuple[str, Any]] = field(default_factory=list)
    seen: bool = True
    collides: bool = False
    idle: tuple[Unmet, ...] = ()
    library: Any = field(default_factory=lambda: SimpleNamespace(folder_of=lambda program: None))
    settings: Any = field(default_factory=lambda: SimpleNamespace(model=None))
    model_list: list[dict[str, Any]] | Exception = field(default_factory=list)

    async def start(self) -> None: ...

    async def close(self) -> None: ...

    async def say(self, structure: Structure, text: str, **options: Any) -> AsyncIterator[Progress]:
        self.calls.append(("say", text))
        script = self.scripts.get(uncited(text)[0].strip())
        if script is None:
            yield Say(text="That is not understood: describe who drives where, and what happens.", severity="error")
            yield Finished(ok=False, structure=structure, program=assemble(structure), details={"unchanged": True})
            return
        for event in script.events:
            yield event
        await self._wait("say")
        if script.fail:
            raise RuntimeError(script.fail)
        if script.read is None:
            yield Finished(ok=True, structure=structure, program=assemble(structure), details={"unchanged": True})
            return
        yield StageStarted(stage="interpret")
        yield StageDone(result=StageResult(name="interpret", ok=True, seconds=0.01))
        async for event in self._write(structure, [Replace(structure=script.read(structure))]):
            yield event

    async def apply(self, structure: Structure, edits: Any, **options: Any) -> AsyncIterator[Progress]:
        self.calls.append(("apply", [e.kind for e in edits]))
        async for event in self._write(structure, list(edits)):
            yield event

    async def _write(self, before: Structure, edits: list[Any]) -> AsyncIterator[Progress]:
        writer, after = Writer(), before
        for edit in edits:
            after = apply(after, edit)
        yield StructureChanged(structure=after)
        for cid in dirty(after, writer):
            yield ComponentState(component=after[cid], state="writing")
        await self._wait("write")
        yield StageStarted(stage="write")
        done, written = regenerate(before, edits, writer)
        for cid in written:
            yield ComponentState(component=done[cid], state="clean")
        program = assemble(done)
        yield StageDone(result=StageResult(name="write", ok=True, seconds=0.02))
        yield ProgramChanged(program=program, rewritten=tuple(written))
        report = await self.check(program.text, spans=program.spans, upto="run")
        for stage in report.stages:
            yield StageDone(result=stage)
        facts: tuple[RunFacts, ...] = ()
        requirements, results = (), ()
        if report.ok:
            facts = report.facts
            requirements, results = self._judged(done, report)
            yield RunDone(facts=facts[0], trajectories=report.trajectories[0])
        await self._wait("run")
        yield Finished(
            ok=report.ok, structure=done, program=program, stages=(StageResult(name="write", ok=True), *report.stages),
            facts=facts, requirements=requirements, results=results,
            measures=_measures(report), seconds=0.42,
        )  # fmt: skip

    async def check(self, program: str, *, spans: Any = (), upto: str = "sample", **options: Any) -> CheckReport:
        self.calls.append(("check", upto))
        stages = [StageResult(name="parse", ok=True, seconds=0.01), StageResult(name="safety", ok=True)]
        lines = program.splitlines()
        bad = next((i for i, line in enumerate(lines, 1) if self.broken_code in line), None)
        if bad:
            at = next((s.component for s in spans if s.first <= bad <= s.last), None)
            right = lines[bad - 1].replace("VanBehaviour", "VanBehavior")
            found = Diagnostic(
                stage="compile", code="name", message="the name VanBehaviour is not defined", component=at, line=bad,
                fix="VanBehavior is defined above: use that name",
                edit=TextEdit(first=bad, last=bad, text=right, reason="a name that is defined"),
            )  # fmt: skip
            return CheckReport(stages=(*stages, StageResult(name="compile", ok=False, diagnostics=(found,))))
        stages.append(StageResult(name="compile", ok=True, seconds=0.05))
        if upto in ("sample", "run"):
            stages.append(StageResult(name="sample", ok=True, seconds=0.08))
        if upto != "run":
            return CheckReport(stages=tuple(stages))
        stages.append(StageResult(name="run", ok=True, seconds=0.2))
        facts = run_facts(self.seen, self.collides)
        return CheckReport(stages=tuple(stages), facts=(facts,), trajectories=(trajectories(),))

    async def judge(self, structure: Structure, report: CheckReport, **options: Any) -> Any:
        if not report.facts:
            return SimpleNamespace(requirements=(), results=(), measures=())
        requirements, results = self._judged(structure, report)
        return SimpleNamespace(requirements=requirements, results=results, measures=_measures(report))

    @staticmethod
    def _judged(structure: Structure, report: CheckReport) -> tuple[tuple[Any, ...], Any]:
        requirements = tuple(r for r in require(structure) if r.kind in ("phase", "outcome"))
        return requirements, evaluate(requirements, report.facts[0], report.trajectories[0])

    async def warm(self, map: str) -> bool:  # noqa: A002
        return False

    async def reworded(self, structure: Structure, edits: Any) -> tuple[list[Any], list[str]]:
        return list(edits), []

    async def snippets(self, structure: Structure) -> list[Any]:
        return []

    def gaps(self, ways: Trajectories) -> dict[str, list[float]]:
        return gaps(ways)

    async def seeds(self, structure: Structure, program: Any, chosen: Any, **options: Any) -> AsyncIterator[SeedResult]:
        """Every third fails; at the gate the series waits after its second row."""
        for seed in chosen:
            if seed == 2:
                await self._wait("seeds")
            missed = ("O1 (van) cuts in. Required: cut in; the run: nothing of it.",) if seed % 3 == 2 else ()
            yield SeedResult(seed=seed, ran=True, ended="time", duration=20.0, met=2 - len(missed), required=2,
                             unmet=missed, gap_m=4.2 + seed, ttc_s=2.5)  # fmt: skip

    async def contradictions(self, structure: Structure, **options: Any) -> AsyncIterator[Offer]:
        """Two numbers; at the gate it waits after the first."""
        yield Offer(component="E", field="speed", said="50 km/h", value="70 km/h", amount=19.4)
        await self._wait("contradictions")
        yield Offer(component="O1", field="placement.gap", said="5 m", value="20 m", amount=20.0)

    async def without_effect(
        self, text: str, structure: Structure, before: Structure | None = None
    ) -> tuple[Unmet, ...]:
        return self.idle

    def reach(self, structure: Structure, edit: Any) -> list[str]:
        return reach(structure, edit, Writer())

    async def search(self, query: str, **options: Any) -> list[Passage]:
        self.calls.append(("search", query))
        return self.passages

    async def import_program(self, text: str, filename: str = "", folder: object = None) -> Structure:
        structure = Structure(arrangement=(("E", text),))
        for component in structure.components:
            code = text if component.id == "E" else ""
            own = component.model_copy(update={"code": code, "origin": "imported"})
            structure = structure.with_component(own)
        return structure

    def maps(self) -> list[Any]:
        return [SimpleNamespace(name="town", path="town.xodr"), SimpleNamespace(name="Town05", path="Town05.xodr")]

    async def doctor(self) -> list[dict[str, Any]]:
        return [
            {"name": "scenic", "ok": True, "found": "3.1.1", "advice": ""},
            {"name": "ollama", "ok": False, "optional": True, "found": "no answer", "advice": "start it: ollama serve"},
        ]

    def model_client(self) -> Any:
        return ScriptedModels(self.model_list)

    async def _wait(self, where: str) -> None:
        if self.gate is not None and self.gated_at == where:
            while not self.gate.is_set():  # set from another thread's loop
                await asyncio.sleep(0.01)


class ScriptedModels:
    """The part of the model client that the app asks."""

    def __init__(self, answer: list[dict[str, Any]] | Exception):
        self.answer = answer

    async def __aenter__(self) -> "ScriptedModels":
        return self

    async def __aexit__(self, *_: object) -> None: ...

    async def models(self) -> list[dict[str, Any]]:
        if isinstance(self.answer, Exception):
            raise self.answer
        return self.answer

    async def pull(self, name: str) -> AsyncIterator[tuple[str, int, int]]:
        yield "pulling", 50, 100
        yield "success", 100, 100


def _measures(report: CheckReport) -> tuple[Any, ...]:
    return tuple(measured(f, w) for f, w in zip(report.facts, report.trajectories, strict=True))


def run_facts(seen: bool, collides: bool = False) -> RunFacts:
    """A run in which the van cut in (or did not), and ego ran into it (or did not)."""
    events = (EventFact(event="cut_in", time=4.2, other="ego"),) if seen else ()
    return RunFacts(
        seed=0, duration=20.0, ended_by="terminated", contacts=(HIT,) if collides else (),
        objects=(
            ObjectFacts(name="ego", component="E", types=("car", "vehicle"), length=4.5, width=2.0, moves=True),
            ObjectFacts(name="van", component="O1", types=("van", "vehicle"), length=5.4, width=2.0, moves=True,
                        events=events),
        ),
    )  # fmt: skip


HIT = ContactFact(time=6.3, one="ego", other="van", part_one="front", part_other="rear", closing=2.8)


def trajectories() -> Trajectories:
    """Two cars northwards, one changing lanes."""
    steps = range(101)
    ego = Track(
        name="ego", x=tuple(0.0 for _ in steps), y=tuple(1.39 * i for i in steps), heading=tuple(0.0 for _ in steps),
        speed=tuple(13.9 for _ in steps), length=4.5, width=2.0, kind="car",
    )  # fmt: skip
    van = Track(
        name="van", x=tuple(-3.5 + 3.5 * min(1.0, max(0.0, (i - 30) / 20)) for i in steps),
        y=tuple(20 + 1.1 * i for i in steps), heading=tuple(-0.1 if 30 < i < 50 else 0.0 for i in steps),
        speed=tuple(11.0 for _ in steps), length=5.4, width=2.0, kind="van",
        course=Course(every=0.2, aside=tuple(-3.5 * min(1.0, max(0.0, (i - 30) / 20)) for i in steps[::2])),
    )  # fmt: skip
    left, right = (((x, -30.0), (x + 3.4, -30.0), (x + 3.4, 200.0), (x, 200.0)) for x in (-5.2, -1.7))
    return Trajectories(step=0.1, tracks=(ego, van), outline={"lane": (left, right)})


def describing() -> dict[str, Script]:
    """The script for CUT_IN and for a question, with streaming."""
    return {
        CUT_IN: Script(
            read=lambda _: cut_in(),
            events=(
                Say(text="R is the right lane of a two-lane road; E brakes when O1, a van, cuts in."),
                Passage(
                    kind="doc",
                    title="UN R157",
                    clause="Annex 5, 4.5",
                    score=0.81,
                    source="un-r157.md",
                    component="O",
                    text="A vehicle in the neighbouring lane cuts in ahead of the ALKS vehicle at a small distance.",
                ),
            ),
        ),
        "What is a cut-in?": Script(
            events=(
                Token(text="A **cut-in** is a lane change into "),
                Token(text="ego's lane, *ahead* of ego and within 50 m.\n\n- O1 does it here\n"),
                Usage(purpose="answer", prompt_tokens=812, answer_tokens=24, seconds=0.5),
            )
        ),
    }
