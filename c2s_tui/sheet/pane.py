"""The structure pane: S as a sheet, with one cursor, edited in place."""

from typing import Any, get_args

from textual import on
from textual.binding import Binding
from textual.containers import VerticalScroll
from textual.events import Click, Key
from textual.geometry import Region
from textual.widgets import Input

from c2s_engine.structure.edits import AddObject, MoveObject, RemoveObject, SetCode, SetField
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.structure.values import fields
from c2s_engine.structure.vocabulary import ObjectType
from c2s_tui.desk import Desk
from c2s_tui.in_order import OrderedLine
from c2s_tui.messages import CommandAsked, EditsAsked, Picked, ReachAsked, TextSubmitted
from c2s_tui.sheet.editor import FieldEditor
from c2s_tui.sheet.row_view import RowView
from c2s_tui.sheet.rows import ADD, CONFLICT, FIELD, HEAD, SENTENCE, Row, rows


class SheetPane(VerticalScroll):
    """Rows of components and fields; Enter opens or edits, the keys below do the rest."""

    BORDER_TITLE = "S"
    HELP_NAME = "sheet"
    BINDINGS = [
        Binding("up,k", "move(-1)", "Up", show=False, id="sheet.up", tooltip="Previous row"),
        Binding("down,j", "move(1)", "Down", show=False, id="sheet.down", tooltip="Next row"),
        Binding("pageup,left_square_bracket", "component(-1)", "Previous component", show=False,
                id="sheet.previous", tooltip="Previous component"),
        Binding("pagedown,right_square_bracket", "component(1)", "Next component", show=False, id="sheet.next",
                tooltip="Next component"),
        Binding("home", "end(0)", "First", show=False, id="sheet.first", tooltip="First row"),
        Binding("end", "end(-1)", "Last", show=False, id="sheet.last", tooltip="Last row"),
        Binding("enter,e", "enter", "Edit", id="sheet.edit", tooltip="Edit the field, open or close the component"),
        Binding("space", "fold", "All fields", id="sheet.fold", tooltip="Show all fields, or the set ones"),
        Binding("a,plus", "add", "Add", id="sheet.add", tooltip="Add an object; on a phase, one more"),
        Binding("x,delete", "remove", "Remove", id="sheet.remove", tooltip="Remove the object, or unset the field"),
        Binding("shift+up,K", "reorder(-1)", "Earlier", show=False, id="sheet.earlier", tooltip="Move the object up"),
        Binding("shift+down,J", "reorder(1)", "Later", show=False, id="sheet.later", tooltip="Move the object down"),
        Binding("w", "why", "Why?", id="sheet.why", tooltip="Why is this here: the words and sources behind it"),
        Binding("r", "rewrite", "Rewrite", show=False, id="sheet.rewrite",
                tooltip="Discard your code; the component is written again"),
        Binding("u,ctrl+z", "undo", "Undo", id="sheet.undo", tooltip="Undo the last turn or edit"),
        Binding("U,ctrl+y", "redo", "Redo", show=False, id="sheet.redo", tooltip="Redo what was undone"),
    ]  # fmt: skip

    def __init__(self, **options: Any):
        super().__init__(**options)
        self.desk = Desk()
        self.rows: list[Row] = []
        self.unfolded: set[str] = set()
        self.reached: frozenset[str] = frozenset()
        self.cursor = 0
        self.views: list[RowView] = []  # one a row, reused from drawing to drawing
        self._ahead = ""  # typed after a line to edit was asked for, and before it was there

    # What it shows.

    def show(self, desk: Desk) -> None:
        """Draw the desk; rows that stay are kept, so that nothing flickers."""
        self.desk = desk
        self._lay()

    def show_reach(self, reached: frozenset[str]) -> None:
        """Mark what the edit under way would rewrite."""
        self.reached = reached
        self._lay()

    def point(self, cid: str) -> None:
        """Follow the cursor of another pane to a component."""
        if self.here is None or self.here.cid != cid:
            self._go(next((i for i, row in enumerate(self.rows) if row.cid == cid), self.cursor), tell=False)

    @property
    def here(self) -> Row | None:
        return self.rows[self.cursor] if self.cursor < len(self.rows) else None

    @property
    def editor(self) -> FieldEditor | None:
        return next(iter(self.query(FieldEditor)), None)

    def _lay(self) -> None:
        at = self.here.key if self.here else None
        lines = rows(self.desk, self.unfolded, self.reached)
        views = self.views
        self.rows = lines
        for view, row in zip(views, lines, strict=False):
            view.show(row)
        if len(views) < len(lines):
            new = [RowView(row) for row in lines[len(views) :]]
            self.mount_all(new, after=views[-1] if views else None)
            views += new
        for view in views[len(lines) :]:
            view.remove()
        del views[len(lines) :]
        self.cursor = next((i for i, row in enumerate(lines) if row.key == at), min(self.cursor, len(lines) - 1))
        self._mark()
        if self.has_focus or self.editing:
            self._reveal()

    def _reveal(self, rows: int = 1) -> None:
        """Once it is laid out, bring the cursor's row into view with what has opened there: `rows` of them, the field
        that is edited and its help. Where not all has room, the row itself stays."""

        def scroll() -> None:
            here = self.views[self.cursor : self.cursor + rows]
            opened = [*self.query(FieldEditor), *self.query("#new-object")]
            regions = [view.virtual_region for view in [*here, *opened] if view.virtual_region.area]
            if regions:
                whole = Region.from_union(regions)
                first = regions[-1] if opened else regions[0]
                for region in (whole, first):
                    self.scroll_to_region(region, animate=False, immediate=True, force=True)

        self.call_after_refresh(self.call_after_refresh, scroll)

    def _mark(self) -> None:
        for i, view in enumerate(self.views):
            view.set_class(i == self.cursor, "-cursor")
            view.set_class(self.here is not None and view.row.cid == self.here.cid != "", "-here")

    def _go(self, index: int, tell: bool = True) -> None:
        self.cursor = max(0, min(index, len(self.rows) - 1))
        self._mark()
        views = self.views
        if self.cursor < len(views):
            self.scroll_to_widget(views[self.cursor], animate=False)
        if tell and self.here and self.here.cid:
            self.post_message(Picked(self.here.cid, "sheet"))

    # Moving.

    def action_move(self, by: int) -> None:
        self._go(self.cursor + by)

    def action_end(self, index: int) -> None:
        self._go(len(self.rows) - 1 if index < 0 else 0)

    def action_component(self, by: int) -> None:
        heads = [i for i, row in enumerate(self.rows) if row.kind in (HEAD, ADD)]
        later = [i for i in heads if (i > self.cursor if by > 0 else i < self.cursor)]
        if later:
            self._go(later[0] if by > 0 else later[-1])

    async def on_click(self, event: Click) -> None:
        view = event.widget
        if isinstance(view, RowView):
            index = self.views.index(view)
            again = index == self.cursor and self.has_focus
            self.focus()
            self._go(index)
            if again or event.chain > 1:
                await self.action_enter()

    # Editing.

    async def action_enter(self) -> None:
        row = self.here
        if row is None:
            return
        if row.kind == ADD:
            await self.action_add()
        elif row.kind == CONFLICT:
            self.post_message(CommandAsked("conflict", row.cid))
        elif row.kind == HEAD or (row.kind == FIELD and row.field and not row.field.leaf and not row.field.many):
            self.action_fold()
        elif row.kind in (FIELD, SENTENCE):
            self._edit(row)
        elif row.cid:
            self.action_why()

    def action_fold(self) -> None:
        if row := self.here:
            self.unfolded ^= {row.cid}
            self._lay()
            self._reveal(1 + sum(r.cid == row.cid for r in self.rows[self.cursor + 1 :]))

    @property
    def editing(self) -> bool:
        """Whether a line is being edited: keys are text then, not commands."""
        return bool(self.query("FieldEditor, #new-object"))

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        return not self.editing

    def pass_on(self) -> None:
        """Put what was typed ahead into the line to edit, once that is there."""
        for line in self.query(Input):
            if line.is_mounted:
                self.screen.set_focus(line)
                if self._ahead:
                    line.replace(self._ahead, *sorted(line.selection))
                self._ahead = ""

    def _edit(self, row: Row) -> None:
        if self.editor:
            return
        views = self.views
        self._ahead = ""
        self.mount(FieldEditor(row, self.desk.structure[row.cid].spec), after=views[self.cursor])
        views[self.cursor].add_class("-edited")

    @on(FieldEditor.Opened)
    def _opened(self, event: FieldEditor.Opened) -> None:
        event.stop()
        self.pass_on()

    @on(FieldEditor.Resized)
    def _resized(self, event: FieldEditor.Resized) -> None:
        event.stop()
        self._reveal()

    @on(FieldEditor.Typed)
    def _typed(self, event: FieldEditor.Typed) -> None:
        event.stop()
        if event.edit is None:
            self.show_reach(frozenset())
        else:
            self.post_message(ReachAsked(event.edit))

    @on(FieldEditor.Made)
    async def _made(self, event: FieldEditor.Made) -> None:
        event.stop()
        self.post_message(EditsAsked([event.edit]))

    @on(FieldEditor.Left)
    async def _left(self, event: FieldEditor.Left) -> None:
        event.stop()
        await self.close_editor()

    async def close_editor(self) -> None:
        """Put the field editor away; the cursor is on its row again."""
        await self.query(FieldEditor).remove()
        await self.query("#new-object").remove()
        self.query(RowView).remove_class("-edited")
        self.show_reach(frozenset())
        self.screen.set_focus(self)

    def refuse(self, why: str) -> bool:
        """Show at the field why an edit was refused; whether there is one."""
        if self.editor:
            self.editor.refuse(why)
            return True
        return False

    async def action_add(self) -> None:
        if self.query("#new-object"):
            return
        if (row := self.here) is not None and row.field is not None and (many := self._list_of(row)):
            self.unfolded.add(row.cid)
            self._lay()
            self._go(next(i for i, each in enumerate(self.rows) if each.key == many))
            self._edit(self.rows[self.cursor])
            return
        self._ahead = ""
        words = "a type (car, pedestrian, cone ...) or a sentence"
        line = OrderedLine(placeholder=words, id="new-object", compact=True)
        await self.mount(line)
        self._reveal()
        self.pass_on()

    def _list_of(self, row: Row) -> str:
        """The key of the row at which a part is added to a list, from a field of that (a phase); else nothing."""
        assert row.field is not None
        first = row.field.path.split(".")[0]
        known = fields(self.desk.structure[row.cid].spec)
        return f"{row.cid}:{first}" if any(f.path == first and f.many and not f.leaf for f in known) else ""

    @on(Input.Submitted, "#new-object")
    async def _new_object(self, event: Input.Submitted) -> None:
        event.stop()
        text = event.value.strip()
        await self.close_editor()
        if text.lower().replace(" ", "_") in get_args(ObjectType):
            kind: Any = text.lower().replace(" ", "_")
            self.post_message(EditsAsked([AddObject(spec=ObjectSpec(name=kind, type=kind))]))
        elif text:
            self.post_message(TextSubmitted(f"Add an object: {text}"))

    async def on_key(self, event: Key) -> None:
        """Keys one after the other: what follows a key that opens a line to edit is text, however fast it is typed."""
        focused = self.screen.focused
        if focused is not None and self not in focused.ancestors_with_self:  # the key before this one went elsewhere
            event.stop()
            focused.post_message(Key(event.key, event.character))
        elif event.key == "escape" and self.query("#new-object"):
            event.stop()
            await self.close_editor()
        elif event.key == "tab" and self.editing:
            event.stop()
            event.prevent_default()
            await self._tab()
        elif self.editing:
            if event.is_printable:
                event.stop()
                self._ahead += event.character or ""
                self.pass_on()
        elif (bound := self.screen.active_bindings.get(event.key)) is not None and bound.node in (self, self.screen):
            event.stop()
            await self.app.run_action(bound.binding.action, bound.node)

    async def _tab(self) -> None:
        """Tab completes what is typed; else it takes it, or leaves what was not changed."""
        line = next(iter(self.query(Input)), None)
        if line is None:
            return
        if self.editor and self.editor.complete():
            return
        if self.editor and not self.editor.changed or not line.value.strip():
            await self.close_editor()
        else:
            await line.action_submit()

    def action_remove(self) -> None:
        row = self.here
        if row is None or not row.cid:
            return
        if row.kind == FIELD and row.field:
            value: Any = [] if row.field.many else None
            self.post_message(EditsAsked([SetField(component=row.cid, path=row.field.path, value=value)]))
        elif row.kind == HEAD:
            self.post_message(EditsAsked([RemoveObject(component=row.cid)]))

    def action_reorder(self, by: int) -> None:
        ids = [o.id for o in self.desk.structure.objects]
        if self.here and self.here.cid in ids:
            index = ids.index(self.here.cid) + by
            if 0 <= index < len(ids):
                self.post_message(EditsAsked([MoveObject(component=self.here.cid, index=index)]))

    def action_rewrite(self) -> None:
        if self.here and self.here.cid:
            self.post_message(EditsAsked([SetCode(component=self.here.cid, code=None)]))

    def action_why(self) -> None:
        if self.here and self.here.cid:
            self.post_message(CommandAsked("why", self.here.cid))

    def action_undo(self) -> None:
        self.post_message(CommandAsked("undo"))

    def action_redo(self) -> None:
        self.post_message(CommandAsked("redo"))
