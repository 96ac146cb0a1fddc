"""Snippets near to what no field can say. No turn waits for them: a front asks once the turn is over."""

from typing import Any

from c2s_engine.structure.components import Structure
from c2s_engine.structure.progress import Passage

EACH = 2
"""Snippets for each thing that is unmet."""
MOST = 4
"""Unmet things that are looked up."""


def wanted(structure: Structure) -> list[tuple[str, str]]:
    """(component, words) of what is unmet and can be code of a component; what no component took up has none, and a
    single word or a value ("40 m") is near to nothing."""
    found = [(c.id, u.text) for c in structure.components if c.id != "G" for u in c.unmet if u.text.strip()]
    found += [("", u.text) for u in structure.not_understood if sum(w.isalpha() for w in u.text.split()) > 1]
    return list(dict.fromkeys(found))[:MOST]


async def snippets(structure: Structure, retrieval: Any) -> list[tuple[str, str, list[Passage]]]:
    """(component, words, snippets near to them); raises RetrievalError. The first search of all may take seconds: it
    starts the worker and may build the index."""
    asked = wanted(structure)
    if asked:
        await retrieval.ready(lambda *_: None)
    found = []
    for cid, words in asked:
        found.append((cid, words, await retrieval.search(words, kind="snippet", component=cid[:1] or None, limit=EACH)))
    return [entry for entry in found if entry[2]]
