"""What was typed and neither sent nor applied, kept on disk."""

import asyncio
from typing import TYPE_CHECKING

from c2s_tui.part import Part, background

if TYPE_CHECKING:
    from c2s_tui.workbench import Workbench


class Drafts(Part):
    """Drafts of the panes in which one types."""

    def __init__(self, bench: "Workbench"):
        super().__init__(bench)
        self.typed: set[str] = set()  # the panes in which was typed since the last draft
        self.recovered = False  # the session's drafts are in the panes again

    def save(self, now: bool = False) -> None:
        """Swap to disk what was typed and neither sent nor applied; `now`: all of it, before this returns."""
        if self.bench.session is None or not (self.typed or now and self.recovered):
            return
        texts = {"chat": self.chat.entry.text, "code": self.bench.code.text if self.bench.code.edited else ""}
        typed, self.typed = self.typed, set()
        if now:  # what is being written from a thread at this moment may be older than what is there
            for pane in texts if self.recovered else typed:
                self.session.save_draft(pane, texts[pane])
        else:
            self._write({pane: texts[pane] for pane in typed})

    @background("drafts", exclusive=False)
    async def _write(self, texts: dict[str, str]) -> None:
        session = self.session

        def write() -> None:
            for pane, text in texts.items():
                session.save_draft(pane, text)

        await asyncio.to_thread(write)
