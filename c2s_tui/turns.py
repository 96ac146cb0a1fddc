"""Turns and edits: one at a time, shown as they come, cancelled without a trace."""

import asyncio
import contextlib
import re
from collections.abc import AsyncIterator, Awaitable, Callable, Sequence
from contextlib import aclosing
from dataclasses import replace
from functools import partial
from time import monotonic
from typing import TYPE_CHECKING, Any

from c2s_engine.structure.account import unread_words
from c2s_engine.structure.components import ComponentId, Structure, Unmet
from c2s_engine.structure.edits import Edit, EditError, SetDescription, apply
from c2s_engine.structure.progress import Finished, Progress, StageStarted
from c2s_tui import desk as desks
from c2s_tui.commands import split
from c2s_tui.facade import EngineFacade
from c2s_tui.part import Part, background, sentence

if TYPE_CHECKING:
    from c2s_tui.chat.bubbles import Line
    from c2s_tui.workbench import Workbench

_BACK = re.compile(r"(?:please )?(undo|redo)(?: (?:it|that|this|the last (?:change|edit|turn)))?[.!]?")
DOING = {"interpret": "reading", "resolve": "finding a place on the map", "write": "writing", "compile": "running",
         "solve": "choosing open values"}  # fmt: skip
"""What a turn does in each stage, for the status line."""
LONG = 3000
"""Characters of a text from which on its size and the seconds it takes stand in the status line while it is read."""


class Turns(Part):
    """The work that is under way."""

    def __init__(self, bench: "Workbench"):
        super().__init__(bench)
        self.working = ""  # what is being done, for the status line; empty where nothing is
        self.since, self.long = 0.0, 0  # when the turn began (s), and the size of its text where that is long
        self.lock = asyncio.Lock()
        self.waiting: tuple[Edit, ...] = ()  # edits of the turn under way
        self.then = ""  # a command to run when the turn under way is done
        self.said = ""  # the text of the turn under way, where it is one
        self.count = 0  # turns that have begun
        self.early: list[str] = []  # what was sent before a session was open
        self.commanded = False  # whether a command runs that was typed
        self.refused = False  # whether what was asked for last could not begin

    @property
    def busy(self) -> bool:
        return bool(self.working)

    def options(self) -> dict[str, Any]:
        """What the next turn is asked with."""
        choice = self.bench.choices.choice
        chosen = {"method": choice.method, "map": self.bench.choices.map_of(self.desk.structure), "trajectories": True}
        return {name: value for name, value in chosen.items() if value is not None}

    @background("turn")
    async def turn(
        self, source: Callable[[], AsyncIterator[Progress]], label: str, edits: Sequence[Edit] = ()
    ) -> None:
        """Run a turn of the session and show its events; cancelling leaves S as it was. `edits`: those it makes, where
        they are known before."""
        async with self.lock:
            self.working, self.since = label, monotonic()
            self.count += 1
            before, said, session = self.desk.structure, self.said, self.bench.session
            self.desk = desks.begun(self.desk)
            if self.waiting:
                self.desk = desks.expected(self.desk, self._optimistic(self.waiting))
            self.bench.show()
            self.bench.code.hand_over(edits)
            finished = False
            try:
                async with aclosing(self.backend.events(source)) as events:
                    async for event in events:
                        finished = isinstance(event, Finished)
                        await self._take(event)
            except asyncio.CancelledError:
                raise
            except Exception as error:  # the engine's public errors are sentences; anything else is reported too
                await self.chat.note(sentence(error), "error")
            finally:
                self.working = self.said = ""
                if said and not finished and session is not None and session is self.bench.session:
                    session.drop_pending()  # of a turn that never began: one that began has its end
                if not finished:
                    self.desk = desks.broken_off(self.desk, self.session)
                else:
                    self.waiting = ()
                self.bench.show()
                self.bench.code.hand_over(())
                self.bench.drafts.save()  # what was applied is no draft any more, also after a crash
                await self.chat.end()
            if finished:
                self.desk = replace(self.desk, idle=self.session.idle or ())
                closing = await self.summarise(label)
                self.desk = desks.as_it_was(self.desk, self.session)
                self.bench.show()
                self.bench.running.find_gaps()
                self.bench.search.offer_snippets(self.desk.structure)
                now = self.desk.structure
                if now != before and now.text not in ("", before.text):
                    self.name_what_has_no_effect(now.text, closing=closing)
                elif now != before and said and not self.bench.choices.served:
                    self.name_what_has_no_effect(said, before)
        then, self.then = self.then, ""
        if finished and then and self.bench.picture.available and not self.bench.picture.has_class("-on"):
            await self.bench.run_command(then)

    @background("no_effect")
    async def name_what_has_no_effect(
        self, text: str, upon: Structure | None = None, closing: "Line | None" = None
    ) -> None:
        """When a description, or a change of S (`upon`), was read, say which of its words make no difference; those of
        a description count in the line that closed its turn, too."""
        from c2s_engine.session.no_effect import phrases_sentence
        from c2s_tui.summary import summary

        now, turn, session = self.desk.structure, self.count, self.session
        found: tuple[Unmet, ...]
        try:
            if upon is None:
                found = await self.backend.ask(lambda _: self.session.without_effect())
            else:
                found = tuple(await self.backend.ask(lambda engine: engine.without_effect(text, now, upon)))
                await asyncio.to_thread(session.keep_idle, text, found)
        except (ValueError, OSError):
            return  # what cannot be read is said by the turn
        if turn != self.count or now != self.desk.structure:
            return
        if found:
            if closing is not None:
                self.desk = replace(self.desk, idle=found)
                closing.say(summary(self.desk)[0])
                self.bench.show()
            await self.chat.note(phrases_sentence(found, of=text), "note")
        if upon is None and (words := unread_words(now.text[a:b] for a, b in now.unread)):
            await self.chat.note(words, "note")

    async def _take(self, event: Progress) -> None:
        if isinstance(event, StageStarted):
            self.working = DOING.get(event.stage, self.working) + event.runs
        self.desk = desks.step(self.desk, event)
        await self.chat.take(event)
        if event.type not in ("token", "say", "passage"):
            self.bench.drawing.soon()

    def _optimistic(self, edits: Sequence[Edit]) -> Structure:
        structure = self.session.structure
        for edit in edits:
            structure = apply(structure, edit)
        return structure

    async def summarise(self, label: str = "") -> "Line | None":
        """The line that closes a turn."""
        from c2s_tui.summary import summary

        text, kind = summary(self.desk, self._gone_back(label))
        return await self.chat.note(text, kind) if text else None

    def _gone_back(self, label: str) -> str:
        """Where in the session's history a turn of that label led, in words; empty for one that did something new."""
        if label == "undo":
            return f"undone: {self.session.undone[0].text}"
        if label in ("redo", "going back"):
            here = [t for t in self.session.history if label != "redo" or not t.asked]
            return f"{'done again' if label == 'redo' else 'back to'}: {here[-1].text if here else 'the start'}"
        return ""

    async def say(self, text: str) -> None:
        """A turn of the chat."""
        if wish := _BACK.fullmatch(text.strip().lower()):
            await self.bench.run_command(wish[1])
            return
        if self.busy:
            await self.chat.note("Not sent, it stays typed: the last turn still runs (Esc cancels it).", "warning")
        if self.busy or not await self.may_begin():
            self._put_back(text)
            return
        options, hand, session = self.options(), self.bench.code.hand_edit, self.session
        with contextlib.suppress(OSError):  # the turn says it
            await asyncio.to_thread(partial(session.note_sent, text, **options))
        await self.chat.user(text)
        self.long = len(text) if len(text) > LONG else 0
        self.waiting, self.said = (), text
        self.turn(lambda: self._after(hand, self.session.say(text, **options)), "reading", hand)

    async def wait_to_say(self, text: str) -> None:
        """What is sent while the session is still being opened waits for that."""
        self.early.append(text)
        await self.chat.note(f"Waiting until the session is open: “{text}”")

    async def say_early(self, opened: bool) -> None:
        """Send what was sent too early: one turn and the commands before it; what follows, or all of it where no
        session could be opened, is back in the line."""
        early, self.early = self.early, []
        while opened and early:
            text = early.pop(0)
            await self.bench.run_command(*command) if (command := split(text)) else await self.say(text)
            if not command:
                break
        if early:
            self._put_back("\n".join(early))

    def _put_back(self, text: str) -> None:
        """Back into the line, or after what was begun there since."""
        self.chat.entry.keep(text)

    async def _after(self, hand: Sequence[Edit], events: AsyncIterator[Progress]) -> AsyncIterator[Progress]:
        """The events of a turn, after those of applying what was typed in the code: the turn is about that."""
        steps = [self.session.apply(hand, **{**self.options(), "run": False})] if hand else []
        for step in [*steps, events]:
            async with aclosing(step) as found:  # type: ignore[type-var]
                async for event in found:
                    yield event

    async def keeping(self, text: str, command: Awaitable[None]) -> None:
        """A command that was typed; where it may not begin now, it stays typed."""
        self.refused, self.commanded = False, True
        try:
            await command
        finally:
            self.commanded = False
        if self.refused:
            self._put_back(text)

    async def may_begin(self) -> bool:
        self.refused = self.bench.session is None or self.busy
        if self.bench.session is None:
            self.app.notify("The session is still being opened.", markup=False)
            return False
        if self.busy:
            self.app.notify("Still working on the last turn: Esc cancels it.", severity="warning", markup=False)
            return False
        return True

    async def make_edits(self, edits: Sequence[Edit]) -> None:
        """Edits of S, after what was typed in the code; those of an edit turn that still runs are taken along, for its
        check is stale now."""
        edits = (*self.bench.code.hand_edit, *edits)
        if not edits:
            return
        if self.bench.session is None or (self.busy and not self.waiting):
            await self.may_begin()
            return
        together = (*self.waiting, *edits)
        try:
            self._optimistic(together)
        except EditError as error:
            if not self.bench.sheet.refuse(str(error)):
                self.app.notify(str(error), title="Not possible", severity="error", markup=False)
            return
        await self.bench.sheet.close_editor() if self.bench.sheet.editor else None
        self.waiting = together
        options = self.options() | {"map": self.bench.choices.map_of(self._optimistic(together))}
        self.turn(lambda: self.session.apply(together, **options), "writing", together)

    @background("reach")
    async def reach(self, edit: Edit) -> None:
        """Show what an edit would rewrite, before it is made."""
        structure, reached = self.desk.structure, set[ComponentId]()
        try:
            edits = [edit]
            if isinstance(edit, SetDescription):
                edits, _ = await self.backend.ask(lambda engine: engine.reworded(self.desk.structure, [edit]))
            for one in edits:
                reached |= set(await self.backend.do(partial(_reach, structure, one)))
                structure = apply(structure, one)
        except (ValueError, LookupError, OSError):
            reached.clear()
        if self.bench.sheet.editor:
            self.bench.sheet.show_reach(frozenset(reached))

    @background("turn")
    async def run_again(self, then: str = "", told: bool = True) -> None:
        """Check and run the program as it stands; S and history stay. `then` names a command to run after it; `told`:
        whether the chat says how it went."""
        async with self.lock:
            self.working = "running"
            self.bench.show_status()
            program = self.desk.program
            try:
                report = await self.backend.check(
                    program.text, spans=program.spans, upto="run", trajectories=True
                )
                judged = await self.backend.ask(lambda engine: engine.judge(self.desk.structure, report))
                self.desk = desks.checked(self.desk, report, judged)
            except Exception as error:
                await self.chat.note(sentence(error), "error")
            finally:
                self.working = ""
                self.bench.show()
        if told:
            await self.summarise()
        self.bench.running.find_gaps()
        if then and self.bench.picture.available:
            await self.bench.run_command(then)

    async def do_run(self, _: str) -> None:
        """Apply hand edits; without any, check and run what stands."""
        if self.bench.code.commit() or not await self.may_begin():
            return
        if self.desk.program.text:
            self.run_again()
        else:
            await self.chat.note("There is no program yet: describe a scenario first.", "error")

    async def do_regenerate(self, argument: str) -> None:
        if not await self.may_begin():
            return
        chosen = tuple(argument.replace(",", " ").split())
        unknown = [c for c in chosen if c not in self.desk.structure]
        if unknown:
            await self.chat.note(f"There is no component {', '.join(unknown)}.", "error")
            return
        options = self.options()
        self.turn(lambda: self.session.regenerate(chosen, **options), "writing")

    async def do_undo(self, _: str) -> None:
        await self._back("undo")

    async def do_redo(self, _: str) -> None:
        await self._back("redo")

    async def _back(self, which: str) -> None:
        if not await self.may_begin():
            return
        if not await self.backend.do(lambda _: getattr(self.session, f"can_{which}")):
            self.app.notify(f"There is nothing to {which}.", markup=False)
            return
        self.turn(lambda: getattr(self.session, which)(), which)

    async def do_resume(self, _: str) -> None:
        if await self.may_begin():
            if self.session.pending is None:
                await self.chat.note("No turn was interrupted.", "note")
                return
            self.turn(lambda: self.session.resume(), "resuming")

    async def do_cancel(self, _: str) -> None:
        """Cancel what runs; S is as before the turn, what is typed stays, what was sent is back in an empty line."""
        if self.busy:
            self.waiting = ()
            if self.said and not self.chat.entry.text:
                self.chat.entry.put(self.said)
            self.bench.workers.cancel_group(self.bench, "turn")
            await self.chat.note("Cancelled; nothing was changed.", "note")


def _reach(structure: Structure, edit: Edit, engine: EngineFacade) -> list[ComponentId]:
    return engine.reach(structure, edit)
