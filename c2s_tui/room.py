"""Which pane is in front, zoom, and the row of keys."""

from textual.widget import Widget
from textual.widgets import Input, Tabs

from c2s_tui.columns import STEP, Columns
from c2s_tui.keys import KeyBar
from c2s_tui.part import Part

TABS = {"chat": "F2 chat", "sheet": "F3 S", "code": "F4 code", "results": "F6 results", "picture": "F9 picture"}
"""The panes as tabs, where there is room for one at a time."""
COLUMNS = {"chat": "#chat", "sheet": "#sheet", "code": "#right", "picture": "#right", "results": "#right"}
"""The column that a pane stands in."""


class Room(Part):
    """Panes and their room."""

    @property
    def current_pane(self) -> str:
        return next((n for n in TABS if self.pane(n).has_class("-current")), "chat")

    def pane(self, name: str) -> Widget:
        bench = self.bench
        panes: dict[str, Widget] = {"chat": bench.chat, "sheet": bench.sheet, "code": bench.code,
                                    "picture": bench.picture, "results": bench.results}  # fmt: skip
        return panes[name]

    def go_to(self, name: str) -> None:
        """Bring a pane to the front (narrow, or zoomed) and focus it."""
        self.in_front(name)
        if name == "code":
            self.bench.results.remove_class("-on")
            self.bench.query_one("#right").remove_class("-results")
        inner: dict[str, Widget] = {"chat": self.chat.entry, "code": self.bench.code.area}
        if lines := self.bench.sheet.query(Input):  # the field that is being edited
            inner["sheet"] = lines.first()
        target = inner.get(name, self.pane(name))
        if self.bench.has_class("-narrow") or self.bench.query_one("#panes").has_class("-zoom"):
            self.app.stylesheet.update(self.bench.query_one("#panes"))  # what is still hidden cannot take the focus
        self.bench.set_focus(target)  # at once: what is typed next is meant for it

    def in_front(self, name: str) -> None:
        for other in TABS:
            self.pane(other).set_class(other == name, "-current")
        self.bench.query_one("#right").set_class(COLUMNS[name] == "#right", "-current")
        tabs = self.bench.query_one(Tabs)
        with tabs.prevent(Tabs.TabActivated):  # tabs follow the pane; only one that the user chooses moves it
            tabs.active = f"tab-{name}"

    def pane_of_focus(self) -> str | None:
        around = set(self.bench.focused.ancestors_with_self) if self.bench.focused else set()
        return next((n for n in TABS if self.pane(n) in around), None)

    def follow_focus(self) -> None:
        """The pane that was given the focus is in front, and its keys are shown."""
        name = self.pane_of_focus()
        if name and name != self.current_pane and not self.bench.has_class("-narrow"):
            self.in_front(name)
        self.bench.call_after_refresh(self.show_keys)

    async def take_tab(self, name: str) -> None:
        """A tab was chosen."""
        if name != self.current_pane and self.bench.has_class("-narrow"):
            if name in ("results", "picture") and not self.pane(name).has_class("-on"):
                await self.bench.run_command(name)
            else:
                self.go_to(name)

    def show_keys(self) -> None:
        """The keys of what is focused."""
        self.bench.query_one(KeyBar).show(self.bench.focused, self.app.prefs.keys, self.app.size.width)

    async def do_zoom(self, _: str) -> None:
        """The focused pane alone on the screen, or all of them again."""
        panes = self.bench.query_one("#panes")
        self.in_front(self.pane_of_focus() or self.current_pane)
        panes.toggle_class("-zoom")

    async def do_wider(self, _: str) -> None:
        self._widen(STEP)

    async def do_narrower(self, _: str) -> None:
        self._widen(-STEP)

    def _widen(self, by: int) -> None:
        column = COLUMNS[self.pane_of_focus() or self.current_pane]
        self.bench.query_one(Columns).widen(column, by)

    async def do_chat(self, _: str) -> None:
        self.go_to("chat")

    async def do_sheet(self, _: str) -> None:
        self.go_to("sheet")

    async def do_code(self, _: str) -> None:
        self.go_to("code")

    def visit(self, cid: str) -> None:
        """Go to a component in the structure pane."""
        self.bench.sheet.point(cid)
        self.bench.code.point(cid)
        self.go_to("sheet")
