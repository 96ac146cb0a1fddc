"""The check of the code while it is being typed."""

from typing import TYPE_CHECKING

from c2s_tui.part import Part, background

if TYPE_CHECKING:
    from textual.timer import Timer

    from c2s_tui.workbench import Workbench

LIVE_SECONDS = 0.4
"""How long typing in the code must rest before the text is checked."""


class LiveCheck(Part):
    """Shows what is wrong with the text as it stands, before it is applied."""

    def __init__(self, bench: "Workbench"):
        super().__init__(bench)
        self._due: Timer | None = None

    def soon(self) -> None:
        """Check in a moment, once typing rests."""
        if self._due is not None:
            self._due.stop()
        self._due = self.bench.set_timer(LIVE_SECONDS, self.check)

    @background("live")
    async def check(self) -> None:
        """Check the text as it is being typed, when no turn runs; newer text cancels it."""
        code, turns = self.bench.code, self.bench.turns
        if not code.edited or turns.busy:
            return
        text, spans = code.area.text, code.side.spans
        try:
            report = await self.backend.check(text, spans=spans, upto="compile")
        except (ValueError, OSError, RuntimeError):
            return  # the turn that applies the text says why nothing can be checked
        if text == code.area.text and not turns.busy:
            code.show_findings(tuple(d for stage in report.stages for d in stage.diagnostics))
