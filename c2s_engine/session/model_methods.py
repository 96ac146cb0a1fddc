"""The methods that use a language model (or a retriever) behind the graph's face: tools, events, tokens."""

import time
from collections.abc import Sequence
from typing import Any

from c2s_engine.check.protocol import CheckReport, CheckRequest, Upto
from c2s_engine.session.methods import Interpreted, Written
from c2s_engine.session.places import map_choice, resolve
from c2s_engine.session.steps import Emit, Tools, timed
from c2s_engine.structure.components import Structure
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.program import FragmentSpan, assemble
from c2s_engine.structure.progress import ProgramChanged, StageDone, StageStarted, Usage
from c2s_engine.write.typed import TypedWriter


def model_method(name: str, tools: Tools) -> "ModelMethod":
    """The method of that name; raises UnknownMethod, or ModelNotSet where it needs a model and none is set."""
    from c2s_engine.write.methods import names

    known = set(names()) | {"nl2scenic"} | {f"{n}+repair" for n in names() if n.startswith("chat2scenic")}
    if name not in known:
        from c2s_engine.write.methods import UnknownMethod

        raise UnknownMethod(f"There is no method {name}; there are {', '.join(names())}.")
    return ModelMethod(name, tools)


class ModelMethod:
    """One of `write.methods`, with the engine's check server, maps and retriever as its tools."""

    def __init__(self, name: str, tools: Tools):
        self.name, self.tools = name, tools
        self.tokens = 0
        self.needs_place = name in ("typed", "mixed")

    async def interpret(self, text: str, structure: Structure, emit: Emit) -> Interpreted:
        from c2s_engine.models.errors import ModelError

        emit(StageStarted(stage="interpret"))
        started = time.perf_counter()
        try:
            async with self._client(emit) as client:
                method = self._method(client, None, None)
                reading = await method.interpret(text, self._counting(emit))
        except ModelError as error:
            result = timed("interpret", started, (Diagnostic(stage="interpret", message=str(error), code="model"),))
            emit(StageDone(result=result))
            return None, [], {"tokens": self.tokens}, result
        result = timed("interpret", started)
        emit(StageDone(result=result))
        details = {"tokens": self.tokens, "fallbacks": len(reading.fallbacks), "share": round(reading.share, 3)}
        return reading.structure.model_copy(update={"text": text}), [], details, result

    async def write(self, structure: Structure, emit: Emit, *, map_name: str, room: float, folder: str) -> Written:
        from c2s_engine.models.errors import ModelError

        emit(StageStarted(stage="write"))
        started = time.perf_counter()
        writer = TypedWriter(map_choice(self.tools.library, self.tools.library.find(map_name)), room=room)
        try:
            async with self._client(emit) as client:
                after = await self._method(client, writer, folder).write(structure, self._counting(emit))
        except (ModelError, ValueError) as error:
            result = timed("write", started, (Diagnostic(stage="write", message=str(error), code="model"),))
            emit(StageDone(result=result))
            return structure, assemble(structure), [], result
        program = assemble(after)
        before = {c.id: c.code for c in structure.components}
        written = [c.id for c in after.components if before.get(c.id) != c.code]
        result = timed("write", started)
        emit(StageDone(result=result))
        emit(ProgramChanged(program=program, rewritten=tuple(written)))
        return after, program, written, result

    def _counting(self, emit: Emit) -> Emit:
        def on_event(event: Any) -> None:
            if isinstance(event, Usage):
                self.tokens += event.prompt_tokens + event.answer_tokens
            emit(event)

        return on_event

    def _client(self, emit: Emit) -> Any:
        from c2s_engine.models.client import OllamaClient
        from c2s_engine.models.settings import ModelSettings, default_host

        return OllamaClient(ModelSettings(host=default_host(), model=self.tools.settings.model or ""))

    def _method(self, client: Any, writer: TypedWriter | None, folder: str | None) -> Any:
        from c2s_engine.check.fixes import apply_fixes
        from c2s_engine.interpret import EmbeddedInterpreter
        from c2s_engine.write.methods import MethodTools, method

        async def check(program: str, spans: Sequence[FragmentSpan], upto: Upto) -> CheckReport:
            request = CheckRequest(program=program, spans=tuple(spans), upto=upto, folder=folder)
            return await self.tools.check.check(request)

        async def places(structure: Structure) -> Diagnostic | None:
            found = await resolve(structure, self.tools.library, self.tools.check, default=self.tools.settings.map)
            return found.diagnostic

        retrieval = self.tools.extra.get("retrieval")

        async def search(query: str, *, kind: str = "doc", component: str | None = None, limit: int = 3) -> list[Any]:
            if retrieval is None:
                return []
            return await (await retrieval()).search(query, kind=kind, component=component, limit=limit)

        async def embed(texts: Sequence[str]) -> list[list[float]]:
            if retrieval is None:
                raise ValueError("no retrieval worker is at hand")
            return await (await retrieval()).embed(list(texts))

        return method(
            self.name,
            MethodTools(
                embedded=EmbeddedInterpreter(),
                client=client,
                search=search,
                embed=embed,
                check=check if folder else None,
                fix=apply_fixes,
                resolve=places,
                writer=writer,
            ),
        )
