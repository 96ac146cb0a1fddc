"""Turns and sessions as lists with names and dates: go back, rename, delete (a mixin of the workbench)."""

from datetime import datetime
from typing import Any

from textual import work

from c2s_tui.screens.dialogs import Choosable, Chooser, Confirm


def when(seconds: float) -> str:
    """A moment as a person reads it."""
    return datetime.fromtimestamp(seconds).strftime("%Y-%m-%d %H:%M")


def turns(session: Any) -> list[Choosable]:
    """The turns that led here and those that were undone, the newest first; the value is a turn's index."""
    here, undone = session.history, session.undone
    marked = [(t, "here" if t is here[-1] else "") for t in here] + [(t, "undone") for t in undone]
    found = []
    for turn, word in reversed(marked):
        label = f"{turn.index + 1:>3}  {when(turn.when)}  {turn.text[:44]}"
        found.append(Choosable(str(turn.index), label, f"{turn.summary[:40]}  {word}".rstrip()))
    return [*found, Choosable("-1", "  0  before the first turn", "" if here else "here")]


class Past:
    """Commands that concern what was done, and sessions as a whole."""

    async def do_history(self: Any, _: str) -> None:
        if await self._may_begin():
            self.offer_turns()

    @work(group="choices", exclusive=True, exit_on_error=False)
    async def offer_turns(self: Any) -> None:
        """The list of turns; choosing one goes to where it left S."""
        here = str(len(self.session.history) - 1)
        foot = "Enter returns to the state after that turn; later turns can be redone"
        chosen = await self.app.push_screen_wait(Chooser("Turns", turns(self.session), here, foot=foot, wide=True))
        if chosen is not None and chosen != here and await self._may_begin():
            self.turn(lambda: self.session.back_to(int(chosen)), "going back")

    @work(group="choices", exclusive=True, exit_on_error=False)
    async def offer_sessions(self: Any) -> None:
        """The sessions, the one used last first."""
        found = await self.backend.thread.do(self.backend.sessions.list)
        entries = [Choosable(s.name, s.name, f"{when(s.updated)}  {s.turns} turns  {s.last[:40]}") for s in found]
        current = self.session.name if self.session else ""
        foot = "Enter opens; /rename NAME and /delete NAME in the chat"
        chosen = await self.app.push_screen_wait(
            Chooser("Sessions", entries, current, free="type to filter, or a new session's name", foot=foot, wide=True)
        )
        if chosen:
            self.open_session(chosen)

    async def do_rename(self: Any, argument: str) -> None:
        if not await self._may_begin():
            return
        if not argument:
            self.chat.entry.put("/rename ")
            return
        from c2s_engine.session.errors import SessionError

        old = self.session.name
        try:
            await self.backend.thread.do(lambda: self.backend.sessions.rename(old, argument))
        except SessionError as error:
            await self.chat.note(self._sentence(error), "error")
            return
        self.session.name = self.chat.border_subtitle = argument
        self.app.remember(session=argument)
        await self.chat.note(f"The session {old} is now called {argument}.")

    async def do_delete(self: Any, argument: str) -> None:
        if not await self._may_begin():
            return
        names = {s.name for s in await self.backend.thread.do(self.backend.sessions.list)}
        if not argument:
            self.chat.entry.put("/delete ")
        elif argument == self.session.name:
            await self.chat.note("That session is open: /open another one first.", "error")
        elif argument not in names:
            await self.chat.note(f"There is no session {argument}; /open lists them.", "error")
        else:
            answers = {"d": ("delete", "delete it with all its turns"), "k": ("", "keep it")}
            question = f"Delete the session {argument}? This cannot be undone."
            self.app.push_screen(Confirm(question, answers), lambda answer: self._deleted(answer, argument))

    async def _deleted(self: Any, answer: str | None, name: str) -> None:
        if answer == "delete":
            await self.backend.thread.do(lambda: self.backend.sessions.delete(name))
            await self.chat.note(f"The session {name} is deleted.")
