"""The workbench: three panes kept in step, one state beneath them, one turn at a time."""

import asyncio
import re
from collections.abc import AsyncIterator
from contextlib import aclosing
from pathlib import Path
from time import monotonic
from typing import Any

from textual import on, work
from textual.app import ComposeResult
from textual.containers import Horizontal, Vertical
from textual.screen import Screen
from textual.widgets import Tab, Tabs

from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import EditError, SetDescription, apply
from c2s_engine.structure.progress import Finished, StageStarted
from c2s_tui import desk as desks
from c2s_tui.actions import Actions
from c2s_tui.chat.entry import Entry
from c2s_tui.chat.pane import ChatPane
from c2s_tui.code.pane import CodePane
from c2s_tui.commands import bindings, split
from c2s_tui.desk import Desk
from c2s_tui.drawing import Drawing
from c2s_tui.files import WATCH_SECONDS
from c2s_tui.keys import KeyBar
from c2s_tui.layout import TABS
from c2s_tui.messages import CodeTyped, CommandAsked, EditsAsked, Picked, ReachAsked, Said
from c2s_tui.palette import Palette
from c2s_tui.picture.pane import PicturePane
from c2s_tui.results.pane import ResultsPane
from c2s_tui.sheet.pane import SheetPane
from c2s_tui.status import Choice, StatusBar

DRAFT_SECONDS = 1.0
_BACK = re.compile(r"(?:please )?(undo|redo)(?: (?:it|that|this|the last (?:change|edit|turn)))?[.!]?")
DOING = {"interpret": "reading", "resolve": "looking for the place", "write": "writing", "compile": "running",
         "solve": "choosing what is open"}  # fmt: skip
"""What a turn does in each stage, for the status line."""
LONG = 3000
"""Characters of a text from which on its size and the seconds it takes stand in the status line while it is read."""
LIVE_SECONDS = 0.4
"""How long typing in the code must rest before the text is checked."""


class Workbench(Actions, Drawing, Screen):
    """Owns the desk; panes show it and post what they want."""

    BINDINGS = [*bindings()]
    COMMANDS = {Palette}

    def __init__(self, backend: Any, session: str | None, file: Path | None):
        super().__init__()
        self.backend, self.wanted = backend, session
        self.file: Path | None = file
        self.session: Any = None
        self.desk = Desk()
        self.here: str | None = None  # the component that the cursor of a pane came onto last
        self.choice = Choice()
        self.working = ""
        self.since, self.long = 0.0, 0  # when the turn began (s), and the size of its text where that is long
        self.ready = False
        self.recovered = False  # the session's drafts are in the panes again
        self._turn_lock = asyncio.Lock()
        self._waiting_edits: tuple[Any, ...] = ()
        self._typed: set[str] = set()
        self.offered: set[tuple[str, str]] = set()  # (component, words) whose snippets were shown
        self._live: Any = None
        self.file_seen: float | None = None
        self.told_change: float | None = None
        self.saved_text: str | None = None

    def compose(self) -> ComposeResult:
        yield Tabs(*(Tab(title, id=f"tab-{name}") for name, title in TABS.items()), id="tabs")
        with Horizontal(id="panes"):
            yield ChatPane(id="chat", classes="pane -current")
            yield SheetPane(id="sheet", classes="pane")
            with Vertical(id="right"):
                yield PicturePane(id="picture", classes="pane")
                yield ResultsPane(id="results", classes="pane")
                yield CodePane(id="code-pane", classes="pane")
        yield StatusBar(id="status")
        yield KeyBar(id="keys")

    # Parts.

    @property
    def chat(self) -> ChatPane:
        return self.query_one(ChatPane)

    @property
    def sheet(self) -> SheetPane:
        return self.query_one(SheetPane)

    @property
    def picture(self) -> PicturePane:
        return self.query_one(PicturePane)

    @property
    def results(self) -> ResultsPane:
        return self.query_one(ResultsPane)

    @property
    def code(self) -> CodePane:
        return self.query_one(CodePane)

    # Beginning.

    def on_mount(self) -> None:
        prefs = self.app.prefs  # type: ignore[attr-defined]
        self.choice = Choice(method=prefs.method or "embedded", model=prefs.model, map=prefs.map)
        early = "".join(self.app.typed_early)  # type: ignore[attr-defined]
        self.chat.entry.put(early)
        self.chat.entry.focus()
        if prefs.widths:
            self.lay_columns()
        self.show()
        self.call_after_refresh(self.begin)  # the engine is imported behind the panes' first frame
        self.set_interval(DRAFT_SECONDS, self.save_drafts)
        self.set_interval(WATCH_SECONDS, self.watch_file)
        self.set_interval(1.0, self._tick)

    def show_status(self) -> None:
        working = self.working
        if working == "reading" and self.long:
            working = f"reading {self.long / 1000:.0f} kB, {monotonic() - self.since:.0f} s"
        self.query_one(StatusBar).show(self.desk, self.choice, working)

    def _tick(self) -> None:
        if self.long and self.busy:
            self.show_status()

    def take_session(self, session: Any) -> None:
        """Lay an opened session on the desk."""
        self.session, self.recovered = session, False
        self.desk = desks.opened(session.structure, session.program)
        self.code.empty()
        self.desk = desks.restored(self.desk, session)
        self.chat.border_subtitle = session.name
        self.show()

    # Turns.

    @property
    def busy(self) -> bool:
        return bool(self.working)

    def options(self) -> dict[str, Any]:
        """What the next turn is asked with."""
        chosen = {"method": self.choice.method, "map": self.choice.map or None, "trajectories": True}
        return {name: value for name, value in chosen.items() if value is not None}

    @work(group="turn", exclusive=True, exit_on_error=False)
    async def turn(self, source: Any, label: str) -> None:
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
                await self._summarise()
                self.find_gaps()
                self.offer_snippets(self.desk.structure)

    async def _take(self, event: Any) -> None:
        if isinstance(event, StageStarted):
            self.working = DOING.get(event.stage, self.working)
        self.desk = desks.step(self.desk, event)
        await self.chat.take(event)
        if event.type not in ("token", "say", "passage"):
            self.show_soon()

    def _optimistic(self, edits: tuple[Any, ...]) -> Structure:
        structure = self.session.structure
        for edit in edits:
            structure = apply(structure, edit)
        return structure

    async def _summarise(self) -> None:
        from c2s_tui.summary import summary

        text, kind = summary(self.desk)
        if text:
            await self.chat.note(text, kind)

    @staticmethod
    def _sentence(error: Exception) -> str:
        text = str(error).strip() or type(error).__name__
        return text.splitlines()[0]

    # What the panes ask for.

    @on(Said)
    async def _said(self, event: Said) -> None:
        command = split(event.text)
        if command is not None:
            await self.run_command(*command)
            return
        await self.say(event.text)

    async def say(self, text: str) -> None:
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

    async def _after(self, hand: tuple[Any, ...], events: AsyncIterator[Any]) -> AsyncIterator[Any]:
        """The events of a turn, after those of applying what was typed in the code: the turn is about that."""
        steps = [self.session.apply(hand, **{**self.options(), "run": False})] if hand else []
        for step in [*steps, events]:
            async with aclosing(step) as found:  # type: ignore[type-var]
                async for event in found:
                    yield event

    async def _may_begin(self) -> bool:
        if self.session is None:
            self.app.notify("The session is still being opened.", markup=False)
            return False
        if self.busy:
            self.app.notify("Still working on the last turn: Esc cancels it.", severity="warning", markup=False)
            return False
        return True

    @on(EditsAsked)
    async def _edits_asked(self, event: EditsAsked) -> None:
        await self.make_edits(event.edits)

    async def make_edits(self, edits: tuple[Any, ...]) -> None:
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

    @on(ReachAsked)
    def _reach_asked(self, event: ReachAsked) -> None:
        self.reach(event.edit)

    @work(group="reach", exclusive=True, exit_on_error=False)
    async def reach(self, edit: Any) -> None:
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

    @on(Picked)
    def _picked(self, event: Picked) -> None:
        if event.source != "sheet":
            self.sheet.point(event.cid)
        if event.source != "code":
            self.code.point(event.cid, event.line)
        self.here = event.cid
        self.chat.show(self.desk.structure, self.here)

    @on(CommandAsked)
    async def _command_asked(self, event: CommandAsked) -> None:
        await self.run_command(event.name, event.argument)

    @on(CodeTyped)
    def _code_typed(self) -> None:
        self._typed.add("code")
        if self._live is not None:
            self._live.stop()
        self._live = self.set_timer(LIVE_SECONDS, self.check_live)

    @work(group="live", exclusive=True, exit_on_error=False)
    async def check_live(self) -> None:
        """Check the text as it is being typed, when no turn runs; newer text cancels it."""
        if not self.code.edited or self.busy or not self.backend.can("check"):
            return
        text, spans = self.code.area.text, self.code.side.spans
        try:
            report = await self.backend.check(text, spans=spans, upto="compile")
        except (ValueError, OSError, RuntimeError):
            return
        if text == self.code.area.text and not self.busy:
            self.code.show_findings(tuple(d for stage in report.stages for d in stage.diagnostics))

    @on(Entry.Changed)
    def _entry_changed(self) -> None:
        self._typed.add("chat")
