"""The results pane: outcome, requirements, events and plots of the run that stands, and a series of runs."""

from typing import Any

from textual.app import ComposeResult
from textual.binding import Binding
from textual.containers import VerticalScroll
from textual.content import Content
from textual.widgets import Static

from c2s_tui.desk import Desk
from c2s_tui.messages import CommandAsked
from c2s_tui.results.draw import report


class ResultsPane(VerticalScroll, can_focus=True):
    """Text that scrolls; `s` runs the program with more seeds."""

    BORDER_TITLE = "results"
    HELP_NAME = "results"
    BINDINGS = [
        Binding("s", "seeds", "20 seeds", id="results.seeds", tooltip="Run with 20 seeds and show which pass"),
        Binding("p", "picture", "Picture", id="results.picture", tooltip="Show the run from above"),
        Binding("escape", "close", "Close", id="results.close", tooltip="Cancel a series, or close the results"),
    ]

    def __init__(self, **options: Any):
        super().__init__(**options)
        self.desk = Desk()

    def compose(self) -> ComposeResult:
        yield Static(id="report", markup=False)

    def show(self, desk: Desk) -> None:
        """Take the desk; drawn only while the pane is open. Another run is shown from its outcome on."""
        if desk.facts is not self.desk.facts:
            self.scroll_home(animate=False)
        self.desk = desk
        self._draw()

    def on_resize(self) -> None:
        self._draw()

    def _draw(self) -> None:
        width = self.content_size.width
        if self.has_class("-on") and width > 10:
            self.query_one("#report", Static).update(report(self.desk, self.desk.gaps, width - 1))

    def empty(self) -> None:
        """Before it is opened: what it showed last may be of another program."""
        self.query_one("#report", Static).update(Content(""))

    def action_seeds(self) -> None:
        self.post_message(CommandAsked("seeds", "20"))

    def action_picture(self) -> None:
        self.post_message(CommandAsked("picture"))

    def action_close(self) -> None:
        self.post_message(CommandAsked("results", "close"))
