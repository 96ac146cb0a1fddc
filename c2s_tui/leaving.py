"""Leaving the app."""

from c2s_tui.part import Part
from c2s_tui.screens.dialogs import Confirm
from c2s_tui.status import StatusBar


class Leaving(Part):
    """Asks once where something would be lost."""

    async def do_quit(self, _: str) -> None:
        """Leave; where work would be lost or broken off, ask once."""
        reasons = []
        if self.bench.turns.busy:
            reasons.append("a turn is still running")
        if self.bench.code.edited:
            reasons.append("the code has hand edits that are not applied")
        file = self.bench.files.unsaved
        if file is not None:
            reasons.append(f"{file.name} has unsaved changes")
        if not reasons:
            await self.leave()
            return
        answers = {
            "q": ("quit", "quit (drafts are kept)"),
            "s": ("save", "save the file and quit"),
            "b": ("", "go back"),
        }
        if self.bench.files.file is None:
            del answers["s"]

        async def decided(answer: str | None) -> None:
            if answer == "save":
                await self.bench.files.do_save("")
            if answer == "quit" or answer == "save" and self.bench.files.unsaved is None:  # else it asks
                await self.leave()

        self.app.push_screen(Confirm(f"Leave? {'; '.join(reasons).capitalize()}.", answers), decided)

    async def leave(self) -> None:
        """Say so, which is drawn before what may take a moment."""
        self.bench.query_one(StatusBar).tell_end()
        self.bench.call_after_refresh(self._end)

    def _end(self) -> None:
        """Save drafts, close everything, end the app."""
        self.bench.drafts.save(now=True)
        self.bench.workers.cancel_all()
        self.app.exit()
