"""The line in which a field of S is edited in place, with what may stand there and what it would reach."""


from textual.app import ComposeResult
from textual.binding import Binding
from textual.containers import Vertical
from textual.content import Content
from textual.geometry import Region
from textual.message import Message
from textual.suggester import SuggestFromList
from textual.widgets import Input, Static

from c2s_engine.structure.edits import Edit, EditError, SetDescription, SetField
from c2s_engine.structure.specs import AnySpec
from c2s_engine.structure.values import Field, head_name, parse
from c2s_tui.in_order import OrderedLine
from c2s_tui.sheet.rows import SENTENCE, Row

SHOWN_CHOICES = 40


class FieldEditor(Vertical):
    """Edits one row; posts `Made` with the edit, `Left` when it is given up."""

    BINDINGS = [Binding("escape", "leave", "Keep as it was", id="sheet.leave_field", tooltip="Leave it unchanged")]
    KEYS_END = True
    """While it is open, the keys of the pane around it do nothing."""

    class Made(Message):
        def __init__(self, edit: Edit):
            self.edit = edit
            super().__init__()

    class Left(Message):
        pass

    class Opened(Message):
        """The line is there."""

    class Resized(Message):
        """It has another height: it opened, or its help or an error has other words."""

    class Typed(Message):
        """What is typed so far is a valid edit (or is not: None)."""

        def __init__(self, edit: Edit | None):
            self.edit = edit
            super().__init__()

    def __init__(self, row: Row, spec: AnySpec):
        super().__init__()
        self.row, self.spec = row, spec
        self.field = row.field
        self._appends = bool(self.field and self.field.many and not self.field.leaf)

    def compose(self) -> ComposeResult:
        value = "" if self._appends else self.row.text
        choices = self._choices()
        line = OrderedLine(
            value, compact=True, select_on_focus=False,
            suggester=SuggestFromList(choices, case_sensitive=False) if choices else None,
        )  # fmt: skip
        if self.row.kind != SENTENCE:
            line.select_all()  # what is typed takes the place of the old value; a sentence is changed in places
        yield line
        yield Static(self._hint(), markup=False)

    def on_mount(self) -> None:
        self.post_message(self.Opened())
        self.call_after_refresh(self._show_cursor)

    def on_resize(self) -> None:
        self.post_message(self.Resized())

    def _show_cursor(self) -> None:
        """The line was as wide as nothing when its cursor was put at the end. A sentence that is longer than the line
        is shown from its beginning on, and whole below."""
        line = self.query_one(Input)
        if self.row.kind == SENTENCE:
            if line.value == self.row.text and self._hides(line.value):
                line.cursor_position = 0
            self.query_one(Static).update(self._hint())
        line.scroll_to_region(Region(line.cursor_position, 0, 1, 1), animate=False, force=True)

    def _hides(self, text: str) -> bool:
        """Whether the line shows only a part of a text: then the whole stands below it."""
        return any(0 < line.size.width <= len(text) for line in self.query(Input))

    def _choices(self) -> tuple[str, ...]:
        if self._appends:
            return self._item_choices()
        return self.field.choices if self.field else ()

    def _item_choices(self) -> tuple[str, ...]:
        from c2s_engine.structure.values import head_choices, model_in

        assert self.field
        model = model_in(type(self.spec).model_fields[self.field.path].annotation)
        return head_choices(model) if model else ()

    def _hint(self, error: str = "") -> Content:
        if error:
            return Content.styled(error, "$text-error")
        if self.row.kind == SENTENCE:
            said = Content.styled("one sentence; Enter applies it, Esc keeps what was there", "$muted")
            text = next((line.value for line in self.query(Input)), self.row.text)
            return Content.assemble((text, "$text"), "\n", said) if self._hides(text) else said
        parts = [self.field.about] if self.field and self.field.about else []
        if self._appends:
            parts.append("what is typed is added at the end, several with commas between them")
        if choices := self._choices():
            rest = len(choices) - SHOWN_CHOICES
            more = f" and {rest} more" if rest > 0 else ""
            parts.append("one of " + ", ".join(choices[:SHOWN_CHOICES]) + more)
        elif self.field and self.field.unit == "m/s":
            parts.append("typed without a unit it is km/h")
        return Content.styled("; ".join(parts) or "Enter applies it, Esc keeps what was there", "$muted")

    def edit_of(self, text: str) -> Edit:
        """The edit that a typed text means; raises EditError."""
        if self.row.kind == SENTENCE:
            if not text.strip():
                raise EditError("a component needs a sentence")
            return SetDescription(component=self.row.cid, description=text.strip())
        field = self.field
        assert field
        if self._appends:
            chosen = parse(Field(field.path, None, False, many=True, choices=self._item_choices()), text)
            if not chosen:
                raise EditError(f"say which: {', '.join(self._item_choices()[:SHOWN_CHOICES])}")
            name = "action" if "action" in self._first_names() else "kind"
            items = [{name: each} for each in chosen]
            if len(items) > 1:
                return SetField(component=self.row.cid, path=field.path, value=[*field.value, *items])
            return SetField(component=self.row.cid, path=f"{field.path}.{len(field.value)}", value=items[0])
        value = parse(field, text)
        head = head_name(self.spec, field.path) if value is not None and field.value is None else None
        if head:
            value = {head: value}
        return SetField(component=self.row.cid, path=field.path, value=value)

    def _first_names(self) -> list[str]:
        from c2s_engine.structure.values import model_in

        assert self.field
        model = model_in(type(self.spec).model_fields[self.field.path].annotation)
        return list(model.model_fields)[:1] if model else []

    @property
    def changed(self) -> bool:
        """Whether anything else is typed than stood there."""
        return self.query_one(Input).value != ("" if self._appends else self.row.text)

    def complete(self) -> bool:
        """Take the one choice that begins with what is typed; whether there is one."""
        line = self.query_one(Input)
        found = [c for c in self._choices() if line.value and c.lower().startswith(line.value.lower())]
        if len(found) != 1 or found[0] == line.value:
            return False
        line.value = found[0]
        line.cursor_position = len(line.value)
        return True

    def on_input_changed(self, event: Input.Changed) -> None:
        event.stop()
        if self.row.kind == SENTENCE:
            self.query_one(Static).update(self._hint())
        try:
            edit = self.edit_of(event.value)
        except EditError:
            edit = None
        self.post_message(self.Typed(edit))

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        try:
            edit = self.edit_of(event.value)
        except EditError as error:
            self.refuse(str(error))
            return
        self.post_message(self.Made(edit))

    def refuse(self, why: str) -> None:
        """Say why the text cannot stand there; what was typed stays."""
        self.query_one(Static).update(self._hint(why))
        self.query_one(Input).styles.color = None
        self.query_one(Input).focus()

    def action_leave(self) -> None:
        self.post_message(self.Left())
