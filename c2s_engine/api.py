"""The facade that the command line, the app and the benchmark use. Imports neither torch, lancedb nor scenic."""

import time
from collections.abc import AsyncGenerator, Callable, Sequence
from contextlib import aclosing, suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from c2s_engine.check.client import CheckClient
from c2s_engine.check.protocol import CheckReport, CheckRequest, Limits, PlacesRequest, Upto
from c2s_engine.config import Settings
from c2s_engine.maps.library import SHIPPED, MapFile, MapLibrary, MapNotFound
from c2s_engine.session.places import DEFAULT_MAP
from c2s_engine.session.steps import Tools, silent
from c2s_engine.structure.components import ComponentId, Structure, Unmet
from c2s_engine.structure.diagnostics import StageResult
from c2s_engine.structure.edits import Edit, apply
from c2s_engine.structure.facts import RunFacts, Trajectories
from c2s_engine.structure.measures import Measures, SeedResult
from c2s_engine.structure.program import FragmentSpan, Program, assemble, run_limit
from c2s_engine.structure.progress import Finished, Progress, Say
from c2s_engine.structure.requirements import Requirement, Result

if TYPE_CHECKING:
    from c2s_engine.interpret.learned import Read
    from c2s_engine.session.other_drivers import OtherDriver
    from c2s_engine.session.requiring import Judged
    from c2s_engine.structure.offers import Offer

RUNNER = "c2s_engine.dryrun.runner:run_scene"


class Engine:
    """One per process: `async with Engine() as engine`. The check server starts first, the rest when it is needed."""

    def __init__(self, settings: Settings | None = None, apart: bool = False):
        """`apart`: read texts in a process of its own, for a front that draws meanwhile."""
        self.settings = settings or Settings()
        self.library = MapLibrary(self.settings.map_folders, self.settings.carla_root)
        self.check_client = CheckClient(runner=RUNNER)
        self.tools = Tools(self.settings, self.library, self.check_client)
        self._retrieval: Any = None
        self.tools.extra["retrieval"] = self.retrieval
        if apart:
            from c2s_engine.session.reader import Reader

            self.tools.extra["reader"] = Reader()
        self._graph: Any = None
        self._expected = False

    async def __aenter__(self) -> "Engine":
        await self.start()
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.close()

    async def start(self) -> None:
        await self.check_client.start()
        if reader := self.tools.extra.get("reader"):
            await reader.start()

    async def close(self) -> None:
        await self.check_client.close()
        if reader := self.tools.extra.get("reader"):
            await reader.close()
        if self._retrieval is not None:
            await self._retrieval.close()

    # Turns.

    async def generate(
        self,
        text: str,
        *,
        method: str | None = None,
        map: str | None = None,
        seed: int = 0,
        run: bool = True,
        runs: int | None = None,
        trajectories: bool = False,
        improve: bool | None = None,
        own: Structure | None = None,
        strict: bool = False,
        widen: bool = False,
    ) -> AsyncGenerator[Progress, None]:
        """A new scenario from a text, with the code by hand of `own` kept in it. The last event is Finished.

        `widen`: what the text left open is varied as far as at least 90 % of the sampled scenes show what is required.
        `strict`: refuse a place that no map (or not the one given) has, rather than leave some of its fields open.
        `improve`: whether a model is told what the run did not show, to change S (default: as the settings say)."""
        kept = own.model_dump(mode="json") if own is not None else {}
        inputs: dict[str, Any] = {"text": text, "own": kept, "structure": {}, "edits": [], "improve": improve}
        inputs |= {"strict": strict, "widen": widen}
        async with aclosing(self.turn(inputs, method, map, seed, run, runs, trajectories)) as events:
            async for event in events:
                yield event

    async def apply(
        self,
        structure: Structure,
        edits: Sequence[Edit],
        *,
        method: str | None = None,
        map: str | None = None,
        seed: int = 0,
        run: bool = True,
        runs: int | None = None,
        trajectories: bool = False,
        improve: bool | None = None,
    ) -> AsyncGenerator[Progress, None]:
        """Edits of S: only what they make dirty is written anew. Raises EditError where one cannot be made."""
        after = structure
        for edit in edits:
            after = apply(after, edit)
        edits, replies = await self.reworded(structure, edits)
        for reply in replies:
            yield Say(text=reply)
        inputs = {
            "text": "",
            "structure": structure.model_dump(mode="json"),
            "edits": [e.model_dump(mode="json") for e in edits],
            "improve": improve,
        }
        async with aclosing(self.turn(inputs, method, map, seed, run, runs, trajectories)) as events:
            async for event in events:
                yield event

    async def realise(
        self, structure: Structure, *, method: str | None = None, map: str | None = None, seed: int = 0,
        runs: int | None = None, trajectories: bool = False,
    ) -> AsyncGenerator[Progress, None]:  # fmt: skip
        """A program for an S that somebody else made: placed, written, run and judged as one read from a text."""
        inputs = {"text": "", "given": True, "structure": structure.model_dump(mode="json"), "edits": []}
        async with aclosing(self.turn(inputs, method, map, seed, True, runs, trajectories)) as events:
            async for event in events:
                yield event

    async def reworded(self, structure: Structure, edits: Sequence[Edit]) -> tuple[list[Edit], list[str]]:
        """The edits with what new sentences of components mean for their fields, and what to say of it."""
        from c2s_engine.session.wording import reworded

        return await reworded(structure, edits, self.tools)

    async def say(
        self, structure: Structure | None, text: str, *, method: str | None = None, **options: Any
    ) -> AsyncGenerator[Progress, None]:
        """A turn of the chat upon S: a question, an edit, or a new scenario."""
        from c2s_engine.session.talk import say

        async with aclosing(say(self, structure, text, method=method, **options)) as events:
            async for event in events:
                yield event

    async def turn(
        self,
        inputs: dict[str, Any],
        method: str | None,
        map: str | None,
        seed: int,
        run: bool,
        runs: int | None,
        trajectories: bool,
        graph: Any = None,
        config: dict[str, Any] | None = None,
    ) -> AsyncGenerator[Progress, None]:
        """One passage through the graph (the session's, where it gives its own)."""
        started = time.perf_counter()
        state: dict[str, Any] = {}
        inputs = {
            **inputs,
            "method": method or self.settings.method,
            "map": map,
            "seed": seed,
            "runs": runs or self.settings.runs,
            "upto": "run" if run else "sample",
            "trajectories": trajectories,
            "program": {},
            "report": {},
            "requirements": [],
            "results": [],
            "measures": [],
            "rewritten": [],
            "stages": [],
            "details": {},
            "places": 0,
            "stop": False,
            "improve": self.settings.improve if inputs.get("improve") is None else inputs["improve"],
        }
        await self._expect(map)
        graph = graph or self.graph()
        stream = graph.astream(inputs, config, stream_mode=["custom", "values"], durability="exit" if config else None)
        async with aclosing(stream) as items:
            async for mode, item in items:
                if mode == "custom":
                    yield item
                else:
                    state = item
        yield finished(state, time.perf_counter() - started)

    async def _expect(self, map: str | None) -> None:
        """At the first turn, let the check server read the likely map while the rest is imported and interpreted."""
        if self._expected:
            return
        self._expected = True
        for name in (map, self.settings.map, DEFAULT_MAP, SHIPPED):
            if name and await self.warm(name):
                return

    async def warm(self, map: str) -> bool:
        """Have the check server read a map that is likely to be used next; whether there is such a map."""
        with suppress(MapNotFound):
            await self.check_client.expect(self.library.working_copy(self.library.find(map)))
            return True
        return False

    def graph(self) -> Any:
        """The graph without a checkpointer."""
        if self._graph is None:
            from c2s_engine.session.graph import build_graph

            self._graph = build_graph(self.tools)
        return self._graph

    # Single services.

    async def check(
        self,
        program: str,
        *,
        spans: Sequence[FragmentSpan] = (),
        upto: Upto = "sample",
        seed: int = 0,
        runs: int = 1,
        seconds: float | None = None,
        trajectories: bool = False,
        trust: bool = False,
        folder: str | None = None,
        filename: str = "program.scenic",
        map: str | None = None,  # noqa: A002
        model: str | None = None,
        scenario: str | None = None,
        limits: Limits | None = None,
    ) -> CheckReport:
        """Check any program; on `map` (a name or a file) and with `model` where they are given, whatever it names.
        Of several modular scenarios `scenario` is meant.

        Raises MapNotFound.
        """
        params = {"map": str(self.library.working_copy(self.library.find(map)))} if map else {}
        return await self.check_client.check(
            CheckRequest(
                program=program,
                spans=tuple(spans),
                upto=upto,
                seed=seed,
                runs=runs,
                seconds=seconds or run_limit(program, self.settings.seconds),
                trajectories=trajectories,
                trust=trust,
                folder=folder,
                filename=filename,
                params=params,
                model=model,
                scenario=scenario,
                allow=self.settings.allow,
                limits=limits or Limits(),
            )
        )

    async def judge(
        self, structure: Structure | None, report: CheckReport, *, seed: int = 0
    ) -> "Judged":
        """What S requires, what the report's runs (with trajectories) showed of it, and their measures; nothing where
        nothing ran. Without a structure only the measures."""
        from c2s_engine.session.requiring import Judged, judged, runs_of

        if structure is None:
            return Judged(runs=tuple(runs_of(report)))

        chosen = self.library.named_in(structure.settings.code) or self.library.find(SHIPPED)
        return await judged(structure, report, self.tools, map_name=chosen.name, seed=seed)

    async def other_drivers(
        self, structure: Structure, *, map: str, room: float = 1.0, seed: int = 0
    ) -> "tuple[OtherDriver, ...]":
        """The scene with two other drivers in ego's place, one that never reacts and one that is slower: what of the
        others' doings is seen then, too. Raises MapNotFound."""
        from c2s_engine.session.other_drivers import with_other_drivers

        return await with_other_drivers(structure, self.tools, map_name=map, room=room, seed=seed)

    async def contradictions(
        self, structure: Structure, *, map: str, room: float = 1.0, seed: int = 0
    ) -> AsyncGenerator["Offer", None]:
        """Where not all that S requires is shown: the numbers of the text that contradict one another, each with a
        value that alone would do, as soon as it is found (some seconds each). Raises MapNotFound."""
        from c2s_engine.session.contradictions import contradictions

        async with aclosing(contradictions(structure, self.tools, map_name=map, room=room, seed=seed)) as found:
            async for offer in found:
                yield offer

    async def read(self, text: str, emit: Callable[[Progress], None] = silent) -> Structure:
        """S of a text as the learned reader reads it, without the planner; a model that is served is not asked. `emit`
        gets what is to be said of it. Raises Unreadable."""
        return (await self.reading(text, emit)).structure

    async def reading(self, text: str, emit: Callable[[Progress], None] = silent) -> "Read":
        """The same S with the model's answer."""
        from c2s_engine.session.methods import ReaderMethod

        method = ReaderMethod(self.tools)
        found: Read = await method.read(text, emit)
        return replace(found, structure=found.structure.model_copy(update={"read_by": method.name}))

    async def without_effect(
        self, text: str, structure: Structure, before: Structure | None = None
    ) -> tuple[Unmet, ...]:
        """The phrases of a text (S's own, or a change of `before` that made S what it is) of which nothing is in what S
        says."""
        from c2s_engine.session.no_effect import without_effect

        return await without_effect(text, structure, self.tools, before)

    def gaps(self, ways: Trajectories) -> dict[str, list[float]]:
        """By each other's name, m between its box and ego's (bumper to bumper) at each step of a run."""
        from c2s_engine.require.measured import gaps

        return gaps(ways)

    async def seeds(
        self, structure: Structure, program: Program, numbers: Sequence[int], **options: Any
    ) -> AsyncGenerator[SeedResult, None]:
        """Run a program once with each seed and judge it by S: a row as soon as a run is done. `options`: `check`'s."""
        from c2s_engine.session.seeds import seeds

        async with aclosing(seeds(self, structure, program, numbers, **options)) as rows:
            async for row in rows:
                yield row

    async def import_program(
        self, text: str, filename: str = "program.scenic", folder: Path | None = None
    ) -> Structure:
        """S of any Scenic driving program; raises CheckError where it cannot be parsed. `folder`: where it lies, with
        the map that it names."""
        found = await self.check_client.import_program(text, filename)
        assert found.structure is not None
        beside = self.library.beside(text, folder) if folder is not None else None
        return found.structure.with_spec("G", map=str(beside)) if beside is not None else found.structure

    def reach(self, structure: Structure, edit: Edit) -> list[ComponentId]:
        """What an edit will make dirty, before it is made (with the typed writer)."""
        from c2s_engine.session.places import map_choice
        from c2s_engine.structure.regenerate import reach
        from c2s_engine.write.typed import TypedWriter

        chosen = self.library.named_in(structure.settings.code) or self.library.find(SHIPPED)
        return reach(structure, edit, TypedWriter(map_choice(self.library, chosen)))

    def maps(self) -> tuple[MapFile, ...]:
        return self.library.list()

    async def doctor(self) -> list[dict[str, Any]]:
        """What is installed, reachable and missing: name, ok, optional, found, advice."""
        from c2s_engine.doctor import examine

        return await examine(self.settings)

    async def survey(self, map_file: MapFile) -> dict[str, int]:
        """How many places of each kind a map has."""
        from c2s_engine.maps.expressions import survey

        path = self.library.working_copy(map_file)
        report = await self.check_client.places(PlacesRequest(map=str(path), expressions=survey()))
        return dict(report.counts)

    async def search(self, query: str, *, kind: str = "doc", component: str | None = None, limit: int = 5) -> list[Any]:
        """Passages or snippets near to a query."""
        return await (await self.retrieval()).search(query, kind=kind, component=component, limit=limit)

    async def snippets(self, structure: Structure) -> list[Any]:
        """(component, words, snippets) for what no field of S can say: to be asked after a turn, never during it."""
        from c2s_engine.session.offers import snippets

        return await snippets(structure, await self.retrieval()) if self.settings.offers else []

    async def retrieval(self) -> Any:
        """The retrieval worker's client, started when first needed."""
        if self._retrieval is None:
            from c2s_engine.retrieve.client import RetrievalClient

            self._retrieval = RetrievalClient(model=self.settings.embedding_model)
        return self._retrieval

    def model_client(self) -> Any:
        """A client for the settings' model at Ollama; raises BadSettings."""
        from c2s_engine.session.model_tools import client_for

        return client_for(self.settings)


def finished(state: dict[str, Any], seconds: float) -> Finished:
    """The last event of a turn, from the graph's final state."""
    structure = Structure.model_validate(state.get("structure") or {})
    program = Program.model_validate(state["program"]) if state.get("program") else assemble(structure)
    stages = tuple(StageResult.model_validate(s) for s in state.get("stages", []))
    report = state.get("report") or {}
    facts = tuple(RunFacts.model_validate(f) for f in report.get("facts", []))
    details = {
        **(state.get("details") or {}),
        "rewritten": state.get("rewritten", []),
        "places": state.get("places", 0),
        "map": state.get("map_name"),
        "room": state.get("room", 1.0),
        "folder": state.get("folder"),
        "iterations": report.get("iterations", []),
        "isolation": report.get("isolation", ""),
    }
    ok = bool(stages) and all(s.ok for s in stages) and bool(program.text)
    return Finished(
        ok=ok,
        structure=structure,
        program=program,
        stages=stages,
        facts=facts,
        requirements=tuple(Requirement.model_validate(r) for r in state.get("requirements", [])),
        results=tuple(Result.model_validate(r) for r in state.get("results", [])),
        measures=tuple(Measures.model_validate(m) for m in state.get("measures", [])),
        seconds=round(seconds, 3),
        details=details,
    )
