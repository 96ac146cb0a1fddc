"""Which pane is in front, how wide each is, and the row of keys (a mixin of the workbench)."""

from typing import Any

from textual.widgets import Tabs

from c2s_tui.keys import KeyBar

TABS = {"chat": "F2 chat", "sheet": "F3 S", "code": "F4 code", "results": "F6 results", "picture": "F9 picture"}
"""The panes as tabs, where there is room for one at a time."""
COLUMNS = {"chat": "#chat", "sheet": "#sheet", "code": "#right", "picture": "#right", "results": "#right"}
"""The column that a pane stands in."""
WIDTHS = {"#chat": 36, "#sheet": 46, "#right": 58}
"""Shares of the columns to begin with."""
STEP, LEAST, MOST = 6, 12, 500


class Layout:
    """Panes and their room."""

    async def on_tabs_tab_activated(self: Any, event: Tabs.TabActivated) -> None:
        name = (event.tab.id or "").removeprefix("tab-")
        if name != self.current_pane and self.has_class("-narrow"):
            if name in ("results", "picture") and not self._pane(name).has_class("-on"):
                await self.run_command(name)
            else:
                self.go_to(name)

    @property
    def current_pane(self: Any) -> str:
        return next((n for n in TABS if self._pane(n).has_class("-current")), "chat")

    def _pane(self: Any, name: str) -> Any:
        return {"chat": self.chat, "sheet": self.sheet, "code": self.code, "picture": self.picture,
                "results": self.results}[name]  # fmt: skip

    def on_resize(self: Any) -> None:
        self.call_after_refresh(self.show_status)
        self.call_after_refresh(self.show_keys)

    def go_to(self: Any, name: str) -> None:
        """Bring a pane to the front (narrow, or zoomed) and focus it."""
        self._in_front(name)
        if name == "code":
            self.results.remove_class("-on")
            self.query_one("#right").remove_class("-results")
        self.query_one(Tabs).active = f"tab-{name}"
        target = {"chat": self.chat.entry, "code": self.code.area}.get(name, self._pane(name))
        if self.has_class("-narrow") or self.query_one("#panes").has_class("-zoom"):
            self.app.stylesheet.update(self.query_one("#panes"))  # what is still hidden cannot take the focus
        self.set_focus(target)  # at once: what is typed next is meant for it

    def _in_front(self: Any, name: str) -> None:
        for other in TABS:
            self._pane(other).set_class(other == name, "-current")
        self.query_one("#right").set_class(COLUMNS[name] == "#right", "-current")

    def on_descendant_focus(self: Any) -> None:
        name = self._pane_of_focus()
        if name and name != self.current_pane and not self.has_class("-narrow"):
            self._in_front(name)
        self.call_after_refresh(self.show_keys)

    def _pane_of_focus(self: Any) -> str | None:
        around = set(self.focused.ancestors_with_self) if self.focused else set()
        return next((n for n in TABS if self._pane(n) in around), None)

    def show_keys(self: Any) -> None:
        """The keys of what is focused."""
        self.query_one(KeyBar).show(self.focused, self.app.prefs.keys, self.app.size.width)

    # Room.

    async def do_zoom(self: Any, _: str) -> None:
        """The focused pane alone on the screen, or all of them again."""
        panes = self.query_one("#panes")
        self._in_front(self._pane_of_focus() or self.current_pane)
        panes.toggle_class("-zoom")

    async def do_wider(self: Any, _: str) -> None:
        self._resize(STEP)

    async def do_narrower(self: Any, _: str) -> None:
        self._resize(-STEP)

    def _resize(self: Any, by: int) -> None:
        """Give the focused column more room, or less; the others share the rest. Kept for the next start."""
        column = COLUMNS[self._pane_of_focus() or self.current_pane]
        widths = self.widths()
        widths[column] = min(MOST, max(LEAST, widths[column] + by))
        self.app.remember(widths=" ".join(str(w) for w in widths.values()))
        self.lay_columns()

    def widths(self: Any) -> dict[str, int]:
        """The share of each column, as the user left it."""
        kept = self.app.prefs.widths.split()
        if len(kept) == len(WIDTHS) and all(w.isdigit() and LEAST <= int(w) <= MOST for w in kept):
            return dict(zip(WIDTHS, map(int, kept), strict=True))
        return dict(WIDTHS)

    def lay_columns(self: Any) -> None:
        """Give each column its share."""
        for column, width in self.widths().items():
            self.query_one(column).styles.width = f"{width}fr"
