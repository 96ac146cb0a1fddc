"""Where the parts of imported components stand in the program, also after their code was edited."""

import difflib
import re
from collections.abc import Sequence

from c2s_engine.structure.components import Component, ComponentId

Chunk = tuple[ComponentId, str, bool]
"""Component, text, and whether the text carries its own spacing."""


def chunks(components: Sequence[Component]) -> list[Chunk]:
    """The parts of all components in the order in which they stand.

    Parts of imported code stand where they stood. A component that has been written anew stands in one piece: G where
    it began, R after the world model (all may read it), the others where they ended (what they read stands before
    that). One that is new follows its predecessor.
    """
    if not any(c.layout for c in components):
        return [(c.id, c.code, c.origin == "imported") for c in components]
    placed: list[tuple[tuple[float, int], Chunk]] = []
    after = -1.0
    for rank, component in enumerate(components):
        if component.layout and component.origin in ("imported", "by_hand"):
            places: list[float] = [float(place) for place, _ in component.layout]
            for place, text in zip(places, parts(component), strict=True):
                if text:
                    placed.append(((place, rank), (component.id, text, True)))
        else:
            places = [place for place, _ in component.layout] or [after]
            place = {"G": places[0], "R": _after_model(components[0])}.get(component.id, places[-1])
            placed.append(((place, rank), (component.id, component.code, component.origin == "imported")))
        after = max(after, *places)
    placed.sort(key=lambda p: p[0])
    return [chunk for _, chunk in placed]


def _after_model(settings: Component) -> float:
    """The place after the part of G that names the world model; after G's first where that was written anew."""
    own = settings.origin in ("imported", "by_hand")
    named = [place for place, text in settings.layout if own and re.search(r"^model\s", text, re.M)]
    return next(iter([*named, *(place for place, _ in settings.layout)]), 0) + 0.5


def parts(component: Component) -> list[str]:
    """A component's code cut into the parts of its layout; an edited code is aligned with what it was, line by line."""
    texts = [text for _, text in component.layout]
    if component.code == "".join(texts):
        return texts
    old, _ = _lines("".join(texts))
    new, ended = _lines(component.code)
    matcher = difflib.SequenceMatcher(None, old, new, autojunk=False)
    moved = {}
    for i, j, size in matcher.get_matching_blocks():
        for k in range(size):
            moved[i + k] = j + k
    borders, at = [0], 0
    for text in texts[:-1]:
        at += text.count("\n")
        borders.append(_border(at, moved, len(old), len(new), borders[-1]))
    borders.append(len(new))
    lines = [line + "\n" for line in new]
    if lines and not ended:
        lines[-1] = lines[-1][:-1]
    return ["".join(lines[a:b]) for a, b in zip(borders, borders[1:], strict=False)]


def _lines(text: str) -> tuple[list[str], bool]:
    """The lines of a text without their ends, and whether the last one is ended."""
    lines = text.split("\n")
    return (lines[:-1], True) if lines[-1] == "" else (lines, False)


def _border(at: int, moved: dict[int, int], old: int, new: int, least: int) -> int:
    """Where a border before line `at` of the old code lies in the new one: before the next line that is still there."""
    for line in range(at, old):
        if line in moved:
            return max(least, moved[line])
    return max(least, new)
