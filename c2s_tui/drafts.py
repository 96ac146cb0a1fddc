"""What was typed and neither sent nor applied, kept on disk."""

import asyncio
from typing import TYPE_CHECKING

from c2s_tui.part import Part, background

if TYPE_CHECKING:
    from c2s_engine.session.session import Session
    from c2s_tui.workbench import Workbench


class Drafts(Part):
    """Drafts of the panes in which one types. What is on the disk follows what is in the panes: a draft is gone as soon
    as it was sent or applied."""

    def __init__(self, bench: "Workbench"):
        super().__init__(bench)
        self.kept: dict[str, str] = {}  # what is on the disk
        self.recovered = False  # the session's drafts are in the panes again

    def opened(self, session: "Session") -> None:
        """From now on the drafts are those of a session that was opened; that of the code is not in its pane yet."""
        self.kept, self.recovered = {pane: session.draft(pane) for pane in ("chat", "code")}, False

    def save(self, now: bool = False) -> None:
        """Swap to disk what was typed and neither sent nor applied; `now`: all of it, before this returns."""
        if self.bench.session is None:
            return
        left = self.bench.sessions.left
        texts = {"chat": self.chat.entry.draft if left is None else left}
        if self.recovered:
            texts["code"] = self.bench.code.text if self.bench.code.edited else ""
        if now:  # what is being written from a thread at this moment may be older than what is there
            _keep(self.session, texts, self.kept)
        elif changed := {pane: text for pane, text in texts.items() if text != self.kept[pane]}:
            self._write(changed)

    @background("drafts", exclusive=False)
    async def _write(self, texts: dict[str, str]) -> None:
        await asyncio.to_thread(_keep, self.session, texts, self.kept)


def _keep(session: "Session", texts: dict[str, str], kept: dict[str, str]) -> None:
    for pane, text in texts.items():
        session.save_draft(pane, text)
        kept[pane] = text
