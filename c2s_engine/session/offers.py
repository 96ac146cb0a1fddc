"""What cannot be expressed in fields: the nearest snippets, offered beside the program that was written without it."""

import asyncio
from typing import Any

from c2s_engine.retrieve.errors import RetrievalError
from c2s_engine.session.model_tools import ready
from c2s_engine.session.steps import Emit, Tools
from c2s_engine.structure.components import Structure
from c2s_engine.structure.progress import Passage, Say

EACH = 2
"""Snippets for each thing that is unmet."""
MOST = 4
"""Unmet things that are looked up."""
PATIENCE = 9.0
"""Longest wait after the program is checked, s: the first search of all starts the worker and may build the index."""


def wanted(structure: Structure) -> list[tuple[str, str]]:
    """(component, words) of what is unmet and can be code of a component; what no component took up has none."""
    found = [(c.id, u.text) for c in structure.components if c.id != "G" for u in c.unmet if u.text.strip()]
    found += [("", u.text) for u in structure.not_understood if len(u.text.split()) > 1]
    return list(dict.fromkeys(found))[:MOST]


async def look_up(structure: Structure, tools: Tools, emit: Emit) -> list[tuple[str, str, Passage]]:
    """(component, words, snippet) for what has one that is near enough."""
    client = await ready(tools, emit)
    found: list[tuple[str, str, Passage]] = []
    for cid, words in wanted(structure):
        near = await client.search(words, kind="snippet", component=cid[:1] or None, limit=EACH)
        found += [(cid, words, passage) for passage in near]
    return found


async def offered(
    looking: asyncio.Task[list[tuple[str, str, Passage]]], structure: Structure, emit: Emit
) -> list[dict[str, Any]]:
    """Show what was found, waiting a little; what it was, as the turn's details keep it. Retrieval may fail: then the
    commands that look it up are said."""
    try:
        found = await asyncio.wait_for(looking, PATIENCE)
    except (TimeoutError, RetrievalError, KeyError):
        asked = [f"`c2s search --kind snippet{f' --component {c[0]}' if c else ''} {_quoted(w)}`"
                 for c, w in wanted(structure)]  # fmt: skip
        emit(Say(text=f"Snippets for what no field can say are found by {' or '.join(asked)}."))
        return []
    for cid, words in dict.fromkeys((c, w) for c, w, _ in found):
        near = "; ".join(p.title for c, w, p in found if (c, w) == (cid, words))
        emit(Say(text=f"{cid or 'S'} has no field for “{words}”. Snippets near to it: {near}"))
    for _, _, passage in found:
        emit(passage)
    return [{"component": c, "unmet": w, "id": p.id, "title": p.title, "code": p.text} for c, w, p in found]


def _quoted(words: str) -> str:
    """Words as one argument of a shell."""
    return '"' + "".join(c for c in words if c not in '"`$\\') + '"'
