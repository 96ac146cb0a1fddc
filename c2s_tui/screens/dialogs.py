"""Small dialogs: a question, a list to choose from, a text to read."""

from dataclasses import dataclass

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding
from textual.containers import Vertical, VerticalScroll
from textual.content import Content
from textual.events import Key
from textual.screen import ModalScreen
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option


class Confirm(ModalScreen[str | None]):
    """Asks once; the answers are single keys, or (where much would be lost by a key that was meant for something else)
    chosen from the list, the first one to begin with."""

    BINDINGS = [Binding("escape", "answer('')", "Back", show=False)]

    def __init__(self, question: str, answers: dict[str, tuple[str, str]], by_key: bool = True):
        """`answers`: key to (value, words)."""
        super().__init__()
        self.question, self.answers, self.by_key = question, answers, by_key

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog"):
            yield Static(self.question, classes="title", markup=False)
            yield OptionList(
                *[
                    Option(Content(f"{key}  {words}" if self.by_key else words), id=value)
                    for key, (value, words) in self.answers.items()
                ]
            )
            foot = "Esc goes back" if self.by_key else "Down and Enter choose, Esc goes back"
            yield Static(foot, classes="foot", markup=False)

    def on_key(self, event: Key) -> None:
        if self.by_key and event.key in self.answers:
            event.stop()
            self.dismiss(self.answers[event.key][0])

    @on(OptionList.OptionSelected)
    def _chosen(self, event: OptionList.OptionSelected) -> None:
        self.dismiss(event.option_id)

    def action_answer(self, value: str) -> None:
        self.dismiss(value or None)


@dataclass(frozen=True)
class Choosable:
    """An entry of a list: what is chosen, what is shown."""

    value: str
    label: str
    note: str = ""


class Chooser(ModalScreen[str | None]):
    """A list that narrows as one types."""

    BINDINGS = [
        Binding("escape", "back", "Back", show=False),
        Binding("down", "move(1)", "Down", show=False), Binding("up", "move(-1)", "Up", show=False),
    ]  # fmt: skip

    def __init__(self, title: str, entries: list[Choosable], current: str = "", free: str = "", foot: str = "",
                 wide: bool = False):  # fmt: skip
        """`free`: what a typed text that is no entry would mean; empty: only entries can be chosen. `wide`: as wide as
        the screen."""
        super().__init__(classes="-wide-dialog" if wide else None)
        self.heading, self.entries, self.current, self.free, self.foot = title, entries, current, free, foot

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog"):
            yield Static(self.heading, classes="title", markup=False)
            yield Input(placeholder=self.free or "type to filter", compact=True)
            yield OptionList(*self._options(""))
            yield Static(self.foot or "Enter chooses, Esc goes back", classes="foot", markup=False)

    def on_mount(self) -> None:
        self.query_one(Input).focus()
        self._point()

    def _options(self, typed: str) -> list[Option]:
        wide = max((len(e.label) for e in self.entries), default=0)
        return [
            Option(
                Content.assemble(
                    ("* " if e.value == self.current else "  ", "bold"), f"{e.label:<{wide}}  ", (e.note, "$muted")
                ),
                id=e.value,
            )
            for e in self.entries
            if typed.lower() in f"{e.label} {e.note}".lower()
        ]

    def _point(self) -> None:
        options = self.query_one(OptionList)
        if options.option_count:
            values = [options.get_option_at_index(i).id for i in range(options.option_count)]
            options.highlighted = values.index(self.current) if self.current in values else 0

    @on(Input.Changed)
    def _narrow(self, event: Input.Changed) -> None:
        options = self.query_one(OptionList)
        options.clear_options()
        options.add_options(self._options(event.value))
        self._point()

    @on(Input.Submitted)
    def _submitted(self, event: Input.Submitted) -> None:
        options = self.query_one(OptionList)
        if options.highlighted is not None and options.option_count:
            self.dismiss(options.get_option_at_index(options.highlighted).id)
        elif self.free and event.value.strip():
            self.dismiss(event.value.strip())

    @on(OptionList.OptionSelected)
    def _chosen(self, event: OptionList.OptionSelected) -> None:
        self.dismiss(event.option_id)

    def action_move(self, by: int) -> None:
        """The entry below or above, while one goes on typing."""
        options = self.query_one(OptionList)
        options.action_cursor_down() if by > 0 else options.action_cursor_up()

    def action_back(self) -> None:
        self.dismiss(None)


class Reading(ModalScreen[None]):
    """A text to read and scroll; `c` copies it."""

    BINDINGS = [
        Binding("escape,enter,q", "back", "Back", show=False),
        Binding("c", "copy", "Copy", show=False),
        Binding("up,k", "scroll(-1)", show=False), Binding("down,j", "scroll(1)", show=False),
        Binding("pageup", "scroll(-10)", show=False), Binding("pagedown,space", "scroll(10)", show=False),
    ]  # fmt: skip

    def __init__(self, title: str, body: Content | str, foot: str = "Esc goes back, c copies"):
        super().__init__()
        self.heading, self.body, self.foot = title, body, foot

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog"):
            yield Static(self.heading, classes="title", markup=False)
            with VerticalScroll():
                yield Static(self.body, classes="body", markup=False)
            yield Static(self.foot, classes="foot", markup=False)

    def action_copy(self) -> None:
        self.app.copy_to_clipboard(str(self.body))
        self.app.notify("Copied.", markup=False)

    def action_scroll(self, by: int) -> None:
        self.query_one(VerticalScroll).scroll_relative(y=by, animate=False)

    def action_back(self) -> None:
        self.dismiss(None)
