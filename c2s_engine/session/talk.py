"""A turn of the chat upon S: questions are answered with sources, changes become edits, the rest is a new scenario.

`engine` is the facade (`c2s_engine.api.Engine`), which a room below it cannot import.
"""

from collections.abc import AsyncIterator
from typing import Any

from c2s_engine.structure.components import Structure
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Finished, Passage, Progress, Say


async def say(
    engine: Any, structure: Structure | None, text: str, *, method: str | None = None, **options: Any
) -> AsyncIterator[Progress]:
    """The events of the turn; the last is Finished. Undo and redo belong to a session and are only said here."""
    from c2s_engine.interpret.turn import route

    current = structure or Structure()
    turn = route(text, structure)
    if turn.kind == "scenario":
        async for event in engine.generate(text, method=method, **options):
            yield event
        return
    if turn.kind == "edit" and turn.edits:
        if turn.reply:
            yield Say(text=turn.reply)
        async for event in engine.apply(current, turn.edits, method=method, **options):
            yield event
        return
    if turn.kind == "question":
        async for event in answer(engine, text):
            yield event
    elif turn.reply:
        yield Say(text=turn.reply)
    else:
        sentence = "That was not understood as a change: name the component, the field and the value."
        yield Say(text=sentence, severity="warning")
    yield Finished(ok=True, structure=current, program=assemble(current), details={"turn": turn.kind})


async def answer(engine: Any, question: str) -> AsyncIterator[Progress]:
    """The passages that answer a question, or that there is none."""
    from c2s_engine.retrieve.errors import RetrievalError

    wants_code = any(w in question.lower() for w in ("show me", "snippet", "scenarios like", "example of", "code"))
    try:
        found: list[Passage] = await engine.search(question, kind="snippet" if wants_code else "doc", limit=3)
    except RetrievalError as error:
        yield Say(text=str(error), severity="error")
        return
    if not found:
        yield Say(text="Nothing in the documents answers that. Add some with `c2s index add FILE`.", severity="warning")
        return
    for passage in found:
        yield passage
    sources = "; ".join(f"{p.title}{f' ({p.clause})' if p.clause else ''}" for p in found)
    yield Say(text=f"From: {sources}.")
