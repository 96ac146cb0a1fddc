"""Demands for what no scenario can show: doors, loads, colours, lights."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found
from c2s_engine.interpret.reading import scan


@cache
def _patterns() -> list[tuple[re.Pattern[str], str]]:
    told = [(p["find"], p["reason"]) for p in language.table("unmet")["patterns"] if p["about"] == "actor"]
    return [(re.compile(find), reason) for find, reason in [*language.table("notes")["inexpressible"], *told]]


def unsupported_demand(demand: str) -> Found | None:
    """No edits, and why: where a demand asks for nothing else than what cannot be shown."""
    for pattern, reason in _patterns():
        if not (match := pattern.search(demand)):
            continue
        rest = pattern.sub(" ", demand)
        for span in reversed(scan.names(rest)):
            rest = f"{rest[: span.start]} {rest[span.end :]}"
        if not re.search(r"\w{2,}", re.sub(language.table("notes")["small"], " ", rest)):
            return [], f"“{match[0].strip()}”: {reason}"
    return None
