"""Keys one after the other. Textual inserts a letter at once, but runs what a key is bound to when the key has bubbled
up to the app: typed fast on a busy machine, a backspace would come after the letters that follow it.
"""

from typing import Any

from textual.events import Key
from textual.widgets import TextArea

from c2s_tui.commands import function_keys


class OrderedArea(TextArea):
    """A TextArea whose own bindings run where their key stands among the others."""

    def __init__(self, *arguments: Any, **options: Any):
        super().__init__(*arguments, **options)
        for key in function_keys():  # what the app has a key for is the app's here too (TextArea selects a line by F6)
            self._bindings.key_to_bindings.pop(key, None)

    async def _on_key(self, event: Key) -> None:
        if event.key.startswith("alt+") and event.is_printable:
            event.prevent_default()  # a key of the app, or of nobody: not the letter that comes with it
            return
        if not event.is_printable:
            bound = self.screen.active_bindings.get(event.key)
            if bound is not None and bound.node is self and bound.enabled:
                event.stop()
                event.prevent_default()
                await self.app.run_action(bound.binding.action, self)
                return
        await super()._on_key(event)
