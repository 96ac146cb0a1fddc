"""The editable program with Scenic's highlighting."""

from collections.abc import Iterable

from rich.style import Style
from textual.widgets import TextArea
from textual.widgets.text_area import TextAreaTheme

from c2s_engine.structure.diagnostics import Diagnostic
from c2s_tui.code.highlight import highlights
from c2s_tui.look.kinds import look


def code_theme(app_theme: str) -> TextAreaTheme:
    """The colours of code under a theme of the app."""
    column = {"c2s-dark": 0, "c2s-light": 1, "c2s-ansi": 2}.get(app_theme)
    styles = {}
    for name, entry in look()["syntax"].items():
        colour = entry[column].removeprefix("ansi_") if column is not None else None
        styles[name] = Style.parse(f"{entry[3]} {colour or ''}".strip() or "none")
    red = {0: "#e0707a", 1: "#b42318", 2: "red"}.get(column) if column is not None else None
    styles["problem"] = Style.parse(f"underline {red or ''}")
    return TextAreaTheme(name=f"c2s:{app_theme}", syntax_styles=styles)


class CodeArea(TextArea):
    """A TextArea whose highlights come from Pygments (Textual's own are tree-sitter's)."""

    HELP_NAME = "code"

    def __init__(self, **options):
        self.problems: dict[int, Diagnostic] = {}
        super().__init__(
            "", language=None, soft_wrap=False, show_line_numbers=True, tab_behavior="indent", compact=True, **options
        )

    def on_mount(self) -> None:
        self._dress()
        self.app.theme_changed_signal.subscribe(self, lambda _: self._dress())

    def _dress(self) -> None:
        theme = code_theme(self.app.theme)
        self.register_theme(theme)
        self.theme = theme.name

    def _build_highlight_map(self) -> None:
        self._line_cache.clear()
        self._highlights.clear()
        for row, spans in highlights(self.document.text).items():
            self._highlights[row] = list(spans)
        for line, problem in self.problems.items():
            if problem.severity != "info" and line <= self.document.line_count:
                text = self.document[line - 1]
                first = len(text) - len(text.lstrip())
                self._highlights[line - 1].append((first, len(text.encode()), "problem"))

    def show_problems(self, diagnostics: Iterable[Diagnostic]) -> None:
        """Underline the lines that have a finding; the first one of a line counts."""
        found: dict[int, Diagnostic] = {}
        for diagnostic in diagnostics:
            if diagnostic.line:
                found.setdefault(diagnostic.line, diagnostic)
        if found != self.problems:
            self.problems = found
            self._build_highlight_map()
            self.refresh()

    def replace_text(self, text: str) -> None:
        """Show another program; cursor and scroll stay where they can, and the change can be undone by key."""
        if text == self.text:
            return
        row, column = self.cursor_location
        at = self.scroll_offset
        with self.prevent(TextArea.Changed):
            self.load_text(text)
        last = self.document.line_count - 1
        self.move_cursor((min(row, last), column if row <= last else 0))
        self.scroll_to(at.x, at.y, animate=False, force=True)
