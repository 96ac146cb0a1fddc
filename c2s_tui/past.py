"""The turns of a session as a list to go back and forward in."""

from datetime import datetime
from typing import TYPE_CHECKING

from c2s_tui.part import Part, background
from c2s_tui.screens.dialogs import Choosable, Chooser

if TYPE_CHECKING:
    from c2s_engine.session.session import Session


def when(seconds: float) -> str:
    """A moment as a person reads it."""
    return datetime.fromtimestamp(seconds).strftime("%Y-%m-%d %H:%M")


def turns(session: "Session") -> list[Choosable]:
    """The turns that led here and those that were undone, the newest first; the value is a turn's index."""
    here, undone = session.history, session.undone
    marked = [(t, "here" if t is here[-1] else "") for t in here] + [(t, "undone") for t in undone]
    found = []
    for turn, word in reversed(marked):
        label = f"{turn.index + 1:>3}  {when(turn.when)}  {turn.text[:44]}"
        came = "a question" if turn.asked else turn.summary[:40]
        found.append(Choosable(str(turn.index), label, f"{came}  {word}".rstrip()))
    return [*found, Choosable("-1", "  0  before the first turn", "" if here else "here")]


class Past(Part):
    """What was done in this session."""

    async def do_history(self, _: str) -> None:
        if await self.bench.turns.may_begin():
            self.offer_turns()

    @background("choices")
    async def offer_turns(self) -> None:
        """The list of turns; choosing one goes to where it left S."""
        here = str(len(self.session.history) - 1)
        foot = "Enter returns to the state after that turn; later turns can be redone"
        chosen = await self.app.push_screen_wait(Chooser("Turns", turns(self.session), here, foot=foot, wide=True))
        if chosen is not None and chosen != here and await self.bench.turns.may_begin():
            self.bench.turns.turn(lambda: self.session.back_to(int(chosen)), "going back")
