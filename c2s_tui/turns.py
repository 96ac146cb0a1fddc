"""Turns and edits: one at a time, shown as they come, cancelled without a trace (a mixin of the workbench)."""

import asyncio
import re
from collections.abc import AsyncIterator
from contextlib import aclosing
from time import monotonic
from typing import Any

from textual import work

from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import EditError, SetDescription, apply
from c2s_engine.structure.progress import Finished, StageStarted
from c2s_tui import desk as desks

_BACK = re.compile(r"(?:please )?(undo|redo)(?: (?:it|that|this|the last (?:change|edit|turn)))?[.!]?")
DOING = {"interpret": "reading", "resolve": "finding a place on the map", "write": "writing", "compile": "running",
         "solve": "choosing open values"}  # fmt: skip
"""What a turn does in each stage, for the status line."""
LONG = 3000
"""Characters of a text from which on its size and the seconds it takes stand in the status line while it is read."""


class Turns:
    """The work that is under way."""

    @property
    def busy(self: Any) -> bool:
        return bool(self.working)

    def options(self: Any) -> dict[str, Any]:
        """What the next turn is asked with."""
        chosen = {"method": self.choice.method, "map": self.choice.map or None, "trajectories": True}
        return {name: value for name, value in chosen.items() if value is not None}

    @work(group="turn", exclusive=True, exit_on_error=False)
    async def turn(self: Any, source: Any, label: str) -> None:
        """Run a turn of the session and show its events; cancelling leaves S as it was."""
        async with self._turn_lock:
            self.working, self.since = label, monotonic()
            self.desk = desks.begun(self.desk)
            if self._waiting_edits:
                self.desk = desks.expected(self.desk, self._optimistic(self._waiting_edits))
            self.show()
            finished = False
            try:
                async with aclosing(self.backend.events(source)) as events:
                    async for event in events:
                        finished = isinstance(event, Finished)
                        await self._take(event)
            except asyncio.CancelledError:
                raise
            except Exception as error:  # the engine's public errors are sentences; anything else is reported too
                await self.chat.note(self._sentence(error), "error")
            finally:
                self.working = ""
                if not finished:
                    self.desk = desks.broken_off(self.desk, self.session.structure, self.session.program)
                else:
                    self._waiting_edits = ()
                self.show()
                await self.chat.end()
            if finished:
                await self._summarise(label)
                self.find_gaps()
                self.offer_snippets(self.desk.structure)
        then, self.then = self.then, ""
        if finished and then and self.picture.available and not self.picture.has_class("-on"):
            await self.run_command(then)

    async def _take(self: Any, event: Any) -> None:
        if isinstance(event, StageStarted):
            self.working = DOING.get(event.stage, self.working)
        self.desk = desks.step(self.desk, event)
        await self.chat.take(event)
        if event.type not in ("token", "say", "passage"):
            self.show_soon()

    def _optimistic(self: Any, edits: tuple[Any, ...]) -> Structure:
        structure = self.session.structure
        for edit in edits:
            structure = apply(structure, edit)
        return structure

    async def _summarise(self: Any, label: str = "") -> None:
        from c2s_tui.summary import summary

        text, kind = summary(self.desk, self._gone_back(label))
        if text:
            await self.chat.note(text, kind)

    def _gone_back(self: Any, label: str) -> str:
        """Where in the session's history a turn of that label led, in words; empty for one that did something new."""
        if label == "undo":
            return f"undone: {self.session.undone[0].text}"
        if label in ("redo", "going back"):
            here = self.session.history
            return f"{'done again' if label == 'redo' else 'back to'}: {here[-1].text if here else 'the start'}"
        return ""

    @staticmethod
    def _sentence(error: Exception) -> str:
        text = str(error).strip() or type(error).__name__
        return text.splitlines()[0]

    async def say(self: Any, text: str) -> None:
        """A turn of the chat."""
        if wish := _BACK.fullmatch(text.strip().lower()):
            await self.run_command(wish[1])
            return
        if not await self._may_begin():
            self.chat.entry.put(text)
            return
        await self.chat.user(text)
        options, hand = self.options(), self.code.hand_edit
        self.long = len(text) if len(text) > LONG else 0
        self._waiting_edits = ()
        self.turn(lambda: self._after(hand, self.session.say(text, **options)), "reading")

    async def _after(self: Any, hand: tuple[Any, ...], events: AsyncIterator[Any]) -> AsyncIterator[Any]:
        """The events of a turn, after those of applying what was typed in the code: the turn is about that."""
        steps = [self.session.apply(hand, **{**self.options(), "run": False})] if hand else []
        for step in [*steps, events]:
            async with aclosing(step) as found:  # type: ignore[type-var]
                async for event in found:
                    yield event

    async def _may_begin(self: Any) -> bool:
        if self.session is None:
            self.app.notify("The session is still being opened.", markup=False)
            return False
        if self.busy:
            self.app.notify("Still working on the last turn: Esc cancels it.", severity="warning", markup=False)
            return False
        return True

    async def make_edits(self: Any, edits: tuple[Any, ...]) -> None:
        """Edits of S, after what was typed in the code; those of an edit turn that still runs are taken along, for its
        check is stale now."""
        edits = (*self.code.hand_edit, *edits)
        if not edits:
            return
        if self.session is None or (self.busy and not self._waiting_edits):
            await self._may_begin()
            return
        together = (*self._waiting_edits, *edits)
        try:
            self._optimistic(together)
        except EditError as error:
            if not self.sheet.refuse(str(error)):
                self.app.notify(str(error), title="Not possible", severity="error", markup=False)
            return
        await self.sheet.close_editor() if self.sheet.editor else None
        self._waiting_edits = together
        options = self.options()
        self.turn(lambda: self.session.apply(together, **options), "writing")

    @work(group="reach", exclusive=True, exit_on_error=False)
    async def reach(self: Any, edit: Any) -> None:
        """Show what an edit would rewrite, before it is made."""
        structure, reached = self.desk.structure, set()
        try:
            edits = [edit]
            if isinstance(edit, SetDescription) and self.backend.can("reworded"):
                edits, _ = await self.backend.ask("reworded", structure, edits)
            for one in edits:
                reached |= set(await self.backend.ask("reach", structure, one))
                structure = apply(structure, one)
        except (ValueError, LookupError, OSError):
            reached = set()
        if self.sheet.editor:
            self.sheet.show_reach(frozenset(reached))
