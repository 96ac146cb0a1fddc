"""The workbench: three panes kept in step, one state beneath them, one turn at a time."""

import sys
import traceback
from collections.abc import Awaitable, Callable
from dataclasses import replace
from difflib import get_close_matches
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, cast

from textual import on
from textual.app import ComposeResult
from textual.containers import Vertical
from textual.screen import Screen
from textual.widgets import Tab, Tabs
from textual.worker import Worker, WorkerState

from c2s_engine.config import METHOD
from c2s_tui import desk as desks
from c2s_tui.chat.pane import ChatPane
from c2s_tui.choices import Choices
from c2s_tui.code.commands import CodeCommands
from c2s_tui.code.live import LiveCheck
from c2s_tui.code.pane import CodePane
from c2s_tui.columns import Columns
from c2s_tui.commands import bindings, commands, split
from c2s_tui.desk import Desk
from c2s_tui.drafts import Drafts
from c2s_tui.drawing import Drawing
from c2s_tui.files import WATCH_SECONDS, Files
from c2s_tui.keys import KeyBar, named
from c2s_tui.leaving import Leaving
from c2s_tui.messages import CodeTyped, CommandAsked, EditsAsked, Picked, ReachAsked, TextSubmitted
from c2s_tui.palette import Palette
from c2s_tui.part import sentence
from c2s_tui.past import Past
from c2s_tui.picture.commands import PictureCommands
from c2s_tui.picture.pane import PicturePane
from c2s_tui.results.commands import ResultsCommands
from c2s_tui.results.pane import ResultsPane
from c2s_tui.room import TABS, Room
from c2s_tui.screens.commands import ScreenCommands
from c2s_tui.search import Search
from c2s_tui.sessions import Sessions
from c2s_tui.settings import Settings
from c2s_tui.sheet.pane import SheetPane
from c2s_tui.start import Start
from c2s_tui.status import Choice, StatusBar
from c2s_tui.turns import Turns

if TYPE_CHECKING:
    from c2s_engine.session.session import Session
    from c2s_tui.app import C2SApp
    from c2s_tui.backend import Backend

DRAFT_SECONDS = 1.0
AT_ANY_TIME = ("quit", "help", "glossary", "theme", "keys")
"""Commands that need no session."""


class Workbench(Screen):
    """Owns the desk and the parts; panes show the desk and post what they want, parts do it."""

    BINDINGS = [*bindings()]
    COMMANDS = {Palette}

    def __init__(self, backend: "Backend", session: str | None, file: Path | None):
        super().__init__()
        self.backend = backend
        self.session: Session | None = None
        self.desk = Desk()
        self.here: str | None = None  # the component that the cursor of a pane came onto last
        self.faults: list[BaseException] = []  # of the app's own
        self.drawing = Drawing(self)
        self.turns, self.room = Turns(self), Room(self)
        self.start, self.sessions = Start(self, session), Sessions(self)
        self.drafts, self.files, self.past, self.leaving = Drafts(self), Files(self, file), Past(self), Leaving(self)
        self.choices, self.settings = Choices(self), Settings(self)
        self.search, self.screens = Search(self), ScreenCommands(self)
        self.coding, self.live = CodeCommands(self), LiveCheck(self)
        self.showing, self.running = PictureCommands(self), ResultsCommands(self)
        parts = (
            self.turns, self.room, self.start, self.sessions, self.files, self.past, self.leaving, self.choices,
            self.settings, self.search, self.screens, self.coding, self.showing, self.running,
        )  # fmt: skip
        self.does: dict[str, Callable[[str], Awaitable[None]]] = {
            name: getattr(part, f"do_{name}") for name in commands() for part in parts if hasattr(part, f"do_{name}")
        }

    def compose(self) -> ComposeResult:
        tabs = Tabs(*(Tab(title, id=f"tab-{name}") for name, title in TABS.items()), id="tabs")
        tabs.can_focus = False  # a click would take the focus from the pane that it brings
        yield tabs
        with Columns(id="panes"):
            yield ChatPane(id="chat", classes="pane -current")
            yield SheetPane(id="sheet", classes="pane")
            with Vertical(id="right"):
                yield PicturePane(id="picture", classes="pane")
                yield ResultsPane(id="results", classes="pane")
                yield CodePane(id="code-pane", classes="pane")
        yield StatusBar(id="status")
        yield KeyBar(id="keys")

    # Panes.

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
        app = cast("C2SApp", self.app)
        prefs = app.prefs
        self.choices.choice = Choice(method=prefs.method or METHOD, model=prefs.model, map=prefs.map)
        self.chat.entry.put("".join(app.typed_early))
        self.chat.entry.focus()
        if prefs.widths:
            self.query_one(Columns).lay()
        self.show()
        self.call_after_refresh(self.start.begin)  # the engine is imported behind the panes' first frame
        self.set_interval(DRAFT_SECONDS, self.drafts.save)
        self.set_interval(WATCH_SECONDS, self.files.watch_file)
        self.set_interval(1.0, self._tick)

    def take_session(self, session: "Session") -> None:
        """Lay an opened session on the desk."""
        self.session = session
        self.drafts.opened(session)
        self.desk = desks.opened(session.structure, session.program)
        self.code.empty()
        self.desk = replace(desks.restored(self.desk, session), idle=session.idle or ())
        self.chat.border_subtitle = session.name
        self.show()

    # Drawing.

    def show(self) -> None:
        """Draw the desk everywhere, now."""
        self.drawing.all_now()

    def show_status(self) -> None:
        working = self.turns.working
        if working == "reading" and self.turns.long:
            working = f"reading {self.turns.long / 1000:.0f} kB, {monotonic() - self.turns.since:.0f} s"
        self.query_one(StatusBar).show(self.desk, self.choices.choice, working, self._choosing())

    def _choosing(self) -> str:
        """The key of the choice between code by hand and its fields."""
        command = commands()["conflict"]
        return named(cast("C2SApp", self.app).prefs.keys.get(command.id, command.key))

    def _tick(self) -> None:
        if self.turns.long and self.turns.busy:
            self.show_status()

    def on_resize(self) -> None:
        self.call_after_refresh(self.show_status)
        self.call_after_refresh(self.room.show_keys)

    def on_descendant_focus(self) -> None:
        self.room.follow_focus()

    async def on_tabs_tab_activated(self, event: Tabs.TabActivated) -> None:
        if event.tab.id == event.tabs.active:  # else another pane was asked for since
            await self.room.take_tab((event.tab.id or "").removeprefix("tab-"))

    # Commands, and what else the panes ask for.

    async def run_command(self, name: str, argument: str = "") -> None:
        """Run a command by name; an unknown one is said in the chat."""
        if name in self.does:
            await self.does[name](argument)
            return
        near = get_close_matches(name, commands(), 3, 0.5)
        more = f" Did you mean {', '.join('/' + n for n in near)}?" if near else ""
        await self.chat.note(f"There is no command /{name}.{more} /help lists them.", "error")

    async def action_command(self, name: str) -> None:
        await self.run_command(name)

    async def on_worker_state_changed(self, event: Worker.StateChanged) -> None:
        """A fault of the app's own is told in one sentence; the log has where it happened."""
        error = event.worker.error
        if event.state is WorkerState.ERROR and error is not None:
            traceback.print_exception(error, file=sys.stderr)  # into the log
            self.faults.append(error)
            said = f"An error in the app, please report it: {type(error).__name__}: {sentence(error)}"
            await self.chat.note(said, "error")

    @on(TextSubmitted)
    async def _said(self, event: TextSubmitted) -> None:
        self.chat.conversation.anchor()  # the answer comes at the end
        command = split(event.text)
        opening = self.session is None or self.sessions.left is not None
        if opening and (command is None or command[0] not in AT_ANY_TIME):
            await self.turns.wait_to_say(event.text)
        elif command is not None:
            await self.turns.keeping(event.text, self.run_command(*command))
        else:
            await self.turns.say(event.text)

    @on(EditsAsked)
    async def _edits_asked(self, event: EditsAsked) -> None:
        await self.turns.make_edits(event.edits)

    @on(ReachAsked)
    def _reach_asked(self, event: ReachAsked) -> None:
        self.turns.reach(event.edit)

    @on(Picked)
    def _picked(self, event: Picked) -> None:
        if event.source != "sheet":
            self.sheet.point(event.cid)
        if event.source != "code":
            self.code.point(event.cid, event.line)
        self.here = event.cid
        self.chat.show(self.desk.structure, self.desk.idle, self.here)

    @on(CommandAsked)
    async def _command_asked(self, event: CommandAsked) -> None:
        await self.run_command(event.name, event.argument)

    @on(CodeTyped)
    def _code_typed(self) -> None:
        self.live.soon()
