"""A user's program as component snippets: decomposed by the importer, described by a model or from the specs."""

from collections.abc import Awaitable, Callable
from typing import Any

from c2s_engine.retrieve.terms import imported_terms
from c2s_engine.structure.components import Component, Structure


async def component_snippets(
    program: str,
    decompose: Callable[[str], Awaitable[Structure]],
    describe: Callable[[str, str], Awaitable[str]] | None = None,
) -> list[dict[str, Any]]:
    """The components R, E, O and T of a program with code, described: {"component", "description", "code"}, and
    what each is about in the vocabulary's words, by which it is chosen for a component of S (retrieve.terms)."""
    structure = await decompose(program)
    found = []
    for component in structure.components:
        if component.kind == "G" or not component.code.strip():
            continue
        sentence = await describe(component.kind, component.code) if describe else ""
        sentence = sentence.strip() or component.description.strip() or words_of(component)
        code = component.code.strip("\n") + "\n"
        terms = imported_terms(structure, component.id)
        found.append({"component": component.kind, "description": sentence, "code": code, **terms})
    return found


def words_of(component: Component) -> str:
    """A sentence made of what a spec says: its names in plain words."""
    data = component.spec.model_dump(exclude_defaults=True, exclude={"component"})
    words = [w for w in _words(data) if not w.isdigit()]
    name = {"R": "Place", "E": "Ego", "O": "Object", "T": "Restrictions"}[component.kind]
    return f"{name}: {', '.join(dict.fromkeys(words))}" if words else f"{name} of {component.id}"


def _words(value: Any) -> list[str]:
    if isinstance(value, dict):
        return [w for v in value.values() for w in _words(v)]
    if isinstance(value, list | tuple):
        return [w for v in value for w in _words(v)]
    return [value.replace("_", " ")] if isinstance(value, str) else []
