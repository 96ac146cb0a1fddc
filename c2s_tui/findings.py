"""What the doctor says, as lines for a screen."""

from typing import TYPE_CHECKING, Any

from c2s_tui.look.kinds import mark

if TYPE_CHECKING:
    from c2s_tui.backend import Backend


async def findings(backend: "Backend") -> list[str]:
    """One line a finding: a mark, what was looked at, how it is, what to do."""
    return [_line(f) for f in await backend.ask(lambda engine: engine.doctor())]


def _line(found: dict[str, Any]) -> str:
    name = "clean" if found.get("ok", True) else "warning" if found.get("optional") else "failed"
    text = f"{mark(name)} {found.get('name', '')}: {found.get('found', '')}"
    return f"{text}\n  {found['advice']}" if found.get("advice") else text
