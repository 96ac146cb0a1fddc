"""Sessions: open one, as it was left; list, rename, delete."""

import asyncio
from difflib import get_close_matches
from typing import TYPE_CHECKING

from c2s_engine.session.errors import SessionInUse
from c2s_tui.line import GONE_SECONDS
from c2s_tui.part import Part, background, sentence
from c2s_tui.past import when
from c2s_tui.screens.dialogs import Choosable, Chooser, Confirm

if TYPE_CHECKING:
    from c2s_engine.session.session import Session
    from c2s_tui.workbench import Workbench

LOOK_AGAIN = 0.25
"""s between two looks at whether another process has closed a session."""


def fresh_name(taken: set[str]) -> str:
    """A name for a new session that none has."""
    return next(name for i in range(1, 10_000) if (name := f"session-{i}") not in taken)


class Sessions(Part):
    """Commands that concern sessions as a whole."""

    def __init__(self, bench: "Workbench"):
        super().__init__(bench)
        self.left: str | None = None  # what stood in the line as a command was sent that opens a session, until it has

    def opens(self) -> None:
        """A command opens a session: where it was typed, what is typed from then on is for that one."""
        typed = self.bench.session is not None and self.bench.turns.commanded
        self.left = self.chat.entry.left if typed else None

    @background("begin", exclusive=False)
    async def open_session(self, name: str, word: str = "") -> None:
        """Close the session and open another; `word`: what is said when it is open."""
        if self.bench.turns.busy:
            await self.bench.turns.may_begin()
            self.left = None
            return
        await self.enter(name)
        if word and self.bench.session is not None and self.session.name == name:
            await self.chat.note(word)

    @background("begin", exclusive=False)
    async def open_known(self, name: str) -> None:
        """Open a session that there is; of a name that none has, say which are near: a slip of the keys makes none."""
        names = [s.name for s in await self.backend.all_sessions()]
        if name in names:
            self.open_session(name)
            return
        self.left = None
        near = get_close_matches(name, names, 3)
        there = f"Did you mean {' or '.join(near)}?" if near else f"There are {', '.join(names[:5])}; /open lists all."
        await self.chat.note(
            f"There is no session and no file {name}. {there} /new {name} makes a new session.", "error"
        )

    async def enter(self, name: str) -> None:
        """Open a session and show where it was left, with what was typed and not sent."""
        if self.bench.session is not None:
            self.bench.drafts.save(now=True)
        try:
            session = await self._opened(name)
        except Exception as error:
            await self.chat.note(f"The session {name} could not be opened: {sentence(error)}", "error")
            if self.bench.session is not None:
                self.left = None
                return
            session = await self.backend.open(f"{name}-2")
        changed = self.bench.session is not session
        entry = self.chat.entry
        before = "" if self.bench.session is None else entry.text if self.left is None else self.left
        typed = entry.text.removeprefix(before)  # while the session was being opened
        entry.put(session.draft("chat") + typed)
        if changed:
            await self.chat.clear()
            if self.bench.session is not None:
                self.bench.files.forget()
        self.bench.take_session(session)
        switched, self.left = self.left is not None, None
        self.app.remember(session=session.name)
        self.chat.entry.remember(session.typed)
        for turn in session.conversation[-50:]:
            await self.chat.note(turn.text, "user" if turn.kind == "say" else "note")
            for reply in turn.replies:
                await self.chat.note(reply, "say")
            if not turn.asked:
                await self.chat.note(turn.summary[:1].upper() + turn.summary[1:])
        if session.idle:
            from c2s_engine.session.no_effect import phrases_sentence

            await self.chat.note(phrases_sentence(session.idle, of=session.structure.text))
        await self._recover(session)
        if switched:
            await self.bench.turns.say_early(True)

    async def _opened(self, name: str) -> "Session":
        """The session; at the start of the app one that is still held is waited for: the app whose line was dropped is
        on its way out. Raises SessionError."""
        tries = 1 if self.bench.session is not None else int((GONE_SECONDS + 3) / LOOK_AGAIN)
        for left in reversed(range(tries)):
            try:
                return await self.backend.open(name)
            except SessionInUse:
                if not left:
                    raise
                if left == tries - 1:
                    await self.chat.note(f"The session {name} is open in another process: waiting for it to close.")
            await asyncio.sleep(LOOK_AGAIN)
        raise AssertionError("the last try returns or raises")

    async def _recover(self, session: "Session") -> None:
        """Put back a draft of the code; offer a turn that a crash interrupted."""
        code = session.draft("code")
        if code and code != session.program.text:
            self.bench.code.area.text = code
            await self.chat.note("Your unapplied edits are back in the code pane: F5 applies them.", "warning")
        self.bench.drafts.recovered = True
        if session.pending is not None:
            said = session.pending.text[:120]
            await self.chat.note(f"This turn was interrupted: “{said}”. /resume runs it again.", "warning")

    @background("choices")
    async def offer_sessions(self) -> None:
        """The sessions, the one used last first."""
        found = await self.backend.all_sessions()
        entries = [Choosable(s.name, s.name, f"{when(s.updated)}  {s.turns} turns  {s.last[:40]}") for s in found]
        current = self.bench.session.name if self.bench.session else ""
        foot = "Enter opens; /rename NAME and /delete NAME in the chat"
        chosen = await self.app.push_screen_wait(
            Chooser("Sessions", entries, current, free="type to filter, or a new session's name", foot=foot, wide=True)
        )
        if chosen:
            self.open_session(chosen)

    async def do_rename(self, argument: str) -> None:
        if not await self.bench.turns.may_begin():
            return
        if not argument:
            self.chat.entry.put("/rename ")
            return
        from c2s_engine.session.errors import SessionError

        old = self.session.name
        try:
            await self.backend.thread.do(lambda: self.backend.sessions.rename(old, argument))
        except SessionError as error:
            await self.chat.note(sentence(error), "error")
            return
        self.session.name = self.chat.border_subtitle = argument
        self.app.remember(session=argument)
        await self.chat.note(f"The session {old} is now called {argument}.")

    async def do_delete(self, argument: str) -> None:
        if not await self.bench.turns.may_begin():
            return
        names = {s.name for s in await self.backend.all_sessions()}
        if not argument:
            self.chat.entry.put("/delete ")
        elif argument == self.session.name:
            await self.chat.note("That session is open: /open another one first.", "error")
        elif argument not in names:
            await self.chat.note(f"There is no session {argument}; /open lists them.", "error")
        else:
            answers = {"k": ("", "keep it"), "d": ("delete", "delete it with all its turns")}
            question = f"Delete the session {argument}? This cannot be undone."
            dialog = Confirm(question, answers, by_key=False)
            self.app.push_screen(dialog, lambda answer: self._deleted(answer, argument))

    async def _deleted(self, answer: str | None, name: str) -> None:
        if answer == "delete":
            await self.backend.thread.do(lambda: self.backend.sessions.delete(name))
            await self.chat.note(f"The session {name} is deleted.")

    async def do_new(self, argument: str) -> None:
        self.opens()
        taken = {s.name for s in await self.backend.all_sessions()}
        name = argument or fresh_name(taken)
        made = f"Session {name} made."
        self.open_session(name, f"{name} is there already: opened." if name in taken else made)
