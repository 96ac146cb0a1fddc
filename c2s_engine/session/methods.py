"""Methods by name: how a text is interpreted and how S is written, behind one face (text -> program)."""

import asyncio
import contextlib
import time
from dataclasses import replace
from typing import Any, Protocol

from c2s_engine.check.protocol import PlacesRequest
from c2s_engine.config import FORMER
from c2s_engine.maps.library import SHIPPED
from c2s_engine.session.places import map_choice
from c2s_engine.session.reader import Unreadable, read
from c2s_engine.session.steps import Emit, Tools, timed, write
from c2s_engine.session.without_contradictions import without_contradictions
from c2s_engine.solve.defaults import with_usual_reaction
from c2s_engine.structure.components import ComponentId, Structure
from c2s_engine.structure.diagnostics import Diagnostic, StageResult
from c2s_engine.structure.edits import Edit
from c2s_engine.structure.program import Program
from c2s_engine.structure.progress import Say, StageDone, StageStarted, Usage
from c2s_engine.write import by_hand
from c2s_engine.write.typed import TypedWriter

Interpreted = tuple[Structure | None, list[Edit], dict[str, Any], StageResult]
Written = tuple[Structure, Program, list[ComponentId], StageResult]


class Method(Protocol):
    """What the graph asks of a method."""

    name: str
    needs_place: bool

    async def interpret(self, text: str, structure: Structure, emit: Emit) -> Interpreted: ...

    async def write(
        self, structure: Structure, emit: Emit, *, map_name: str, room: float, folder: str
    ) -> Written: ...

    def described(self, before: Structure, after: Structure) -> list[Edit]: ...

    def account(self, structure: Structure | None) -> dict[str, Any]: ...


class ReaderMethod:
    """No model that has to be served: the learned reader and the typed writer."""

    name = "reader"
    needs_place = True

    def __init__(self, tools: Tools):
        self.tools, self.tokens = tools, 0

    async def interpret(self, text: str, structure: Structure, emit: Emit) -> Interpreted:
        emit(StageStarted(stage="interpret"))
        started = time.perf_counter()
        warming = asyncio.create_task(_warm(self.tools))
        try:
            found = (await self.read(text, emit)).structure
        except Unreadable as error:
            result = timed("interpret", started, (Diagnostic(stage="interpret", message=str(error), code="text"),))
            emit(StageDone(result=result))
            return None, [], {}, result
        finally:
            warming.add_done_callback(lambda task: task.cancelled() or task.exception())
        found = without_contradictions(found)
        result = timed("interpret", started)
        emit(StageDone(result=result))
        if found.not_understood:
            words = "; ".join(f'"{n.text}"' for n in found.not_understood[:5])
            emit(Say(text=f"Not understood: {words}.", severity="warning"))
        return found, [], self.account(found), result

    async def read(self, text: str, emit: Emit) -> Any:
        """What the learned reader reads of a text (interpret.learned.Read), its S with the reaction that is usual where
        it says none; raises Unreadable."""
        found = await read(text, self.tools)
        answer = found.answer
        self.tokens += answer.prompt_tokens + answer.answer_tokens
        emit(Usage(purpose="read", prompt_tokens=answer.prompt_tokens, answer_tokens=answer.answer_tokens))
        if found.note:
            emit(Say(text=found.note, severity="warning"))
        return replace(found, structure=with_usual_reaction(found.structure))

    async def write(
        self, structure: Structure, emit: Emit, *, map_name: str, room: float, folder: str
    ) -> Written:
        chosen = map_choice(self.tools.library, self.tools.library.find(map_name))
        writer = TypedWriter(chosen, room=room)
        structure, program, written, result = write(structure, [], writer, emit)
        return by_hand.compared(structure, writer), program, written, result

    def described(self, before: Structure, after: Structure) -> list[Edit]:
        """No further edits: fields are all that it reads."""
        return []

    def account(self, structure: Structure | None) -> dict[str, Any]:
        """The tokens that reading took."""
        return {"tokens": self.tokens}


async def _warm(tools: Tools) -> None:
    """Have the check server read the usual map while the text is interpreted."""
    with contextlib.suppress(Exception):
        path = tools.library.working_copy(tools.library.find(SHIPPED))
        await tools.check.places(PlacesRequest(map=str(path), expressions={}))


def method_named(name: str, tools: Tools) -> Method:
    """The method of that name; raises UnknownMethod."""
    if name in (ReaderMethod.name, *FORMER):
        return ReaderMethod(tools)
    from c2s_engine.session.model_methods import model_method

    return model_method(name, tools)
