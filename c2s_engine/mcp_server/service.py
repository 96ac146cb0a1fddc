"""The tools over one engine, with progress and cancellation. Needs the package `mcp` (extra `[mcp]`)."""

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import aclosing, asynccontextmanager
from importlib.metadata import version
from pathlib import Path
from typing import Annotated, Any, Literal

import anyio
from mcp.server import MCPServer
from mcp.server.mcpserver import Context
from mcp.server.mcpserver.exceptions import ToolError
from pydantic import Field

from c2s_engine.api import Engine
from c2s_engine.check.protocol import CheckReport
from c2s_engine.commands import show
from c2s_engine.commands.checking import fixed, ran
from c2s_engine.commands.console import InputError, may_save, sentence
from c2s_engine.commands.reading import description, read_program
from c2s_engine.config import Settings
from c2s_engine.maps.library import MapNotFound
from c2s_engine.mcp_server import answers
from c2s_engine.structure.components import Unmet
from c2s_engine.structure.progress import Finished, Passage, Say, StageStarted, Token

INSTRUCTIONS = """c2s turns a description of a driving scenario into a Scenic program that really runs, and keeps text,
structure S (G settings, R place, E ego, O1..N others, T restrictions) and code in step. `generate` makes a program of
a text and runs it; read `assumed`, `not_expressible`, `not_understood` and `required.not_seen` in its answer: they are
what the program lacks of the text. `edit` goes on from there in a session: only what a change reaches is rewritten."""

Text = Annotated[str, Field(description="The description of the scenario, in plain words.")]
Program = Annotated[str | None, Field(description="The text of a Scenic program; or give `file`.")]
File = Annotated[str | None, Field(description="Path of a .scenic file, from where the server was started.")]
Map = Annotated[str | None, Field(description="A map by name or .xodr path; none: the program's own.")]
Method = Annotated[str | None, Field(description="reader (none served), typed, mixed, prompted; none: as configured.")]
Seed = Annotated[int, Field(description="Of the sampled scene.")]
Runs = Annotated[int, Field(ge=1, le=50, description="Rollouts of the dry run.")]
Output = Annotated[str | None, Field(description="Save the program to that .scenic file, map and library beside it.")]


class Teller:
    """Sends what the engine is doing as progress notifications, and keeps the notes for the answer."""

    def __init__(self, context: Context) -> None:
        self.context, self.steps, self.pieces = context, 0, 0
        self.notes: list[str] = []
        self._sending: set[asyncio.Task[None]] = set()

    async def say(self, message: str) -> None:
        self.steps += 1
        await self.context.report_progress(self.steps, message=message)

    def send(self, message: str) -> None:
        """As `say`, for callers that cannot wait."""
        self._sending.add(task := asyncio.create_task(self.say(message)))
        task.add_done_callback(self._sending.discard)

    async def event(self, event: Any) -> None:
        """An event of the facade; of a model's answer every hundredth piece is told."""
        if isinstance(event, StageStarted):
            await self.say(event.stage)
        elif isinstance(event, Say):
            self.notes.append(event.text)
            await self.say(event.text)
        elif isinstance(event, Token):
            self.pieces += 1
            if self.pieces % 100 == 1:
                await self.say(f"the model answers: {self.pieces} pieces")

    async def finish(self, events: AsyncIterator[Any]) -> tuple[Finished | None, list[Passage]]:
        """Go through a turn's events to the last; with the passages that answered a question."""
        done, passages = None, []
        async with aclosing(events) as stream:  # type: ignore[type-var]
            async for event in stream:
                if isinstance(event, Finished):
                    done = event
                elif isinstance(event, Passage):
                    passages.append(event)
                else:
                    await self.event(event)
        return done, passages


class Service:
    """One engine behind the tools; calls are carried out one after the other."""

    def __init__(self, settings: Settings) -> None:
        self.engine = Engine(settings, apart=True)
        self._turn = asyncio.Lock()

    async def _work(self, work: Callable[[], Awaitable[dict[str, Any]]]) -> dict[str, Any]:
        """Do it in a task of its own: a cancelled request cancels that once, and waits until it has put things away."""

        async def in_turn() -> dict[str, Any]:
            async with self._turn:
                return await work()

        task = asyncio.create_task(in_turn())
        try:
            return await asyncio.shield(task)
        except asyncio.CancelledError:
            task.cancel()
            with anyio.CancelScope(shield=True):
                await asyncio.wait({task})
            raise
        except Exception as error:
            if (said := sentence(error)) is None:
                raise
            raise ToolError(said[0]) from None

    async def generate(
        self, text: Text, context: Context, method: Method = None, map: Map = None, seed: Seed = 0, runs: Runs = 1,
        strict: Annotated[bool, Field(description="Refuse a place that the map lacks.")] = False, output: Output = None,
    ) -> dict[str, Any]:  # fmt: skip
        """Turn a description of a driving scenario into a Scenic program, compile and run it (without CARLA)."""

        async def work() -> dict[str, Any]:
            may_save(output)
            teller, words = Teller(context), description(text)
            options = {"method": method, "map": map, "seed": seed, "runs": runs, "strict": strict}
            done, _ = await teller.finish(self.engine.generate(words, **options))  # type: ignore[arg-type]
            assert done is not None
            idle = await self._idle(self.engine.without_effect(words, done.structure))
            return {**answers.scenario(done, output, idle), "notes": teller.notes}

        return await self._work(work)

    async def interpret(self, text: Text) -> dict[str, Any]:
        """Only read a description: the structure S that it gives, and what became of each clause."""

        async def work() -> dict[str, Any]:
            words = description(text)
            found = await self.engine.read(words)
            return answers.structure(found, await self.engine.without_effect(words, found))

        return await self._work(work)

    async def check(
        self, context: Context, program: Program = None, file: File = None, map: Map = None, seed: Seed = 0,
        fix: Annotated[bool, Field(description="Also give the program with the certain fixes applied.")] = False,
    ) -> dict[str, Any]:  # fmt: skip
        """Check any Scenic program: syntax, safety, compile, sample; where and why it fails, and what would mend it."""

        async def work() -> dict[str, Any]:
            text, folder, name = self._program(program, file)

            async def checked(text: str) -> CheckReport:
                return await self.engine.check(text, seed=seed, folder=folder, filename=name, map=map)

            await Teller(context).say("check")
            answer = answers.report(await checked(text))
            if fix:
                mended, count = await fixed(text, checked)
                answer |= {"fixes": count, **({"fixed_program": mended} if count else {})}
            return answer

        return await self._work(work)

    async def run(
        self, context: Context, program: Program = None, file: File = None, map: Map = None, seed: Seed = 0,
        runs: Runs = 1,
        seconds: Annotated[float, Field(gt=0, le=600, description="Simulated seconds a rollout at most.")] = 20.0,
    ) -> dict[str, Any]:  # fmt: skip
        """Run a Scenic program without CARLA: the events of each rollout, and what is required of them."""

        async def work() -> dict[str, Any]:
            text, folder, name = self._program(program, file)
            await Teller(context).say("run")
            found = await ran(self.engine, text, folder, name, seed, runs=runs, seconds=seconds, map=map)
            seen = answers.required(found.requirements, found.results)
            return {
                **answers.report(found.report),
                "events": show.events_as_dicts(found.report.facts),
                "required": seen,
            }

        return await self._work(work)

    async def edit(
        self, context: Context, session: Annotated[str, Field(description="Its name.")],
        new: Annotated[bool, Field(description="Make the session where there is none of that name.")] = False,
        say: Annotated[str | None, Field(description="A scenario, a change of it, or a question, in words.")] = None,
        set: Annotated[dict[str, Any] | None, Field(description='Fields of S, such as {"O1.speed": 10} (SI).')] = None,
        remove: Annotated[list[str] | None, Field(description="Objects to remove, such as O2.")] = None,
        program: Annotated[str | None, Field(description="Take this Scenic program as the session's first.")] = None,
        undo: Annotated[bool, Field(description="Go back to before the last turn, before anything else.")] = False,
        method: Method = None, seed: Seed = 0, output: Output = None,
    ) -> dict[str, Any]:  # fmt: skip
        """Work on a named session: say something, set fields of S, remove objects, undo; gives where it stands then."""

        async def work() -> dict[str, Any]:
            from c2s_engine.commands.sessions import edits_of, field_edit, known, state_of
            from c2s_engine.session.sessions import Sessions
            from c2s_engine.structure.edits import Replace

            may_save(output)
            edits = [*(field_edit(name, value) for name, value in (set or {}).items()), *edits_of([], remove or [], [])]
            teller = Teller(context)
            options = {"method": method, "seed": seed}
            if not (new or program):
                known(session, "`new`: true")
            opened = Sessions().open(session, self.engine)
            try:
                done, passages = await teller.finish(opened.undo()) if undo else (None, [])
                if program:
                    taken = Replace(structure=await self.engine.import_program(program))
                    done, _ = await teller.finish(opened.apply([taken], **options))
                if say:
                    done, passages = await teller.finish(opened.say(description(say), **options))
                if edits:
                    done, _ = await teller.finish(opened.apply(edits, **options))
                idle = await self._idle(opened.without_effect())
                told = {**answers.scenario(done or state_of(opened), output, idle), "notes": teller.notes}
                told["passages"] = [answers.passage(p) for p in passages]
                told["turns"] = [t.text or t.summary for t in opened.history]
                return told
            finally:
                opened.close()

        return await self._work(work)

    async def report(
        self, context: Context,
        what: Annotated[str, Field(description="A .scenic file, a session's name, or a YAML list with id and text.")],
        output: Annotated[str, Field(description="The folder to write to.")],
        form: Annotated[Literal["md", "html", "json"], Field(description="What the dossier is written as.")] = "md",
        method: Method = None, seed: Seed = 0,
    ) -> dict[str, Any]:  # fmt: skip
        """Write the dossier: the text, what became of it, what the run shows in pictures and numbers, the program."""

        async def work() -> dict[str, Any]:
            from c2s_engine.commands.report import dossiers

            made = await dossiers(self.engine, what, Path(output), form, method, seed, Teller(context).send)
            return {"written": [{"file": str(file), "problem": material.problem} for material, file in made]}

        return await self._work(work)

    async def search(
        self, context: Context, query: Annotated[str, Field(description="What to look for, in words.")],
        kind: Annotated[Literal["doc", "snippet"], Field(description="Notes on regulations, or code.")] = "doc",
        component: Annotated[Literal["R", "E", "O", "T"] | None, Field(description="Snippets of one only.")] = None,
        limit: Annotated[int, Field(ge=1, le=50, description="At most so many.")] = 5,
    ) -> dict[str, Any]:  # fmt: skip
        """Search notes on regulations and on Scenic, or code snippets; nothing comes where nothing fits."""

        async def work() -> dict[str, Any]:
            if not query.strip():
                raise InputError("The query is empty: say what to look for.")
            wanted, teller = "snippet" if component else kind, Teller(context)
            teller.send("loading the index")
            await (await self.engine.retrieval()).ready(lambda stage, done, of: teller.send(f"{stage} {done} of {of}"))
            found = await self.engine.search(query, kind=wanted, component=component, limit=limit)
            return {"passages": [answers.passage(p) for p in found]}

        return await self._work(work)

    async def _idle(self, looked_for: Awaitable[tuple[Unmet, ...]]) -> tuple[Unmet, ...]:
        """The phrases of a text that make no difference to its S; none of what cannot be read: its turn says so."""
        try:
            return await looked_for
        except ValueError:
            return ()

    def _program(self, program: str | None, file: str | None) -> tuple[str, str | None, str]:
        """(text, folder of its map and what it imports, file name) of a program; raises InputError."""
        if (program is None) == (file is None):
            raise InputError("Give either `program`, the text of a Scenic program, or `file`, its path.")
        if file is not None:
            path = Path(file)
            return read_program(path), str(path.resolve().parent), path.name
        if not (program or "").strip():
            raise InputError("The program is empty: give the text of a Scenic program.")
        try:
            named = self.engine.library.named_in(program or "")
            folder = str(self.engine.library.working_copy(named).parent) if named else None
        except MapNotFound:
            folder = None
        return program or "", folder, "program.scenic"


def server(settings: Settings) -> MCPServer:
    """The server; its engine lives as long as it is run."""
    service = Service(settings)

    @asynccontextmanager
    async def lifespan(_: MCPServer) -> AsyncIterator[None]:
        async with service.engine:
            yield

    made = MCPServer("c2s", version=version("c2s"), instructions=INSTRUCTIONS, lifespan=lifespan, log_level="WARNING")
    for tool in (
        service.generate, service.interpret, service.check, service.run, service.edit, service.report, service.search,
    ):  # fmt: skip
        made.tool()(tool)
    return made
