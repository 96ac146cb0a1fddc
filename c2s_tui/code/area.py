"""The editable program with Scenic's highlighting."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from rich.segment import Segment
from rich.style import Style
from rich.text import Text
from textual import getters
from textual.binding import Binding
from textual.document._document import Selection
from textual.events import Key
from textual.geometry import Offset, Region, Spacing
from textual.reactive import Reactive, reactive
from textual.strip import Strip
from textual.widgets.text_area import TextAreaTheme

from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.layout import common
from c2s_tui.app import C2SApp
from c2s_tui.code.document import ProgramText, UnwrappedText
from c2s_tui.code.folding import FoldedNavigator, Folding
from c2s_tui.code.highlight import Blocks, Highlight, stale
from c2s_tui.look.kinds import look

if TYPE_CHECKING:
    from c2s_tui.code.vim import Vim


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


KEPT_ROWS = 5000


class CodeArea(Folding):
    """A TextArea whose highlights come from Pygments (Textual's own are tree-sitter's)."""

    HELP_NAME = "code"
    BINDINGS = [
        Binding("ctrl+home", "go('start')", "First line", show=False, id="code.start", tooltip="Go to the first line"),
        Binding("ctrl+end", "go('end')", "Last line", show=False, id="code.end", tooltip="Go to the last line"),
    ]
    app = getters.app(C2SApp)
    selection: Reactive[Selection] = reactive(Selection(), init=False, always_update=True, repaint=False)
    """As in TextArea, where each key draws the whole pane anew: here only the rows that it touches."""

    def __init__(self, **options: Any):
        self.problems: dict[int, Diagnostic] = {}
        self.vim: Vim | None = None  # Vim's keys, where they are wanted
        self._blocks = Blocks()
        self._plain: dict[Any, Strip] = {}  # by text and highlights of a row
        super().__init__(
            "", language=None, soft_wrap=False, show_line_numbers=True, tab_behavior="indent", compact=True, **options
        )

    def use_vim(self, on: bool) -> None:
        """Take Vim's keys, or no longer."""
        from c2s_tui.code.vim import Vim

        self.vim = Vim(self) if on else None
        self.tell_mode()

    def tell_mode(self) -> None:
        """Name the mode in the title of the pane."""
        self.screen.query_one("#code-pane").border_title = f"code: {self.vim.mode} mode" if self.vim else "code"

    async def _on_key(self, event: Key) -> None:
        if self.vim is not None and self.vim.take(event):
            event.stop()
            event.prevent_default()
            self.tell_mode()
            return
        if event.key == "enter" and not self.read_only:
            event.stop()
            event.prevent_default()
            self.insert("\n" + self._indent())
            return
        if event.key == "escape":  # to the pane; TextArea's would take the focus away, and what is typed next with it
            event.prevent_default()

    def _indent(self) -> str:
        """With what a line after the cursor's begins: as far in as that one, a step further behind a colon."""
        row, column = self.cursor_location
        before = str(self.document.get_line(row))[:column]
        margin = before[: len(before) - len(before.lstrip())]
        return margin + " " * self.indent_width if before.partition("#")[0].rstrip().endswith(":") else margin

    def action_go(self, where: str) -> None:
        """Put the cursor at the start or the end of the program."""
        self.move_cursor((0, 0) if where == "start" else self.document.end)

    def action_undo(self) -> None:
        """Take back what was typed last. What a turn wrote is not typed: that turn is undone as a whole."""
        if self.history.undo_stack:
            super().action_undo()
        else:
            words = "Nothing typed here is left to undo. To undo the last turn: u in S, or /undo."
            self.app.notify(words, markup=False)

    def on_mount(self) -> None:
        self._dress()
        if self.app.prefs.vim:
            self.call_after_refresh(self.use_vim, True)
        self.app.theme_changed_signal.subscribe(self, lambda _: self._dress())

    def _dress(self) -> None:
        self._plain.clear()
        theme = code_theme(self.app.theme)
        self.register_theme(theme)
        self.theme = theme.name

    def _set_document(self, text: str, language: str | None) -> None:
        self.document = ProgramText(text)
        self.wrapped_document = UnwrappedText(self.document, tab_width=self.indent_width)
        self.navigator = FoldedNavigator(self.wrapped_document)
        self._build_highlight_map()
        self.move_cursor((0, 0))
        self._rewrap_and_refresh_virtual_size()

    def _build_highlight_map(self) -> None:
        """Called by Textual after each change of the text: only what may look different is drawn anew."""
        before, self._blocks = self._blocks, Blocks(self.document.lines)
        self._highlights = _Highlights(self._blocks, self.problems)  # type: ignore[assignment]
        first, after = stale(before, self._blocks)
        kept = [(key, strip) for key, strip in self._drawn() if not first <= key[2] < after]
        self._line_cache.clear()
        for key, strip in kept:
            self._line_cache[key] = strip
        if after > first:
            self.refresh_lines(first, after - first)

    def _watch_selection(self, previous_selection: Selection, selection: Selection) -> None:
        """Draw the rows that were and that are selected, have the cursor or its bracket."""
        if selection.end[0] in self.hidden:  # found, gone to, or stepped into
            self.fold(())
        brackets = [self._matching_bracket_location]
        super()._watch_selection(previous_selection, selection)
        brackets.append(self._matching_bracket_location)
        for place in (previous_selection, selection, *(Selection(b, b) for b in brackets if b)):
            first, last = sorted((place.start[0], place.end[0]))
            self.refresh_lines(first, last - first + 1)

    def _render_line(self, y: int) -> Strip:
        """As TextArea draws it; a row without cursor, selection or bracket is a cut from what was made for its text."""
        left, top = self.scroll_offset
        shown = self.shown
        row = top + y if shown is None else shown[top + y] if top + y < len(shown) else self.document.line_count
        first, last = sorted((self.selection.start[0], self.selection.end[0]))
        bracket = self._matching_bracket_location
        if row >= self.document.line_count or first <= row <= last or bracket and bracket[0] == row or not self._theme:
            return super()._render_line(y)
        base = self._theme.base_style or self.rich_style
        width = max(self.virtual_size.width, self.region.width) - self.gutter_width
        text = self._text_strip(row).crop(left, left + self.virtual_size.width).extend_cell_length(width, base)
        number = Segment(f"{row + self.line_number_start:>{self.gutter_width - 2}}  ", self._theme.gutter_style)
        return Strip.join([Strip([number], self.gutter_width), text]).apply_style(base)

    def _text_strip(self, row: int) -> Strip:
        """A whole row in its colours, made once for equal rows."""
        line, spans = self.document.get_line(row), tuple(self._highlights[row])
        strip = self._plain.get((line, spans))
        if strip is None:
            text, raw = Text(line + " ", end="", no_wrap=True), line.encode()
            for start, end, name in spans:
                style = self._theme.syntax_styles.get(name) if self._theme else None
                if style is not None:
                    text.stylize(style, len(raw[:start].decode()), len(raw[:end].decode()))
            text.expand_tabs(self.indent_width)
            strip = Strip(text.render(self.app.console), cell_length=text.cell_len)
            if len(self._plain) > KEPT_ROWS:
                self._plain.clear()
            self._plain[line, spans] = strip
        return strip

    def scroll_cursor_visible(self, center: bool = False, animate: bool = False) -> Offset:
        """As in TextArea, but sideways by a third of the pane, not by a column a key, which draws every row anew."""
        self._recompute_cursor_offset()
        x, y = self._cursor_offset
        seen = self.scrollable_content_region.width - self.gutter_width
        room, left = seen // 3, self.scroll_offset.x
        if center or not self._has_cursor or room < 3 or left <= x <= left + seen - 3:
            return super().scroll_cursor_visible(center, animate)
        area = Region(x, y, room, 1) if x > left else Region(max(0, x - room), y, room, 1)
        return self.scroll_to_region(area, spacing=Spacing(right=self.gutter_width), animate=animate, force=True)

    def _drawn(self) -> list[tuple[Any, Any]]:
        """The lines that are drawn already: Textual's key (its third part is the row) and the strip."""
        return [(key, self._line_cache[key]) for key in list(self._line_cache.keys())]

    def show_problems(self, diagnostics: Iterable[Diagnostic]) -> None:
        """Underline the lines that have a finding; the first one of a line counts."""
        found: dict[int, Diagnostic] = {}
        for diagnostic in diagnostics:
            if diagnostic.line:
                found.setdefault(diagnostic.line, diagnostic)
        if found == self.problems:
            return
        rows = {line - 1 for line in _underlined(found) ^ _underlined(self.problems)}
        self.problems = found
        self._highlights.problems = found  # type: ignore[attr-defined]
        kept = [(key, strip) for key, strip in self._drawn() if key[2] not in rows]
        self._line_cache.clear()
        for key, strip in kept:
            self._line_cache[key] = strip
        for row in rows:
            self.refresh_lines(row)

    def replace_text(self, text: str) -> None:
        """Show another program; cursor and scroll stay at the text where they were."""
        if text == self.text:
            return
        if not self.text:
            with self.prevent(self.Changed):
                self.load_text(text)
            return
        old, new = self.document.lines, text.replace("\r\n", "\n").split("\n")
        head = common(old, new)
        tail = common(old[head:][::-1], new[head:][::-1])
        first, last = (head, 0), (len(old) - tail, 0)
        lines = new[head : len(new) - tail]
        insert = "\n".join([*lines, ""]) if lines else ""
        if not tail:  # up to the end, which ends no line
            first = (head - 1, len(old[head - 1])) if head else (0, 0)
            last = (len(old) - 1, len(old[-1]))
            insert = "\n".join(["", *lines] if head else lines)
        at = self.scroll_offset
        with self.prevent(self.Changed):
            self.replace(insert, first, last)
        self.scroll_to(at.x, at.y, animate=False, force=True)


def _underlined(problems: dict[int, Diagnostic]) -> set[int]:
    """The lines (1-based) that are underlined."""
    return {line for line, problem in problems.items() if problem.severity != "info"}


class _Highlights:
    """What Textual looks a row's highlights up in: the lexer's, and the line under a finding."""

    def __init__(self, blocks: Blocks, problems: dict[int, Diagnostic]):
        self.blocks, self.problems = blocks, problems

    def __getitem__(self, row: int) -> list[Highlight]:
        spans = self.blocks[row]
        problem = self.problems.get(row + 1)
        if problem is not None and problem.severity != "info":
            text = self.blocks.lines[row]
            spans.append((len(text) - len(text.lstrip()), len(text.encode()), "problem"))
        return spans

    def __len__(self) -> int:
        return len(self.blocks)
