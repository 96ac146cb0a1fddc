"""The strip beside the code: whose fragment a line is, what is new in it, what is wrong with it."""

from rich.segment import Segment
from rich.style import Style
from textual.events import Click
from textual.geometry import Region, Size
from textual.strip import Strip
from textual.widget import Widget

from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.program import FragmentSpan
from c2s_tui.look.kinds import mark
from c2s_tui.messages import Picked

WIDTH = 6


class Gutter(Widget):
    """Six cells: a mark of what changed, the component's id at its first line, a mark of what is wrong."""

    COMPONENT_CLASSES = {f"gutter--{name}" for name in ("g", "r", "e", "o", "t", "changed", "error", "warning", "info")}

    def __init__(self) -> None:
        super().__init__()
        self.top = 0
        self.spans: tuple[FragmentSpan, ...] = ()
        self.changed: frozenset[int] = frozenset()
        self.problems: dict[int, Diagnostic] = {}
        self.here: str | None = None
        self.rows: list[int] | None = None  # of the text, one for each of the screen, where some are folded away
        self._styles: dict[str, Style] = {}  # of one drawing

    def show(self, **values) -> None:
        """Set any of top, spans, changed, problems, here, rows; draws only if something differs."""
        if any(getattr(self, name) != value for name, value in values.items()):
            for name, value in values.items():
                setattr(self, name, value)
            self.refresh()

    def get_content_width(self, container: Size, viewport: Size) -> int:
        return WIDTH

    def line_at(self, y: int) -> int:
        """The line (from 1) of the text that a row of the screen shows."""
        at = self.top + y
        return at + 1 if self.rows is None else self.rows[at] + 1 if at < len(self.rows) else 0

    def folded(self, line: int) -> bool:
        """Whether what follows a line is folded away."""
        if self.rows is None or line - 1 not in self.rows:
            return False
        at = self.rows.index(line - 1)
        return at + 1 < len(self.rows) and self.rows[at + 1] != line

    def component_at(self, line: int) -> FragmentSpan | None:
        return next((s for s in self.spans if s.first <= line <= s.last), None)

    def render_lines(self, crop: Region) -> list[Strip]:
        """Styles are looked up once a drawing, not once a row."""
        self._styles = {"": self.rich_style}
        return super().render_lines(crop)

    def render_line(self, y: int) -> Strip:
        line = self.line_at(y)
        base = self._style("")
        span = self.component_at(line)
        changed, problem = line in self.changed, self.problems.get(line)
        sign = mark("closed") if self.folded(line) else mark("changed") if changed else " "
        segments = [self._cell(sign, "changed", base)]
        if span is None:
            segments.append(Segment("    ", base))
        else:
            style = base + self._style(span.component[0].lower())
            bold = Style(bold=True, reverse=span.component == self.here)
            if line == span.first:
                label = span.component
                segments += [Segment(label, style + bold), Segment(" " * (4 - len(label)), base)]
            else:
                segments.append(Segment(f"{mark('rule')}   ", style))
        segments.append(self._cell(mark(problem.severity), problem.severity, base) if problem else Segment(" ", base))
        return Strip(segments, WIDTH)

    def _cell(self, text: str, name: str, base: Style) -> Segment:
        return Segment(text, base + self._style(name))

    def _style(self, name: str) -> Style:
        if name not in self._styles:
            self._styles[name] = (
                self.get_component_rich_style(f"gutter--{name}", partial=True) if name else self.rich_style
            )
        return self._styles[name]

    def on_click(self, event: Click) -> None:
        line = self.line_at(event.y)
        if span := self.component_at(line):
            self.post_message(Picked(span.component, "gutter", line))
