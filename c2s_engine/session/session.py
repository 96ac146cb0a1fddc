"""One open session: turns upon S that are durable, undone and redone, and what is typed meanwhile."""

import asyncio
import contextlib
import fcntl
import json
import sqlite3
from collections.abc import AsyncIterator, Callable, Iterable, Sequence
from contextlib import aclosing
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from c2s_engine.session.asked import asks_for_account
from c2s_engine.session.errors import SessionError, SessionInUse
from c2s_engine.session.facade import Turns
from c2s_engine.session.files import write_whole
from c2s_engine.session.journal import Drafts, Idle, Journal, Pending, Unread
from c2s_engine.session.state import NOTHING, State, edit_words, futile, summary
from c2s_engine.session.store import Row, Store, TurnRow
from c2s_engine.structure.components import Structure, Unmet
from c2s_engine.structure.diagnostics import StageResult
from c2s_engine.structure.edits import Edit
from c2s_engine.structure.facts import RunFacts
from c2s_engine.structure.measures import Measures
from c2s_engine.structure.program import Program
from c2s_engine.structure.progress import Finished, ProgramChanged, Say, StructureChanged
from c2s_engine.structure.requirements import Requirement, Result

ROOT = "start"
GLANCE = "head.json"
"""The state where a session stands, beside the database, so that it can be shown before LangGraph is imported."""


CORRECTING = 15
"""Words that a turn has at most which corrects the one before."""


@dataclass(frozen=True)
class Turn:
    """One step of a session's history, as the chat shows it."""

    index: int
    kind: str  # say, apply, regenerate
    text: str
    when: float  # s since the epoch
    summary: str
    replies: tuple[str, ...] = ()

    @property
    def asked(self) -> bool:
        """Whether it was a question: something said that changed nothing."""
        return self.kind == "say" and self.summary == NOTHING


class Session:
    """Made by `Sessions.open`. One turn at a time; a cancelled turn leaves everything as it was."""

    def __init__(self, store: Store, row: Row, folder: Path, engine: Turns):
        self._store, self._thread, self._folder, self._engine = store, row.thread, folder, engine
        self.name = row.name
        self._lock = _locked(folder, row.name)
        self._journal = Journal(folder / "journal.jsonl")
        self._drafts = Drafts(folder / "drafts")
        self._idle = Idle(folder / "idle.json")
        self._running = False
        self._same: dict[str, bool] = {}  # by checkpoint: whether its turn left S and the program as they were
        row = store.row(row.name) or row
        self._head, self._redo = row.head, list(row.redo)
        self._state = State() if self._head is None else self._glance(self._head) or self._load(self._head)

    @cached_property
    def _saver(self) -> Any:
        from c2s_engine.session.saver import SessionSaver  # LangGraph: a second, which opening a session does not wait

        return SessionSaver(self._store)

    @cached_property
    def _graph(self) -> Any:
        from c2s_engine.session.turns import build_turns

        return build_turns(self._engine, self._saver)

    @property
    def structure(self) -> Structure:
        return self._state.structure

    @property
    def program(self) -> Program:
        return self._state.program

    @property
    def stages(self) -> tuple[StageResult, ...]:
        return self._state.stages

    @property
    def facts(self) -> tuple[RunFacts, ...]:
        return self._state.facts

    @property
    def requirements(self) -> tuple[Requirement, ...]:
        return self._state.requirements

    @property
    def results(self) -> tuple[Result, ...]:
        return self._state.results

    @property
    def measures(self) -> tuple[Measures, ...]:
        return self._state.measures

    @property
    def details(self) -> dict[str, Any]:
        """The facade's details that outlive a turn: map, folder (where the program's map lies), places."""
        return self._state.details

    @property
    def idle(self) -> tuple[Unmet, ...] | None:
        """The phrases of the text without which S would be the same; None where nobody has looked for them yet."""
        return self._idle.of(self.structure.text)

    async def without_effect(self) -> tuple[Unmet, ...]:
        """These phrases, looked for where nobody has; they are kept. Raises Unreadable."""
        text, found = self.structure.text, self.idle
        if found is None and text:
            found = tuple(await self._engine.without_effect(text, self.structure))
            await asyncio.to_thread(self._idle.keep, text, found)
        return found or ()

    def keep_idle(self, said: str, found: Sequence[Unmet]) -> None:
        """Keep the phrases of a change that made no difference to it."""
        self._idle.keep(said, found)

    def _idle_words(self) -> list[Unmet]:
        """The phrases without effect of the text, and those of the changes that were made of it since (they lie in no
        text of S)."""
        found = list(self.idle or ())
        for turn in self.history:
            if turn.kind == "say" and not turn.asked and turn.text != self.structure.text:
                found += [u.model_copy(update={"span": None}) for u in self._idle.of(turn.text) or ()]
        return found

    @property
    def history(self) -> list[Turn]:
        """The turns that lead here, the first first."""
        path = [t for t in self._path() if t.kind != ROOT]
        return [Turn(i, t.kind, t.text, t.when, t.summary, t.replies) for i, t in enumerate(path)]

    @property
    def undone(self) -> list[Turn]:
        """The turns that were undone and can be brought back, the next one first; they go on counting."""
        turns, first = self._store.turns(self._thread), len(self.history)
        rows = [turns[c] for c in reversed(self._redo) if c in turns]
        return [Turn(first + i, t.kind, t.text, t.when, t.summary, t.replies) for i, t in enumerate(rows)]

    @property
    def conversation(self) -> list[Turn]:
        """The turns that lead here and the texts that led to none (their index is -1), as they were said."""
        unread = [Turn(-1, "say", t.text, t.when, NOTHING, t.replies) for t in self._journal.unread]
        return sorted([*self.history, *unread], key=lambda t: t.when)

    @property
    def typed(self) -> list[str]:
        """The texts of this session in their order, also of turns that were undone or came to nothing."""
        said = {(t.when, t.text) for t in (*self.conversation, *self.undone) if t.kind == "say"}
        return [text for _, text in sorted(said)]

    @property
    def can_undo(self) -> bool:
        return self._last_change(self._path()) > 0

    @property
    def can_redo(self) -> bool:
        turns = self._store.turns(self._thread)
        return any(self._changed(turns[c]) for c in self._redo if c in turns)

    @property
    def pending(self) -> Pending | None:
        """A turn that a crash interrupted; `resume` runs it, `drop_pending` forgets it, another turn replaces it."""
        return None if self._running else self._journal.pending

    def say(self, text: str, **options: Any) -> AsyncIterator[Any]:
        """A chat turn; options are the facade's (method, seed, run). "Undo that" takes the last turn back instead."""
        return self._turn(lambda: self._journal.begin("say", text, options=options))

    def apply(self, edits: Edit | Iterable[Edit], **options: Any) -> AsyncIterator[Any]:
        """Edits of S, by hand or from a pane."""
        made = tuple(edits) if isinstance(edits, Iterable) and not hasattr(edits, "kind") else (edits,)
        said = ", ".join(edit_words(e) for e in made)  # type: ignore[arg-type]
        return self._turn(lambda: self._journal.begin("apply", said, made, options=options))  # type: ignore[arg-type]

    def regenerate(self, components: Iterable[str] = (), **options: Any) -> AsyncIterator[Any]:
        """Write those components anew (default: all that the engine wrote)."""
        chosen = tuple(components)
        said = f"write {', '.join(chosen) or 'all'} anew"
        return self._turn(lambda: self._journal.begin("regenerate", said, components=chosen, options=options))

    def resume(self) -> AsyncIterator[Any]:
        """Run the turn that a crash interrupted."""
        turn = self.pending
        if turn is None:
            raise SessionError("no turn was interrupted")
        return self._turn(lambda: turn)

    def note_sent(self, text: str, **options: Any) -> None:
        """Have on the disk, when this returns, what was sent and is about to be a turn: a crash before that begins
        loses nothing. `drop_pending` takes it back. From any thread, while no turn runs."""
        if not self._running and not self._lock.closed:
            self._journal.begin("say", text, options=options)

    def drop_pending(self) -> None:
        """Forget the turn that a crash interrupted."""
        if turn := self.pending:
            self._journal.end(turn)

    async def undo(self) -> AsyncIterator[Any]:
        """Undo the last turn that changed something, and with it the questions that came after it."""
        self._free()
        path = self._path()
        last = self._last_change(path)
        if not last:
            raise SessionError("there is nothing to undo")
        for event in self._go(path[last - 1].checkpoint, [*self._redo, *(t.checkpoint for t in reversed(path[last:]))]):
            yield event

    async def redo(self) -> AsyncIterator[Any]:
        """Bring back the turn that was undone last, and with it the questions that came after it."""
        self._free()
        turns, ahead = self._store.turns(self._thread), self._redo[::-1]
        changes = [i for i, c in enumerate(ahead) if c in turns and self._changed(turns[c])]
        if not changes:
            raise SessionError("there is nothing to redo")
        upto = changes[1] if len(changes) > 1 else len(ahead)
        for event in self._go(ahead[upto - 1], ahead[upto:][::-1]):
            yield event

    async def back_to(self, index: int) -> AsyncIterator[Any]:
        """Go to where a turn of `history` or `undone` left S, by its index; -1 is before the first. Turns after it are
        undone, and can be brought back."""
        self._free()
        path, ahead = self._path(), self._redo
        place = index + 1  # the root comes first
        if not 0 <= place < len(path) + len(ahead):
            raise SessionError(f"there is no turn {index + 1}: there are {len(path) + len(ahead) - 1}")
        if place < len(path):
            target, redo = path[place].checkpoint, [*ahead, *(t.checkpoint for t in reversed(path[place + 1 :]))]
        else:
            left = len(path) + len(ahead) - 1 - place
            target, redo = ahead[left], ahead[:left]
        for event in self._go(target, redo):
            yield event

    def save_draft(self, pane: str, text: str) -> None:
        """Keep what is typed in a pane and not sent; durable when this returns."""
        self._drafts.save(pane, text)

    def draft(self, pane: str) -> str:
        return self._drafts.load(pane)

    def close(self) -> None:
        """Let other processes open it."""
        if not self._lock.closed:
            self._lock.close()

    async def _turn(self, begin: Callable[[], Pending]) -> AsyncIterator[Any]:
        self._free()
        self._running = True
        turn: Pending | None = None
        finished: Finished | None = None
        said: list[str] = []
        read = False
        try:
            turn = begin()
            if self._head is None:
                self._head = await asyncio.to_thread(self._root)
            if turn.kind == "say" and asks_for_account(turn.text):
                with contextlib.suppress(ValueError, OSError):  # what cannot be read has no phrases
                    await self.without_effect()
            values = {
                "request": turn.model_dump(mode="json"),
                "idle": [u.model_dump(mode="json") for u in self._idle_words()],
                "last": self._last(turn),
                "state": self._state.model_dump(mode="json"),
            }
            stream = self._graph.astream(values, self._config(self._head), stream_mode="custom", durability="exit")
            async with aclosing(stream) as events:  # type: ignore[type-var]
                async for event in events:
                    if isinstance(event, Finished):
                        finished = event
                        continue
                    if isinstance(event, Say):
                        said.append(event.text)
                    yield event
            back = finished.details.get("turn") if finished else None
            if finished and back not in ("undo", "redo") and not futile(finished):
                await asyncio.to_thread(self._commit, turn, finished, tuple(said))
                read = True
            elif finished and futile(finished) and not said:  # why, as the fronts tell it
                said += [d.message for d in finished.diagnostics if d.severity == "error"]
            read = read or back in ("undo", "redo")
        except (asyncio.CancelledError, GeneratorExit):
            said.append("Cancelled; nothing was changed.")
            raise
        except sqlite3.Error as error:
            raise SessionError(f"the session cannot be written ({error}): free some space; S is unchanged") from None
        except OSError as error:
            raise SessionError(f"the turn could not be done ({error}); S is unchanged") from None
        except Exception as error:
            said.append(str(error))
            raise
        finally:
            self._running = False
            if turn:
                lost = not read and turn.kind == "say"
                self._journal.end(turn, Unread(text=turn.text, when=turn.when, replies=tuple(said)) if lost else None)
        path = self._path() if back == "undo" else []
        if last := self._last_change(path):
            yield Say(text=f"Undone: {path[last].text}")
        if back in ("undo", "redo"):
            async with aclosing(self.undo() if back == "undo" else self.redo()) as events:  # type: ignore[type-var]
                async for event in events:
                    yield event
        elif finished:
            yield finished

    def _commit(self, turn: Pending, finished: Finished, said: tuple[str, ...]) -> None:
        """Make the newest checkpoint the head."""
        latest = self._saver.get_tuple({"configurable": {"thread_id": self._thread}})
        assert latest
        after = self._state.after(finished)
        redo = self._redo if after.same(self._state) else []
        row = TurnRow(
            latest.config["configurable"]["checkpoint_id"], self._head, turn.kind, turn.text, turn.when,
            summary(self._state, after), said,
        )  # fmt: skip
        self._store.add_turn(self._thread, row, redo)
        self._head, self._redo, self._state = row.checkpoint, redo, after
        self._store.prune(self._thread)
        self._keep_glance()

    def _go(self, checkpoint: str, redo: list[str]) -> Iterable[Any]:
        before = self._state
        self._state = self._load(checkpoint)
        self._store.move(self._thread, checkpoint, redo)
        self._head, self._redo = checkpoint, redo
        self._keep_glance()
        rewritten = [c.id for c in self.structure.components if c not in before.structure.components]
        yield StructureChanged(structure=self.structure)
        yield ProgramChanged(program=self.program, rewritten=tuple(rewritten))
        yield self._state.finished()

    def _path(self) -> list[TurnRow]:
        turns, path, at = self._store.turns(self._thread), [], self._head
        while at in turns:
            path.append(turns[at])
            at = turns[at].parent or ""
        return path[::-1]

    def _last_change(self, path: list[TurnRow]) -> int:
        """The place on a path of the last turn that changed something; 0 where there is none after the first."""
        return next((i for i in range(len(path) - 1, 0, -1) if self._changed(path[i])), 0)

    def _changed(self, turn: TurnRow) -> bool:
        """Whether a turn changed S or its program. Turns of earlier versions say it only roughly."""
        if turn.summary != NOTHING or turn.parent is None:
            return True
        if turn.checkpoint not in self._same:
            self._same[turn.checkpoint] = self._load(turn.checkpoint).same(self._load(turn.parent))
        return not self._same[turn.checkpoint]

    def _last(self, turn: Pending) -> tuple[str, dict[str, Any]] | None:
        """What was typed in the turn before and S before that, where a turn is short enough to correct it, or says the
        same again."""
        path = self._path() if turn.kind == "say" else []
        if len(path) < 2 or path[-1].kind != "say":
            return None
        if len(turn.text.split()) > CORRECTING and turn.text != path[-1].text:
            return None
        return path[-1].text, self._load(path[-2].checkpoint).structure.model_dump(mode="json")

    def _load(self, checkpoint: str) -> State:
        found = self._saver.get_tuple(self._config(checkpoint))
        if found is None:
            raise SessionError(f"the session {self.name!r} lacks its checkpoint {checkpoint}: export what is there")
        return State.model_validate(found.checkpoint["channel_values"]["state"])

    def _glance(self, checkpoint: str) -> State | None:
        """The state of a checkpoint from the copy beside the database; None where that is of another, or broken."""
        try:
            copy = json.loads((self._folder / GLANCE).read_text(encoding="utf-8"))
            return State.model_validate(copy["state"]) if copy["checkpoint"] == checkpoint else None
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def _keep_glance(self) -> None:
        copy = {"checkpoint": self._head, "state": self._state.model_dump(mode="json")}
        with contextlib.suppress(OSError):  # only the next opening is slower
            write_whole(self._folder / GLANCE, json.dumps(copy))

    def _root(self) -> str:
        """The checkpoint of an empty S, at which every session starts."""
        at = self._graph.update_state(
            {"configurable": {"thread_id": self._thread}},
            {"request": {}, "state": State().model_dump(mode="json")},
            as_node="turn",
        )
        checkpoint = at["configurable"]["checkpoint_id"]
        self._store.add_turn(self._thread, TurnRow(checkpoint, None, ROOT, "", 0.0))
        return checkpoint

    def _config(self, checkpoint: str) -> Any:
        return {"configurable": {"thread_id": self._thread, "checkpoint_ns": "", "checkpoint_id": checkpoint}}

    def _free(self) -> None:
        if self._lock.closed:
            raise SessionError(f"the session {self.name!r} is closed")
        if self._running:
            raise SessionError("a turn is still running: wait for it or cancel it first")


def _locked(folder: Path, name: str) -> Any:
    folder.mkdir(parents=True, exist_ok=True)
    handle = (folder / "lock").open("w")
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        handle.close()
        raise SessionInUse(f"the session {name!r} is open in another process: close it there first") from None
    return handle
