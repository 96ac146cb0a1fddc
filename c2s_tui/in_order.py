"""Keys one after the other. Textual inserts a letter at once, but runs what a key is bound to when the key has bubbled
up to the app: typed fast on a busy machine, a backspace would come after the letters that follow it.
"""

from typing import Any

from textual.events import Key
from textual.widget import Widget
from textual.widgets import Input, TextArea

from c2s_tui.commands import function_keys


class OrderedArea(TextArea):
    """A TextArea whose own bindings run where their key stands among the others."""

    def __init__(self, *arguments: Any, **options: Any):
        super().__init__(*arguments, **options)
        for key in function_keys():  # what the app has a key for is the app's here too (TextArea selects a line by F6)
            self._bindings.key_to_bindings.pop(key, None)

    async def _on_key(self, event: Key) -> None:
        if not await taken(self, event):
            await super()._on_key(event)


class OrderedLine(Input):
    """An Input whose own bindings run where their key stands among the others."""

    async def _on_key(self, event: Key) -> None:
        if not await taken(self, event):
            await super()._on_key(event)


async def taken(widget: Widget, event: Key) -> bool:
    """Do at once what a key is bound to in the widget that has the focus; whether there is nothing left to do."""
    if event.key.startswith("alt+") and event.is_printable:
        event.prevent_default()  # a key of the app, or of nobody: not the letter that comes with it
        return True
    bound = None if event.is_printable else widget.screen.active_bindings.get(event.key)
    if bound is None or bound.node is not widget or not bound.enabled:
        return False
    event.stop()
    event.prevent_default()
    await widget.app.run_action(bound.binding.action, widget)
    return True
