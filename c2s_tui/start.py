"""Beginning and ending: the first run, opening sessions, recovery, leaving (a mixin of the workbench)."""

import asyncio
from typing import Any

from textual import work

from c2s_tui import desk as desks
from c2s_tui.screens.dialogs import Confirm

EXAMPLE = "example"


def fresh_name(taken: set[str]) -> str:
    """A name for a new session that none has."""
    return next(name for i in range(1, 10_000) if (name := f"session-{i}") not in taken)


class Start:
    """What happens before the first turn and after the last."""

    _typed: set[str]  # the panes in which was typed since the last draft

    @work(group="begin", exit_on_error=False)
    async def begin(self: Any) -> None:
        """Make the engine, open the session that is asked for (else the last, else the example), start the checks."""
        try:
            await self.backend.load()
        except Exception as error:
            await self.chat.note(self._sentence(error), "error")
            return
        prefs = self.app.prefs
        if prefs.trouble:
            await self.chat.note(prefs.trouble, "warning")
        if prefs.model:
            await self.backend.set_model(prefs.model)
        known = {s.name for s in await self.backend.thread.do(self.backend.sessions.list)}
        if self.wanted is None and not prefs.welcomed:
            await self.welcome()
        else:
            last = prefs.session if prefs.session in known else None
            await self.enter(self.wanted or last or fresh_name(known))
        try:
            await self.backend.start()
            if likely := self.choice.map or self.desk.structure.settings.spec.map:
                await self.backend.warm(likely)
        except Exception as error:
            await self.chat.note(f"Programs cannot be checked: {self._sentence(error)}. /doctor says more.", "error")
        self.ready = True
        if self.file is not None and self.session is not None:
            await self.import_file(self.file)
        if self.then and not self.busy:
            then, self.then = self.then, ""
            await self.run_command(then)

    async def welcome(self: Any) -> None:
        """The first run: the example session, explained in six lines; no model, no network."""
        from c2s_tui.example import install, lines, state

        try:
            if self.session is None:
                left = state()
                self.desk = desks.restored(desks.opened(left.structure, left.program), left)
                self.show()
            name = await self.backend.thread.do(lambda: install(self.backend.sessions, EXAMPLE))
        except (OSError, ValueError, RuntimeError) as error:
            await self.chat.note(f"The example could not be opened: {self._sentence(error)}", "warning")
            name = "session-1"
        await self.enter(name)
        for line in lines():
            await self.chat.note(line, "say")
        self.app.remember(welcomed=True)

    async def do_example(self: Any, _: str) -> None:
        if await self._may_begin():
            await self.welcome()

    @work(group="begin", exit_on_error=False)
    async def open_session(self: Any, name: str) -> None:
        """Close the session and open another."""
        if self.busy:
            await self._may_begin()
            return
        await self.enter(name)

    async def enter(self: Any, name: str) -> None:
        """Open a session and show where it was left, with what was typed and not sent."""
        if self.session is not None:
            self.save_drafts(now=True)
        try:
            session = await self.backend.open(name)
        except Exception as error:
            await self.chat.note(f"The session {name} could not be opened: {self._sentence(error)}", "error")
            if self.session is not None:
                return
            session = await self.backend.open(f"{name}-2")
        changed = self.session is not session
        typed = self.chat.entry.text if self.session is None else ""  # while the session was being opened
        self.chat.entry.put(session.draft("chat") + typed)
        if changed:
            await self.chat.clear()
        self.take_session(session)
        self.app.remember(session=session.name)
        for turn in session.history[-50:]:
            await self.chat.note(turn.text, "user" if turn.kind == "say" else "note")
            for reply in turn.replies:
                await self.chat.note(reply, "say")
        await self._recover(session)

    async def _recover(self: Any, session: Any) -> None:
        """Put back a draft of the code; offer a turn that a crash interrupted."""
        code = session.draft("code")
        if code and code != session.program.text:
            self.code.area.text = code
            await self.chat.note(
                "Your unapplied edits are back in the code pane: F5 applies them.", "warning"
            )
        self.recovered = True
        if session.pending is not None:
            said = session.pending.text[:120]
            await self.chat.note(f"This turn was interrupted: “{said}”. /resume runs it again.", "warning")

    async def do_quit(self: Any, _: str) -> None:
        """Leave; where work would be lost or broken off, ask once."""
        reasons = []
        if self.busy:
            reasons.append("a turn is still running")
        if self.code.edited:
            reasons.append("the code has hand edits that are not applied")
        if self.file is not None and self.saved_text is not None and self.code.text != self.saved_text:
            reasons.append(f"{self.file.name} has unsaved changes")
        if not reasons:
            await self.leave()
            return
        answers = {
            "q": ("quit", "quit (drafts are kept)"),
            "s": ("save", "save the file and quit"),
            "b": ("", "go back"),
        }
        if self.file is None:
            del answers["s"]

        async def decided(answer: str | None) -> None:
            if answer == "save":
                await self.write(self.file)
            if answer in ("quit", "save"):
                await self.leave()

        self.app.push_screen(Confirm(f"Leave? {'; '.join(reasons).capitalize()}.", answers), decided)

    async def leave(self: Any) -> None:
        """Save drafts, close everything, end the app."""
        self.save_drafts(now=True)
        self.workers.cancel_all()
        self.app.exit()

    def save_drafts(self: Any, now: bool = False) -> None:
        """Swap to disk what was typed and neither sent nor applied; `now`: all of it, before this returns."""
        if self.session is None or not (self._typed or now and self.recovered):
            return
        texts = {"chat": self.chat.entry.text, "code": self.code.text if self.code.edited else ""}
        typed, self._typed = self._typed, set()
        if now:  # what is being written from a thread at this moment may be older than what is there
            for pane in texts if self.recovered else typed:
                self.session.save_draft(pane, texts[pane])
        else:
            self._write_drafts({pane: texts[pane] for pane in typed})

    @work(group="drafts", exit_on_error=False)
    async def _write_drafts(self: Any, texts: dict[str, str]) -> None:
        session = self.session
        await asyncio.to_thread(lambda: [session.save_draft(pane, text) for pane, text in texts.items()])
