"""The learned reader's answer for single components of a reading that a model began."""

import re
from collections.abc import Callable
from functools import cached_property
from typing import Any

from c2s_engine.interpret.llm import words
from c2s_engine.interpret.llm.components import ObjectSentence, Sentences
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import _REFERENCE_FIELDS
from c2s_engine.structure.objects import object_spec
from c2s_engine.structure.specs import AnySpec, ObjectSpec

Reader = Callable[[str], Any]
"""What reads a text to something with a `structure`: `learned.learned`, or another."""


class StandIn:
    """The learned reader's S of a text, made when first needed."""

    def __init__(self, reader: Reader, text: str) -> None:
        self.reader, self.text = reader, text

    @cached_property
    def structure(self) -> Structure:
        """The S; an empty one where the reader refuses the text."""
        return self._read(self.text)

    def strict(self) -> Structure:
        """The S; what the reader raises passes through."""
        return self.reader(self.text).structure

    def _read(self, text: str) -> Structure:
        try:
            return self.reader(text).structure
        except ValueError:
            return Structure(text=text)

    def spec(self, cid: str, sentences: Sentences) -> AnySpec:
        """The spec that stands in for a component; references are those of the model's numbering."""
        if not cid.startswith("O"):
            theirs = self.structure[cid].spec
        else:
            partner = self._partners(sentences).get(cid)
            theirs = partner.spec if partner else self._by_itself(sentences, cid)
        back = {their.id: mine for mine, their in self._partners(sentences).items()}
        return renumbered(theirs, {"ego": "ego", **back})

    def spec_among(self, cid: str, structure: Structure) -> AnySpec:
        """The spec that stands in for a component of an S."""
        objects = tuple(ObjectSentence(type=object_spec(o).type, sentence=o.description) for o in structure.objects)
        ids = {o.id: f"O{i + 1}" for i, o in enumerate(structure.objects)}
        found = self.spec(ids.get(cid, cid), Sentences(objects=objects))
        return renumbered(found, {"ego": "ego", **{mine: theirs for theirs, mine in ids.items()}})

    def _partners(self, sentences: Sentences) -> dict[str, Component]:
        """Which of the reader's objects is which of the model's: the likest first, by type and words in common."""
        pairs = [
            (_likeness(wanted.type, wanted.sentence, their), -i, -j)
            for i, wanted in enumerate(sentences.objects)
            for j, their in enumerate(self.structure.objects)
        ]
        found: dict[str, Component] = {}
        taken: set[int] = set()
        for likeness, i, j in sorted(pairs, reverse=True):
            mine = f"O{1 - i}"
            if likeness >= 1 and mine not in found and j not in taken:
                found[mine] = self.structure.objects[-j]
                taken.add(j)
        return found

    def _by_itself(self, sentences: Sentences, cid: str) -> ObjectSpec:
        """The component's own sentence read alone; at least an object of the type that the model named."""
        wanted = sentences.objects[int(cid[1:]) - 1]
        objects = self._read(wanted.sentence).objects
        if objects:
            return object_spec(objects[0])
        return ObjectSpec.model_validate({"type": wanted.type, "name": wanted.type})


def _likeness(kind: str, sentence: str, other: Component) -> float:
    spec = object_spec(other)
    same = 2.0 if spec.type == kind else 1.0 if words.family(spec.type) == words.family(kind) else 0.0
    mine, theirs = (set(re.findall(r"[a-z]{4,}", s.lower())) for s in (sentence, other.description))
    return same + len(mine & theirs) / (1 + len(mine | theirs)) if same else 0.0


def renumbered(spec: AnySpec, ids: dict[str, str]) -> AnySpec:
    """The spec with its references translated; those without a counterpart are left out."""

    def walk(value: Any, key: str = "") -> Any:
        if isinstance(value, dict):
            pairs = ((k, walk(v, k)) for k, v in value.items())
            return {k: v for k, v in pairs if v is not _GONE}
        if isinstance(value, list | tuple):
            return [walk(v, key) for v in value]
        if key in _REFERENCE_FIELDS and isinstance(value, str):
            return ids.get(value, _GONE)
        return value

    return type(spec).model_validate(walk(spec.model_dump(exclude_none=True)))


def without_references(spec: AnySpec) -> AnySpec:
    """The spec with its references to other objects left out."""
    return renumbered(spec, {"ego": "ego"})


_GONE = object()
