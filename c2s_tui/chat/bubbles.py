"""The kinds of entries in the conversation."""

from typing import TYPE_CHECKING

from textual.app import ComposeResult
from textual.containers import Vertical
from textual.content import Content
from textual.events import Click
from textual.widgets import Static

from c2s_engine.retrieve.provenance import attribution
from c2s_engine.structure.progress import Passage
from c2s_tui.look.kinds import colour, mark, mentions
from c2s_tui.messages import CommandAsked, Picked

if TYPE_CHECKING:
    from textual.widgets.markdown import MarkdownStream

LOST = {"background": "$text-muted", "not_expressible": "underline $text-warning",
        "not_understood": "underline $text-error"}  # fmt: skip
Marked = tuple
"""Pairs of a component and the span (first, after the last character) of the words that it rests on."""


class Line(Static):
    """One thing said: by the user, by the engine, as a note. Never read as markup."""

    def __init__(self, text: str, kind: str):
        super().__init__(classes=f"line -{kind}")
        self.kind = kind
        self.say(text)

    def say(self, text: str) -> None:
        """Say this, in the place of what it said before."""
        sign = {"user": ">", "error": mark("error"), "warning": mark("warning")}.get(self.kind, " ")
        self.plain = text
        self._words = Content.assemble((f"{sign} ", "bold"), mentions(text))
        self._marked: Marked = ()
        self.update(self._words)

    def show_parts(self, parts: Marked, lost: Marked, here: str | None) -> None:
        """Colour the words by the components that rest on them (to be clicked), those of the component that one is at
        in bold, and mark what was lost (by status: underlined, background dimmed)."""
        before, self._marked = self._marked, (parts, lost, here)
        if before == self._marked or not before and not parts and not lost:
            return
        words, first = self._words, len(self._words.plain) - len(self.plain)
        for status, (start, end) in lost:
            words = words.stylize(LOST[status], first + start, first + end)
        for cid, (start, end) in sorted(parts, key=lambda part: part[0] == here):
            style = f"bold {colour(cid)}" if cid == here else colour(cid)
            words = words.stylize(style, first + start, first + end)
        self.update(words, layout=False)

    def on_click(self, event: Click) -> None:
        _, at = self.screen.get_widget_and_offset_at(event.screen_x, event.screen_y)
        if at is None or not self._marked:
            return
        lines = self._words.plain.split("\n")
        index = sum(len(line) + 1 for line in lines[: at.y]) + at.x - (len(self._words.plain) - len(self.plain))
        if cid := next((cid for cid, (start, end) in self._marked[0] if start <= index < end), None):
            self.post_message(Picked(cid, "chat"))


class Answer(Vertical):
    """An answer of a model, as it streams."""

    def __init__(self, component: str | None = None):
        super().__init__(classes="answer")
        self.component = component
        self.text = ""
        self.thought = 0
        self._stream: MarkdownStream | None = None

    def compose(self) -> ComposeResult:
        from textual.widgets import Markdown  # its parser is not needed to show a first screen

        yield Static("", classes="thinking", markup=False)
        yield Markdown("", open_links=False)

    async def add(self, text: str, thinking: bool = False) -> None:
        """Take the next piece."""
        if thinking:
            self.thought += len(text.split())
            self.query_one(".thinking", Static).update(f"thinking {mark('writing')} {self.thought} words")
            return
        self.text += text
        if self._stream is None:
            from textual.widgets import Markdown

            self._stream = Markdown.get_stream(self.query_one(Markdown))
        await self._stream.write(text)

    async def end(self) -> None:
        """No more pieces come."""
        if self._stream is not None:
            await self._stream.stop()
            self._stream = None


class Sources(Static):
    """What was found for a question: numbered, to be opened or used."""

    def __init__(self, passages: list[Passage]):
        self.passages = passages
        parts: list = []
        for i, passage in enumerate(passages, 1):
            where = f" {passage.clause}" if passage.clause and passage.clause not in passage.title else ""
            notes = f" ({attribution(passage)})" if attribution(passage) else ""
            first = " ".join(passage.text.split())
            first = first if len(first) <= 120 else first[:119] + "…"
            parts += [
                (f"{i} ", "bold $text-accent"), (passage.title + where, "bold"),
                (f"  {passage.source}{notes}", "$muted"), "\n", first, "\n" if i < len(passages) else "",
            ]  # fmt: skip
        super().__init__(Content.assemble(*parts), classes="sources")

    def on_click(self, event: Click) -> None:
        _, at = self.screen.get_widget_and_offset_at(event.screen_x, event.screen_y)
        if at is not None:  # two lines each
            self.post_message(CommandAsked("read", str(at.y // 2 + 1)))
