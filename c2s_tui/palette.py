"""The command palette: the app's commands, those of the focused pane, and components to go to."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING, cast

from textual.command import DiscoveryHit, Hit, Hits, Provider

from c2s_tui.commands import commands
from c2s_tui.sheet.rows import title

if TYPE_CHECKING:
    from c2s_tui.workbench import Workbench


class Palette(Provider):
    """Searches names and what they do."""

    def _entries(self) -> Iterator[tuple[str, str, Callable[[], object]]]:
        bench = cast("Workbench", self.screen)
        for command in commands().values():
            key = f"  [{command.key.split(',')[0]}]" if command.key else ""
            yield f"{command.name}{key}", command.about, partial(bench.action_command, command.name)
        for component in bench.desk.structure.components:
            go = partial(bench.room.visit, component.id)
            yield f"go to {component.id}: {title(component)}", component.description, go

    async def discover(self) -> Hits:
        for name, about, act in self._entries():
            yield DiscoveryHit(_plain(name), act, help=_plain(about))

    async def search(self, query: str) -> Hits:
        matcher = self.matcher(query)
        for name, about, act in self._entries():
            if (score := max(matcher.match(name), matcher.match(about) * 0.6)) > 0:
                yield Hit(score, matcher.highlight(name), act, text=name, help=_plain(about))


def _plain(text: str) -> str:
    return text.replace("[", "\\[")
