"""The code pane: gutter, program, and the finding at the cursor."""

from collections.abc import Sequence
from typing import Any

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding
from textual.containers import Horizontal, Vertical
from textual.content import Content
from textual.widgets import Static, TextArea

from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.edits import Edit, SetProgram
from c2s_engine.structure.layout import merged
from c2s_engine.structure.program import Program
from c2s_tui.code.area import CodeArea
from c2s_tui.code.finder import Finder
from c2s_tui.code.fragments import changed_lines, moved_findings, moved_spans
from c2s_tui.code.gutter import Gutter
from c2s_tui.desk import Desk
from c2s_tui.look.kinds import mark
from c2s_tui.messages import CodeTyped, CommandAsked, EditsAsked, Picked


class CodePane(Vertical):
    """The live program. Hand edits are applied by key (SetProgram), or by the next turn; what the engine writes
    meanwhile is merged with them line by line."""

    BORDER_TITLE = "code"
    HELP_NAME = "code"
    BINDINGS = [
        Binding("ctrl+g", "external", "$EDITOR", show=False, id="code.external", tooltip="Edit the program in $EDITOR"),
        Binding("escape", "drop", "Back", show=False, id="code.leave", tooltip="Cancel what runs; what is typed stays"),
    ]

    def __init__(self, **options: Any):
        super().__init__(**options)
        self.desk = Desk()
        self.base = self.desk.program  # the program that the shown text was edited from
        self._shown_text = ""  # that program as the text area has it: line ends of one kind
        self._handed: str | None = None  # the text that the turn under way has taken, until it writes a program
        self._live: tuple[str, tuple[Diagnostic, ...]] | None = None  # found while typing, in that text
        self._subtitle = ""
        self._begins = False  # a program has come and was not shown yet
        self._shown = Content("")

    def compose(self) -> ComposeResult:
        with Horizontal(id="code-body"):
            yield Gutter()
            yield CodeArea(id="code")
        yield Finder(id="finder")
        yield Static(id="finding", markup=False)

    def on_mount(self) -> None:
        self.watch(self.area, "scroll_y", lambda y: self.side.show(top=round(y)), init=False)

    @property
    def area(self) -> CodeArea:
        return self.query_one(CodeArea)

    @property
    def side(self) -> Gutter:
        return self.query_one(Gutter)

    @property
    def edited(self) -> bool:
        """Whether the shown text differs from the session's program."""
        return self.area.text != self._shown_text

    @property
    def text(self) -> str:
        """The program with what was typed; every line that was not touched is as it was, its ending too."""
        return merged(self._shown_text, self.area.text, self.base.text)

    def show(self, desk: Desk) -> None:
        """Draw the desk. What has been typed meanwhile stays in the text."""
        same = desk.program == self.desk.program and desk.before == self.desk.before
        if same and not self.edited and desk.diagnostics == self.desk.diagnostics and self._live is None:
            self.desk = desk
            return
        self.desk = desk
        first = not self.base.text and bool(desk.program.text)
        if desk.program.text != self.base.text:
            since = self.base.text if self._handed is None else self._handed
            typed, self._handed = merged(since, self.text, desk.program.text), None
            self.area.replace_text(desk.program.text)
            self._shown_text = self.area.text
            self.area.replace_text(typed)
            if not self.edited:  # keys undo what was typed; a turn is undone as a whole
                self.area.history.clear()
        self.base = desk.program
        if not self.edited:
            self._live = None
        self._draw()
        if first:
            self._begins = True
            self.call_after_refresh(self._begin_at_ego)

    def on_resize(self) -> None:
        self.call_after_refresh(self._begin_at_ego)

    def _begin_at_ego(self) -> None:
        """What is looked for first in a program is ego, not settings and imports: shown once the pane has its height,
        unless one has gone somewhere before."""
        if self._begins and self.area.size.height:
            self._begins = False
            if not self.area.has_focus or self.area.cursor_location == (0, 0):
                self.point("E", scroll=True)

    def empty(self) -> None:
        """Forget the text, its marks and its history: another session's comes."""
        self.desk = Desk()  # also where the next one has the same program, as the example has that was shown before
        self.base, self._shown_text, self._live = Program(text=""), "", None
        with self.prevent(TextArea.Changed):
            self.area.load_text("")
        self.side.show(here=None)
        self._draw()

    def show_findings(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        """Findings of a check of the text as it is being typed."""
        self._live = self.area.text, diagnostics
        self._draw()

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """What is known to be wrong with the text as it stands."""
        text, found = self._live or (self.desk.program.text, self.desk.diagnostics)
        return moved_findings(found, text, self.area.text)

    def _draw(self) -> None:
        self.area.show_problems(self.diagnostics)
        before = self._shown_text if self.edited else self.desk.before
        changed = changed_lines(before, self.area.text) if before else frozenset()
        self.side.show(
            top=round(self.area.scroll_y), spans=moved_spans(self.base, self.area.text), changed=changed,
            problems=dict(self.area.problems), rows=self.area.shown,
        )  # fmt: skip
        self._entitle("edited: F5 applies the changes" if self.edited else "")
        self._show_finding()

    def _entitle(self, words: str) -> None:
        if words != self._subtitle:  # setting it draws the whole pane
            self._subtitle = self.border_subtitle = words

    def _show_finding(self) -> None:
        strip = self.query_one("#finding", Static)
        words = self._finding_words()
        if strip.display != bool(self.diagnostics):
            strip.display = bool(self.diagnostics)
        if words != self._shown:  # an update lays the screen out
            self._shown = words
            strip.update(words)

    def _finding_words(self) -> Content:
        found = self.finding
        if found is None:
            count = len(self.diagnostics)
            return Content.styled(f"{count} finding{'s' * (count > 1)}: F8 goes to the next", "$muted")
        colour = {"error": "$text-error", "warning": "$text-warning"}.get(found.severity, "$muted")
        where = " ".join(filter(None, [found.stage, found.component or "", f"line {found.line}" if found.line else ""]))
        parts: list = [(f"{mark(found.severity)} {where}: ", colour), found.message]
        if found.fix:
            parts += [("\nfix: ", "bold"), found.fix]
            if found.edit:
                parts.append(("  Ctrl+T applies it", "$muted"))
        return Content.assemble(*parts)

    @property
    def finding(self) -> Diagnostic | None:
        """The finding at the cursor's line; else one that has no line."""
        line = self.area.cursor_location[0] + 1
        at = self.area.problems.get(line)
        return at or next((d for d in self.diagnostics if not d.line), None)

    def point(self, cid: str, line: int | None = None, scroll: bool = False) -> None:
        """Show a component's fragment, without taking the focus; `scroll`: also where the cursor is in it."""
        self._begins = False
        self.side.show(here=cid)
        span = next((s for s in self.side.spans if s.component == cid), None)
        if span is None:
            return
        row = (line or span.first) - 1
        if not span.first <= self.area.cursor_location[0] + 1 <= span.last or line or scroll:
            with self.prevent(TextArea.SelectionChanged):
                self.area.move_cursor((row, 0))
            self.area.scroll_to(y=max(0, row - 2), animate=False)

    @property
    def hand_edit(self) -> tuple[SetProgram, ...]:
        """What was typed and is not applied."""
        return (SetProgram(text=self.text),) if self.edited else ()

    def hand_over(self, edits: Sequence[Edit]) -> None:
        """A turn makes those edits: where the shown text is among them, what it writes of it takes its place, and only
        what is typed from now on is not applied."""
        given = next((e.text for e in reversed(edits) if isinstance(e, SetProgram)), None)
        self._handed = given if given == self.text else None

    def toggle_fold(self, which: str = "") -> None:
        """Fold what follows a component's first line away, or show it again: the component at the cursor, one by id,
        `all` (but the one at the cursor) or `none`."""
        spans, line = self.side.spans, self.area.cursor_location[0] + 1
        here = self.side.component_at(line)
        folded = {s.component for s in spans if s.first in self.area.hidden}
        if which in ("all", "none"):
            folded = {s.component for s in spans if s != here} if which == "all" else set()
        elif cid := which or (here.component if here else ""):
            folded ^= {cid}
        if here and here.component in folded:
            self.area.move_cursor((here.first - 1, 0))
        self.area.fold(row for s in spans if s.component in folded for row in range(s.first, s.last))
        self.side.show(rows=self.area.shown)

    def commit(self) -> bool:
        """Ask for the hand edits to be taken; whether there were any."""
        edits = self.hand_edit
        if edits:
            self.post_message(EditsAsked(()))
        return bool(edits)

    @on(TextArea.Changed)
    def _changed(self, event: TextArea.Changed) -> None:
        event.stop()
        if not self.edited:
            self._live = None
        self._draw()
        self.post_message(CodeTyped())

    @on(TextArea.SelectionChanged)
    def _moved(self, event: TextArea.SelectionChanged) -> None:
        event.stop()
        line = self.area.cursor_location[0] + 1
        span = self.side.component_at(line)
        self._show_finding()
        self.side.show(rows=self.area.shown)
        if span and self.area.has_focus:
            self.side.show(here=span.component)
            self.post_message(Picked(span.component, "code", line))

    @property
    def finder(self) -> Finder:
        return self.query_one(Finder)

    def go_to_line(self, line: int) -> None:
        """Put the cursor on a line (from 1; the nearest there is)."""
        self.area.focus()
        self.area.move_cursor((max(0, min(line, self.area.document.line_count) - 1), 0), center=True)

    def next_finding(self) -> None:
        """Go to the next line that has a finding."""
        lines = sorted(self.area.problems)
        if lines:
            here = self.area.cursor_location[0] + 1
            after = next((n for n in lines if n > here), lines[0])
            self.go_to_line(after)

    def take_fix(self) -> None:
        """Make the fix that the finding at the cursor offers, and apply it, unless more was typed."""
        found = self.finding
        if found is None or found.edit is None:
            why = "This finding has no fix that can be made for you: mend the line by hand."
            self.app.notify(why if found else "There is no finding at the cursor: F8 goes to the next.", markup=False)
            return
        edit, before = found.edit, self.edited
        last = self.area.document.get_line(edit.last - 1)
        self.area.replace(edit.text.rstrip("\n"), (edit.first - 1, 0), (edit.last - 1, len(last)))
        if not before:
            self.commit()

    def action_external(self) -> None:
        self.post_message(CommandAsked("editor"))

    def action_drop(self) -> None:
        self.post_message(CommandAsked("cancel"))
