"""The graph of a session: one run of it is one turn, and leaves one checkpoint.

Its state is plain JSON, so that a checkpoint outlives versions of the classes in it. The steps of a turn are the
engine's own (say, apply); their events are streamed on as they come.
"""

from collections.abc import AsyncIterator
from contextlib import aclosing
from typing import Any, TypedDict

from langgraph.checkpoint.base import BaseCheckpointSaver
from langgraph.config import get_stream_writer
from langgraph.graph import END, START, StateGraph
from langgraph.graph.state import CompiledStateGraph

from c2s_engine.session.facade import Turns
from c2s_engine.session.journal import Pending
from c2s_engine.session.state import State, cleared
from c2s_engine.structure.components import Structure, Unmet
from c2s_engine.structure.progress import Finished


class TurnState(TypedDict, total=False):
    """What a checkpoint holds."""

    request: dict[str, Any]
    last: tuple[str, dict[str, Any]] | None
    idle: list[dict[str, Any]]
    state: dict[str, Any]


def build_turns(engine: Turns, checkpointer: BaseCheckpointSaver) -> CompiledStateGraph:
    """The graph that takes a request upon a state to the next state."""

    async def turn(values: TurnState) -> TurnState:
        write = get_stream_writer()
        before = State.model_validate(values["state"])
        request = Pending.model_validate(values["request"])
        after = before
        async with aclosing(_events(engine, before, request, values)) as events:  # type: ignore[type-var]
            async for event in events:
                if isinstance(event, Finished):
                    after = before.after(event)
                write(event)
        return {"request": {}, "last": None, "idle": [], "state": after.model_dump(mode="json")}

    graph = StateGraph(TurnState)
    graph.add_node("turn", turn)  # type: ignore[call-overload]
    graph.add_edge(START, "turn")
    graph.add_edge("turn", END)
    return graph.compile(checkpointer=checkpointer)


def _events(engine: Turns, before: State, request: Pending, values: TurnState) -> AsyncIterator[Any]:
    structure, last = before.structure, values.get("last")
    if request.kind == "say":
        passages = before.details.get("passages", ())
        typed = (last[0], Structure.model_validate(last[1])) if last else None
        shown = before.finished()
        idle = tuple(map(Unmet.model_validate, values.get("idle", ())))
        shown = shown.model_copy(update={"details": {**shown.details, "without_effect": idle}})
        known = {"passages": passages, "last": typed, "shown": shown}
        return engine.say(structure, request.text, **known, **request.options)
    if request.kind == "regenerate":
        structure = cleared(structure, request.components)
    return engine.apply(structure, list(request.edits), **request.options)
