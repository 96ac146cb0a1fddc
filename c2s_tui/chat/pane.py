"""The chat pane: the conversation above, the line to type in below."""

from collections.abc import Sequence
from typing import Any

from textual import on
from textual.app import ComposeResult
from textual.containers import Vertical, VerticalScroll
from textual.widget import Widget

from c2s_engine.structure.account import account, idle_clauses
from c2s_engine.structure.components import Structure, Unmet
from c2s_engine.structure.progress import Passage, Progress, Say, Token
from c2s_tui.chat.bubbles import Answer, Line, Sources
from c2s_tui.chat.entry import Entry
from c2s_tui.messages import ScrollAsked

KEPT = 400
"""Entries of the conversation that stay on the screen; the session keeps all."""


class Conversation(VerticalScroll):
    """Follows the newest entry while it is at the bottom."""

    can_focus = True
    HELP_NAME = "chat"


class ChatPane(Vertical):
    """Turns the engine's words into entries; the workbench feeds it the events."""

    BORDER_TITLE = "chat"

    def __init__(self, **options: Any):
        super().__init__(**options)
        self.passages: list[Passage] = []
        self._answer: Answer | None = None

    def compose(self) -> ComposeResult:
        yield Conversation(id="conversation")
        yield Entry(id="entry")

    @property
    def conversation(self) -> Conversation:
        return self.query_one(Conversation)

    @property
    def entry(self) -> Entry:
        return self.query_one(Entry)

    def on_mount(self) -> None:
        self.conversation.anchor()

    @on(ScrollAsked)
    def _scroll(self, event: ScrollAsked) -> None:
        event.stop()
        conversation = self.conversation
        if event.by < 0:
            conversation.release_anchor()  # else it follows what is new at the end
            conversation.scroll_page_up(animate=False)
        else:
            conversation.scroll_page_down(animate=False, on_complete=self._at_end)

    def _at_end(self) -> None:
        if self.conversation.is_vertical_scroll_end:
            self.conversation.anchor()

    def show(self, structure: Structure, idle: Sequence[Unmet], here: str | None) -> None:
        """In the text that S was read from, colour the words by component, and mark what was lost. `idle`: phrases
        without which S would be the same."""
        parts = tuple(
            (c.id, link.span) for c in structure.components for link in c.links if link.kind == "text" and link.span
        )
        clauses = account(structure, idle_clauses(structure, idle))
        lost: tuple = tuple((c.status, c.span) for c in clauses if c.status not in ("understood", "partly"))
        partly = [u.span for c in clauses if c.status == "partly" for u in c.lost if u.span]
        lost += tuple(("not_expressible", span) for span in partly)
        said = [line for line in self.query(Line) if line.kind == "user"]
        read = next((line for line in reversed(said) if line.plain == structure.text), None)
        for line in said:
            line.show_parts(parts if line is read else (), lost if line is read else (), here)

    async def put(self, entry: Widget) -> None:
        """Add an entry at the end."""
        await self.conversation.mount(entry)
        if len(self.conversation.children) > KEPT:
            await self.conversation.children[0].remove()

    async def note(self, text: str, kind: str = "note") -> Line:
        """Say something to the user."""
        line = Line(text, kind)
        await self.put(line)
        return line

    async def user(self, text: str) -> None:
        """Show what the user sent."""
        self.passages = []
        await self.put(Line(text, "user"))

    async def take(self, event: Progress) -> None:
        """Take an event of a turn."""
        if isinstance(event, Token):
            if self._answer is None or self._answer.component != event.component:
                await self.end_answer()
                self._answer = Answer(event.component)
                await self.put(self._answer)
            await self._answer.add(event.text, event.thinking)
        elif isinstance(event, Say):
            await self.end_answer()
            await self.note(event.text, event.severity if event.severity != "info" else "say")
        elif isinstance(event, Passage):
            self.passages.append(event)

    async def end_answer(self) -> None:
        if self._answer is not None:
            await self._answer.end()
            self._answer = None

    async def end(self) -> None:
        """A turn is over: show its sources."""
        await self.end_answer()
        if self.passages and not self._shown():
            await self.put(Sources(list(self.passages)))

    async def found(self, passages: list[Passage]) -> None:
        """Show what a search found."""
        self.passages = passages
        await self.put(Sources(passages))

    async def clear(self) -> None:
        self.passages = []
        await self.conversation.remove_children()

    def _shown(self) -> bool:
        last = self.query(Sources)
        return bool(last) and last.last().passages == self.passages
