"""The line to type in: Enter sends, the text grows downwards, earlier lines come back with the arrow keys."""

from textual import on
from textual.binding import Binding
from textual.events import Key

from c2s_tui.in_order import OrderedArea
from c2s_tui.messages import CommandAsked, ScrollAsked, TextSubmitted


class Entry(OrderedArea):
    """Posts `TextSubmitted`. What is typed survives a cancelled turn, and a crash."""

    HELP_NAME = "chat"
    BINDINGS = [
        Binding("escape", "cancel", "Cancel", id="chat.cancel", tooltip="Cancel what runs; what is typed stays"),
        Binding("alt+enter,ctrl+j", "newline", "New line", show=False, id="chat.newline", tooltip="Begin a new line"),
        Binding("pageup", "scroll_chat(-1)", "Scroll up", show=False, id="chat.up", tooltip="Scroll the chat up"),
        Binding("pagedown", "scroll_chat(1)", "Scroll down", show=False, id="chat.down", tooltip="Scroll it down"),
    ]

    def __init__(self, **options):
        super().__init__(
            "", soft_wrap=True, compact=True, tab_behavior="focus", highlight_cursor_line=False,
            placeholder="Describe, ask, change. /help", **options,
        )  # fmt: skip
        self.sent: list[str] = []
        self.kept: list[str] = []  # what was put back, until it is sent or deleted
        self._before = ""
        self._at = 0
        self.left = ""  # what stood here when the last text was sent
        self._typed: dict[int, str] = {}  # what stood at each place of what the arrow keys go through, as it was left

    async def _on_key(self, event: Key) -> None:
        if event.key == "enter":
            event.stop()
            event.prevent_default()
            self.send()
            return
        if event.key == "tab" and self.text.startswith("/") and self._complete():
            event.stop()
            event.prevent_default()
            return
        if event.key == "up" and self.cursor_at_first_line and self._recall(-1):
            event.stop()
            event.prevent_default()
            return
        if event.key == "down" and self.cursor_at_last_line and self._recall(1):
            event.stop()
            event.prevent_default()
            return
        await super()._on_key(event)

    def send(self) -> None:
        """Send what is typed."""
        text = self.text.strip()
        if text:
            left = self._behind
            self.sent.append(text)
            self._at, self._typed = len(self.sent), {}
            self.kept = [kept for kept in self.kept if kept not in text]
            self.text = left  # what was typed before another text was fetched
            if not left:
                self._bring_back()
            self.left = self.text
            self.post_message(TextSubmitted(text))

    def remember(self, texts: list[str]) -> None:
        """Texts that were sent before those of this run of the app come back with the arrow keys, too."""
        self.sent = [*(t for t in texts if t not in self.sent), *self.sent]
        self._at, self._typed = len(self.sent), {}

    def put(self, text: str) -> None:
        """Put a text there to be sent or changed."""
        self.text = text
        self.move_cursor(self.document.end)

    def keep(self, text: str) -> None:
        """Put back what could not be sent: what is typed next is a line of its own, after which it is there again. A
        line that was begun stays."""
        self.kept.append(text)
        if not self.text:
            self._bring_back()

    def _bring_back(self) -> None:
        """What was put back, selected whole."""
        if self.kept:
            self.put(self.kept[0])
            self.select_all()

    @on(OrderedArea.Changed)
    def _emptied(self) -> None:
        """What was put back and is deleted is gone; after another line it comes again."""
        before, self._before = self._before, self.text
        if self.kept and not self.text:
            if self.kept[0] in before:
                self.kept.pop(0)
            else:
                self._bring_back()

    @property
    def draft(self) -> str:
        """All that is not sent."""
        kept = (kept for kept in self.kept if kept not in self.text)
        return "\n".join([*kept, *filter(None, [self._behind, self.text])])

    @property
    def _behind(self) -> str:
        """What was typed before a text that was sent earlier was fetched, while that stands there."""
        return self._typed.get(len(self.sent), "") if self._at < len(self.sent) else ""

    def _recall(self, by: int) -> bool:
        if not 0 <= self._at + by <= len(self.sent):
            return False
        self._typed[self._at] = self.text
        self._at += by
        self.put(self._typed.get(self._at, self.sent[self._at] if self._at < len(self.sent) else ""))
        return True

    def _complete(self) -> bool:
        from c2s_tui.commands import completions

        found = completions(self.text)
        if len(found) == 1:
            self.put(found[0] + " ")
        elif found:
            self.suggestion = found[0][len(self.text) :]
        return bool(found)

    def action_newline(self) -> None:
        self.insert("\n")

    def action_scroll_chat(self, by: int) -> None:
        self.post_message(ScrollAsked(by))

    def action_cancel(self) -> None:
        self.post_message(CommandAsked("cancel"))
