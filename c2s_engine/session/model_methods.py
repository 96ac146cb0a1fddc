"""The methods that use a language model (or a retriever) behind the graph's face: tools, events, tokens."""

import time
from collections import Counter
from typing import Any

from c2s_engine.check.client import CheckError
from c2s_engine.models.errors import ModelError
from c2s_engine.session.methods import Interpreted, Written
from c2s_engine.session.model_tools import client_for, method_tools
from c2s_engine.session.places import map_choice
from c2s_engine.session.steps import Emit, Tools, timed
from c2s_engine.structure.components import Structure
from c2s_engine.structure.diagnostics import Diagnostic, StageResult
from c2s_engine.structure.edits import Edit, SetField
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import ProgramChanged, StageDone, StageStarted, Usage
from c2s_engine.structure.sentences import sentence
from c2s_engine.write.loop import Evaluate, Outcome
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
        self.name, self.tools, self.settings = name, tools, tools.settings
        self.usage: Counter[str] = Counter()
        self.needs_place = name in ("typed", "mixed")
        self.reads_sentences = name.startswith(("prompted", "chat2scenic", "chatscene"))

    async def interpret(self, text: str, structure: Structure, emit: Emit) -> Interpreted:
        emit(StageStarted(stage="interpret"))
        started = time.perf_counter()
        try:
            async with client_for(self.settings) as client:
                method = self._method(client, emit)
                reading = await method.interpret(text, self._counting(emit))
        except (ModelError, CheckError, ValueError) as error:
            return None, [], self.account(None), _failed("interpret", started, error, emit)
        result = timed("interpret", started)
        emit(StageDone(result=result))
        structure = reading.structure.model_copy(update={"text": text})
        return structure, [], self.account(None), result

    async def write(
        self, structure: Structure, emit: Emit, *, map_name: str, room: float, folder: str
    ) -> Written:
        emit(StageStarted(stage="write"))
        started = time.perf_counter()
        writer = TypedWriter(map_choice(self.tools.library, self.tools.library.find(map_name)), room=room)
        try:
            async with client_for(self.settings) as client:
                after = await self._method(client, emit, writer, folder).write(structure, self._counting(emit))
        except (ModelError, CheckError, ValueError) as error:
            return structure, assemble(structure), [], _failed("write", started, error, emit)
        program = assemble(after)
        before = {c.id: c.code for c in structure.components}
        written = [c.id for c in after.components if before.get(c.id) != c.code]
        result = timed("write", started)
        emit(StageDone(result=result))
        emit(ProgramChanged(program=program, rewritten=tuple(written)))
        return after, program, written, result

    async def improve(self, structure: Structure, evaluate: Evaluate, emit: Emit) -> Outcome:
        """What the model makes of what a run did not show (write.loop)."""
        from c2s_engine.interpret.learned import learned
        from c2s_engine.write.loop import improve

        async with client_for(self.settings) as client:
            return await improve(
                structure, evaluate, client=client, reader=learned, on_event=self._counting(emit)
            )

    def account(self, structure: Structure | None) -> dict[str, Any]:
        """What it cost so far: tokens, in all and by component ("" : of no single one); of what was written, the share
        of components that are the model's own."""
        cost: dict[str, Any] = {"tokens": self.usage.total(), "usage": dict(self.usage)}
        return cost if structure is None else {**cost, "share": round(share(structure), 3)}

    def described(self, before: Structure, after: Structure) -> list[Edit]:
        """The sentences of what an edit of fields changed, for methods that are told sentences and not fields; who got
        a sentence of the user's keeps it."""
        if not self.reads_sentences:
            return []
        kept = {c.id for c in after.components if c.id in before and before[c.id].description != c.description}
        return [edit for edit in _redescribed(before, after) if getattr(edit, "component", None) not in kept]

    def _counting(self, emit: Emit) -> Emit:
        def on_event(event: Any) -> None:
            if isinstance(event, Usage):
                self.usage[event.component or ""] += event.prompt_tokens + event.answer_tokens
            emit(event)

        return on_event

    def _method(self, client: Any, emit: Emit, writer: TypedWriter | None = None, folder: str | None = None) -> Any:
        from c2s_engine.write.methods import method

        return method(self.name, method_tools(self.tools, client, emit, writer, folder))


def _redescribed(before: Structure, after: Structure) -> list[Edit]:
    """The sentences of the components whose specs changed."""
    edits: list[Edit] = []
    for component in after.components:
        if component.id in before and before[component.id].spec == component.spec or component.id == "T":
            continue
        if (words := sentence(component, after)) != component.description:
            edits.append(SetField(component=component.id, path="description", value=words))
    return edits


def share(structure: Structure) -> float:
    """The share of components, of those that something is said or written of, that no fallback stands in for."""
    told = [c for c in structure.components if c.code or c.description]
    own = [c for c in told if c.code and not any(a.field == "*" for a in c.assumed)]
    return len(own) / len(told) if told else 0.0


def _failed(stage: Any, started: float, error: Exception, emit: Emit) -> StageResult:
    """The stage's result where the model (or what it asked for) stands against going on."""
    code = "model-service" if isinstance(error, ModelError) and error.service else "model"
    if isinstance(error, CheckError):
        code = "check-server"
    result = timed(stage, started, (Diagnostic(stage=stage, message=str(error), code=code),))
    emit(StageDone(result=result))
    return result
