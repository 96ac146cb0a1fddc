"""A turn of the chat upon S: questions are answered with sources, changes become edits, the rest is a new scenario.
"""

from collections.abc import AsyncGenerator, Sequence
from contextlib import aclosing
from typing import Any

from c2s_engine.config import METHOD, WITHOUT_MODEL
from c2s_engine.retrieve.provenance import attribution
from c2s_engine.session.asked import HELP, answered, wants_help
from c2s_engine.session.citing import description_of, kept, tells_scenario, wanted
from c2s_engine.session.facade import Facade
from c2s_engine.session.glossary import meaning
from c2s_engine.session.reader import route
from c2s_engine.session.steps import Emit
from c2s_engine.session.streams import Result, streamed
from c2s_engine.session.why import explained
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import RemoveObject
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Finished, Passage, Progress, Say, Usage
from c2s_engine.write.by_hand import OWN
from c2s_engine.write.prompted.influence import label

SHOWN = 3
"""Passages that answer a question."""
WHOLE = ("nl2scenic", "chatscene")
"""Methods whose model is given the whole text: a change is told to them as part of it."""


async def say(
    engine: Facade,
    structure: Structure | None,
    text: str,
    *,
    method: str | None = None,
    passages: Sequence[Any] = (),
    last: tuple[str, Structure] | None = None,
    shown: Finished | None = None,
    **options: Any,
) -> AsyncGenerator[Progress, None]:
    """The events of the turn; the last is Finished. Undo and redo belong to a session: what is asked
    for stands in the details as `turn`.

    `passages`: those of the last answer, from which "use 2" picks; `last`: what was typed last, and S before it;
    `shown`: what stands with what its run showed, from which questions about the scene are answered.
    Where the method uses a model, the model reads the turn and answers questions.
    """
    current = structure or Structure()
    name = method or engine.settings.method
    tokens = 0
    turn: Any = None
    async with aclosing(_events(engine, current if structure else None, text, name, passages, last, shown)) as events:
        async for event in events:
            if isinstance(event, _Next):
                turn = event
            else:
                tokens += event.prompt_tokens + event.answer_tokens if isinstance(event, Usage) else 0
                yield event
    if turn.text:
        source = engine.generate(turn.text, method=method, own=turn.own, **options)
    elif turn.edits:
        source = engine.apply(current, turn.edits, method=method, **options)
    else:
        details = {"turn": turn.kind, "unchanged": True, "tokens": tokens, **turn.details}
        yield Finished(ok=True, structure=current, program=assemble(current), details=details)
        return
    async with aclosing(source) as events:
        async for event in events:
            if isinstance(event, Finished):
                total = event.details.get("tokens", 0) + tokens
                event = event.model_copy(update={"details": {**event.details, "turn": turn.kind, "tokens": total}})
                if current.ego.code and _nothing_came(event, turn):
                    event = _as_it_was(event, current)
                    yield Say(text="S and its program stay as they were.", severity="warning")
                elif turn.kind == "scenario" and not _nothing_came(event, turn) and (gone := _replaced(current)):
                    yield Say(text=gone, severity="warning")
                if turn.edits and all(s.ok for s in event.stages if s.name in ("resolve", "write")):
                    yield Say(text=outcome(event, current))
            yield event


def _nothing_came(finished: Finished, turn: "_Next") -> bool:
    """Whether a text could not be read, or a change that is told as part of the text could not be written."""
    failed = {s.name for s in finished.stages if not s.ok}
    return "interpret" in failed or bool(turn.text) and turn.kind == "edit" and bool(failed & {"resolve", "write"})


def _replaced(structure: Structure) -> str:
    """That a text was taken as a new description, and who is gone by that; empty where there was nothing."""
    if structure.blank:
        return ""
    named = [f"{o.id} ({getattr(o.spec, 'name', o.id).replace('_', ' ')})" for o in structure.objects]
    gone = f"{', '.join(named[:-1])} and {named[-1]}" if len(named) > 1 else "".join(named) or "what was there"
    return f"Taken as a new description: it replaces {gone}; undo brings {'them' if len(named) > 1 else 'it'} back."


def _own_code(structure: Structure | None) -> str:
    """What is asked before a new description takes the place of code that the user wrote; empty where there is none."""
    own = [c.id for c in structure.components if c.origin in OWN and c.code] if structure is not None else []
    if not own:
        return ""
    whose = f"{', '.join(own)} {'have' if len(own) > 1 else 'has'} code of yours"
    return f"This reads as a new description, and {whose}: send it once more to replace all, or start a new session."


def _as_it_was(finished: Finished, structure: Structure) -> Finished:
    """The end of a turn that failed before anything came of it."""
    details = {**finished.details, "unchanged": True}
    return finished.model_copy(update={"structure": structure, "program": assemble(structure), "details": details})


class _Next:
    """What a turn leads to: a text to generate from, edits to make, or (neither) nothing more."""

    def __init__(
        self, kind: str, text: str = "", edits: Sequence[Any] = (), own: Structure | None = None, **details: Any
    ):
        self.kind, self.text, self.edits, self.own, self.details = kind, text, list(edits), own, details


def _kept(structure: Structure, edits: Sequence[Any]) -> Structure:
    """The S whose code by hand outlives a change that is told as part of the text: all but the objects it removes."""
    gone = {e.component for e in edits if isinstance(e, RemoveObject)}
    return structure.model_copy(update={"objects": tuple(o for o in structure.objects if o.id not in gone)})


async def _events(
    engine: Facade,
    structure: Structure | None,
    text: str,
    method: str,
    passages: Sequence[Any],
    last: tuple[str, Structure] | None,
    shown: Finished | None,
) -> AsyncGenerator[Any, None]:
    """What is said while the turn is read (and answered, where it is a question); last, what it leads to."""
    if number := wanted(text):
        async with aclosing(_picked(engine, number, passages)) as events:
            async for event in events:
                yield event
        return
    if wants_help(text):
        yield Say(text=HELP)
        yield _Next("question")
        return
    turn: Any = None
    async with aclosing(streamed(lambda emit: _routed(engine, text, structure, method, last, emit))) as routing:
        async for event in routing:
            if isinstance(event, Result):
                turn = event.value
            else:
                yield event
    if turn.kind == "scenario" and (asked := _own_code(structure)) and not (last and last[0] == text):
        yield Say(text=asked, severity="warning")
        yield _Next("question")
    elif turn.kind == "scenario":
        yield _Next("scenario", text=text)
    elif turn.kind == "edit" and turn.edits:
        if turn.reply:
            yield Say(text=turn.reply)
        if structure and structure.text and method.startswith(WHOLE) and engine.settings.model:
            yield _Next("edit", text=f"{structure.text.rstrip()}\n{text}", own=_kept(structure, turn.edits))
        else:
            yield _Next("edit", edits=turn.edits)
    elif turn.kind == "question":
        found: list[Passage] = []
        async with aclosing(answer(engine, text, structure, method, shown)) as events:
            async for event in events:
                if isinstance(event, Passage):
                    found.append(event)
                yield event
        yield _Next("question", passages=kept(found))
    elif turn.kind in ("undo", "redo"):
        yield _Next(turn.kind)
    else:
        sentence = "That was not understood as a change: name the component, the field and the value."
        yield Say(text=turn.reply or sentence, severity="warning")
        yield _Next(turn.kind)


async def _routed(
    engine: Facade,
    text: str,
    structure: Structure | None,
    method: str,
    last: tuple[str, Structure] | None,
    emit: Emit,
) -> Any:
    """How the turn is taken: by the model where the method has one, else by the routing without a model."""
    plain = await route(text, structure, engine.tools, last)
    if structure is None or plain.corrects or not uses_model(engine, method):
        return plain
    from c2s_engine.interpret.learned import learned
    from c2s_engine.interpret.llm.turn import route as route_with_model

    async with engine.model_client() as client:
        return await route_with_model(
            text, structure, client=client, reader=learned, plain=plain, on_event=emit
        )


def uses_model(engine: Facade, method: str) -> bool:
    """Whether a model is at work under the method."""
    return bool(engine.settings.model) and method not in WITHOUT_MODEL


async def _picked(engine: Facade, number: int, passages: Sequence[Any]) -> AsyncGenerator[Any, None]:
    """A passage of the last answer becomes the description."""
    from c2s_engine.retrieve.errors import RetrievalError

    found = [Passage.model_validate(p) for p in passages]
    if not 1 <= number <= len(found):
        said = f"Say which: 1 to {len(found)}." if found else "There is no answer to pick from: ask a question first."
        yield Say(text=said, severity="warning")
        yield _Next("question")
        return
    chosen = found[number - 1]
    if chosen.kind == "snippet":
        said = (
            f"{chosen.title} That is code of {chosen.component}: in the app `/use {number} O1` gives it to O1, "
            "on the command line write it to a file, for `c2s edit SESSION --code O1=FILE`."
        )
        yield Say(text=said, severity="warning")
        yield _Next("question", passages=list(passages))
        return
    try:
        siblings = await engine.search(chosen.title, kind="doc", limit=10)
    except RetrievalError:
        siblings = []
    text = description_of(chosen, siblings)
    yield Say(text=f"Taken as the description: {text}")
    yield _Next("scenario", text=text)


def outcome(finished: Finished, before: Structure) -> str:
    """What an edit made the writer write anew, where code by hand followed it, and what stayed."""
    if [(c.id, c.spec, c.code) for c in before.components] == [
        (c.id, c.spec, c.code) for c in finished.structure.components
    ]:
        return "Nothing was changed: S already says that."
    followed = [c for c in finished.details.get("in_place", []) if c in finished.structure]
    rewritten = finished.details.get("rewritten", [])
    written = [c for c in rewritten if c in finished.structure and c not in followed]
    stayed = [c for c in finished.structure.ids if c not in (*written, *followed)]
    gone = [c.id for c in before.components if c.id not in finished.structure and c.origin in OWN]
    said = [f"Your own code of {' and '.join(gone)} is gone with it: undo brings it back."] if gone else []
    said += [f"Changed in its code: {', '.join(followed)}."] if followed else []
    if written:
        kept = f"; {', '.join(stayed)} stayed as {'they were' if len(stayed) > 1 else 'it was'}" if stayed else ""
        said.append(f"Rewritten: {', '.join(written)}{kept}.")
    return " ".join(said) or "Nothing had to be rewritten."


async def answer(
    engine: Facade, question: str, structure: Structure | None = None, method: str = METHOD,
    shown: Finished | None = None,
) -> AsyncGenerator[Progress, None]:
    """What the run showed, why something is there; else passages, summed up where there is a model."""
    from c2s_engine.retrieve.errors import RetrievalError

    if found_out := answered(question, shown) or meaning(question):
        yield Say(text=found_out)
        return
    if structure is not None and (reason := explained(question, structure)):
        yield Say(text=reason)
        return
    wants_code = any(w in question.lower() for w in ("show me", "snippet", "scenarios like", "example of", "code"))
    try:
        near: list[Passage] = await engine.search(question, kind="snippet" if wants_code else "doc", limit=2 * SHOWN)
    except RetrievalError as error:
        yield Say(text=str(error), severity="error")
        return
    sections: dict[str, Passage] = {}
    for passage in near:
        sections.setdefault(passage.title, passage)
    found = list(sections.values())[:SHOWN]
    if not found:
        yield Say(text="Nothing in the documents answers that. Add some with `c2s index add FILE`.", severity="warning")
        return
    for passage in found:
        yield passage
    owners = (f" [{attribution(p)}]" if attribution(p) else "" for p in found)
    sources = "; ".join(f"{i} {label(p)}{owner}" for i, (p, owner) in enumerate(zip(found, owners, strict=True), 1))
    telling = {p.title for p in near if tells_scenario(p)}
    usable = [i for i, p in enumerate(found, 1) if p.title in telling]
    hint = f" “use {usable[0]}” takes its scenario as the description." if usable else ""
    if not uses_model(engine, method):
        yield Say(text=f"From: {sources}.{hint}")
        return
    async with aclosing(streamed(lambda emit: _in_words(engine, question, found, emit))) as events:
        async for event in events:
            if not isinstance(event, Result):
                yield event
            elif event.value:
                yield Say(text=event.value)
    yield Say(text=f"From: {sources}.{hint}")


async def _in_words(engine: Facade, question: str, found: Sequence[Passage], emit: Emit) -> str:
    """The model's answer from the passages; empty (and said why) where it has none that can be used."""
    from c2s_engine.interpret.llm.answer import answer as answer_with_model
    from c2s_engine.models.errors import ModelError

    try:
        async with engine.model_client() as client:
            return await answer_with_model(question, found, client, emit)
    except ModelError as error:
        emit(Say(text=f"The model could not answer from the passages. {error}", severity="warning"))
        return ""
