"""The app's shell: it is on the screen before anything heavy is imported, and keeps what is typed meanwhile."""

import asyncio
import os
import signal
import sys
import threading
from collections.abc import Iterable
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from textual import work
from textual.app import App, ComposeResult, SystemCommand
from textual.events import Key
from textual.screen import Screen
from textual.widgets import Static

from c2s_tui import prefs as preferences
from c2s_tui.line import end_soon
from c2s_tui.look.kinds import ascii_only
from c2s_tui.look.themes import DEFAULT, themes

if TYPE_CHECKING:
    from c2s_tui.backend import Backend
    from c2s_tui.workbench import Workbench


class C2SApp(App[None]):
    """Shell, themes, keys, signals. The work is the Workbench's."""

    TITLE = "c2s"
    CSS_PATH = "look/app.tcss"
    ENABLE_COMMAND_PALETTE = True
    HORIZONTAL_BREAKPOINTS = [(0, "-narrow"), (100, "-wide"), (180, "-roomy")]
    VERTICAL_BREAKPOINTS = [(0, "-short"), (30, "-high")]

    def __init__(
        self,
        backend: "Backend | None" = None,
        session: str | None = None,
        file: Path | None = None,
        prefs: preferences.Prefs | None = None,
    ):
        super().__init__()
        self.prefs = prefs or preferences.load()
        self.backend, self.session_name, self.file = backend, session, file
        self.typed_early: list[str] = []
        self.workbench: Workbench | None = None
        self._going = False  # the line was dropped
        for theme in themes():
            self.register_theme(theme)
        wanted = self.prefs.theme if self.prefs.theme in self.available_themes else DEFAULT
        few = os.environ.get("TERM") == "linux" or self.console.color_system == "standard"
        self.theme = "c2s-mono" if self.no_color else "c2s-ansi" if few and wanted != "c2s-mono" else wanted
        self.set_class(ascii_only(), "-ascii")
        if not self.prefs.animation:
            self.animation_level = "none"

    def compose(self) -> ComposeResult:
        yield Static(" c2s", id="top", markup=False)

    def on_mount(self) -> None:
        self.set_keymap(self.prefs.keys)
        self.call_after_refresh(self.furnish)
        self._loop_here = asyncio.get_running_loop()
        with suppress(ValueError):  # not the main thread
            for name in (signal.SIGHUP, signal.SIGTERM):
                signal.signal(name, self._dropped)

    def on_key(self, event: Key) -> None:
        if self.workbench is None and event.character and event.is_printable:
            self.typed_early.append(event.character)

    @work
    async def furnish(self) -> None:
        """Import the panes behind the first paint and put them up."""
        module = await asyncio.to_thread(import_module, "c2s_tui.workbench")
        if self.backend is None:
            from c2s_tui.backend import Backend

            self.backend = Backend()
        self.workbench = module.Workbench(self.backend, self.session_name, self.file)
        await self.push_screen(self.workbench)

    def get_system_commands(self, screen: Screen) -> Iterable[SystemCommand]:
        """None of Textual's own in the palette: quitting, themes and keys are commands of this app."""
        return ()

    @property
    def failed_by(self) -> Exception | None:
        """The error that ended the app, where one did."""
        return self._exception

    async def action_quit(self) -> None:
        """Leave; the workbench asks first where work would be lost. A second time it is meant."""
        if self.workbench is None or not self.workbench.children or type(self.screen).__name__ == "Confirm":
            self.exit()  # without panes it is on its way out
        else:
            await self.workbench.run_command("quit")

    def _dropped(self, *_: object) -> None:
        """The line was dropped (SIGHUP) or the process is told to end: save and go, also where nothing can be saved.

        The event loop may hang in a write to the terminal that is gone, so this does not wait for its turn. It saves
        from a thread of its own: the signal may come while this one holds the lock of the drafts, and comes twice where
        the shell and the terminal both tell it.
        """
        if not self._going:
            self._going = True
            end_soon()
            threading.Thread(target=self._save_and_go, name="dropped").start()

    def _save_and_go(self) -> None:
        try:
            if self.workbench is not None:
                self.workbench.drafts.save(now=True)
        except Exception as error:
            print(f"What was typed last could not be saved: {error}", file=sys.stderr)  # into the log
        self._loop_here.call_soon_threadsafe(self.exit)

    def remember(self, **choices: Any) -> None:
        """Keep choices for the next start; a file that cannot be written costs a notice, not the choice."""
        for name, value in choices.items():
            setattr(self.prefs, name, value)
        try:
            preferences.save(self.prefs)
        except OSError as error:
            said = f"This setting cannot be saved; it lasts until you quit: {error}"
            self.notify(said, severity="warning", markup=False)

    def copy_to_clipboard(self, text: str) -> None:
        """To the terminal's clipboard, through a multiplexer where there is one."""
        from c2s_tui.clipboard import copy

        self._clipboard = text
        if self._driver is not None:
            copy(text, self._driver.write)
