"""The workbench: three panes kept in step, one state beneath them, one turn at a time."""

import asyncio
from pathlib import Path
from time import monotonic
from typing import Any

from textual import on, work
from textual.app import ComposeResult
from textual.containers import Horizontal, Vertical
from textual.screen import Screen
from textual.widgets import Tab, Tabs

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
        self.then = ""  # a command to run when the turn under way is done
        self.mouse_free = False  # the terminal has it
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

    # What the panes ask for.

    @on(Said)
    async def _said(self, event: Said) -> None:
        command = split(event.text)
        if command is not None:
            await self.run_command(*command)
            return
        await self.say(event.text)

    @on(EditsAsked)
    async def _edits_asked(self, event: EditsAsked) -> None:
        await self.make_edits(event.edits)

    @on(ReachAsked)
    def _reach_asked(self, event: ReachAsked) -> None:
        self.reach(event.edit)

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
