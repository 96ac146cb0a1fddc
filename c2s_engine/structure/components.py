"""Components and the structure S = {G, R, E, O1..N, T} (the paper, "Logical Structure Schema")."""

import re
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field, model_validator

from c2s_engine.structure.leaves import value_at
from c2s_engine.structure.quantity import Quantity
from c2s_engine.structure.specs import (
    AnySpec,
    EgoSpec,
    PlaceSpec,
    RestrictionsSpec,
    SettingsSpec,
)
from c2s_engine.structure.vocabulary import Origin

ComponentId = str
"""G, R, E, T, or O1, O2, ...: stable; removing O1 does not rename O2."""

OBJECT_ID = re.compile(r"O[1-9][0-9]?")


class Frozen(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class Link(Frozen):
    """What a component rests on."""

    kind: Literal["text", "rule", "clause", "snippet", "chunk"]
    label: str = Field(description="the words of the text, the rule's or the source's name")
    span: tuple[int, int] | None = Field(None, description="offsets in the user's text")
    field: str = Field("", description="the field of the component's spec that the words became, where that is known")


READ = "reader"
"""Who decided, in `assumed`, where the text says it and the reader is not certain of it."""
WORDS = "words"
"""The same, where a word of the text ("hard") stands for a usual number."""
FITTED = "place"
"""By whom a value is assumed that was said and does not fit the place: the new one counts as said."""


class Assumption(Frozen):
    """What the text left open, and the value that was chosen."""

    field: str
    value: str
    reason: str
    by: str = Field("", description="`writer`, `planner`, `place` where these decided; else whoever read the text")
    amount: Quantity | None = Field(None, description="the value as a number, SI units, where it is not in the spec")
    was: str = Field("", description="what was said in its place, where that was given up")

    @property
    def called(self) -> str:
        """The field in words: "gap" for placement.gap, "phase 2 trigger" for phases.1.trigger."""
        return field_words(self.field)


def field_words(path: str) -> str:
    """A field of a spec in words, numbers from 1."""
    path = re.sub(r"(\w+?)s\.(\d+)", lambda m: f"{m[1]} {int(m[2]) + 1}", path)
    return path.removeprefix("placement.").replace(".", " ").replace("_", " ")


class Unmet(Frozen):
    """What the text asks for and the spec cannot say."""

    text: str
    reason: str
    span: tuple[int, int] | None = None


class Component(Frozen):
    """One component of S with its fragment of the program."""

    id: ComponentId
    description: str = ""
    generated: bool = Field(False, description="whether the description is made from the spec")
    spec: AnySpec
    code: str = ""
    origin: Origin = "rendered"
    links: tuple[Link, ...] = ()
    assumed: tuple[Assumption, ...] = ()
    unmet: tuple[Unmet, ...] = ()
    key: str = Field("", description="the digest under which `code` was written; empty: not written yet")
    conflict: str | None = Field(None, description="what would be written, where code by hand stands against it")
    by_hand: Literal["", "same", "apart"] = Field(
        "", description="what is known of code by hand: what would be written but for comments; kept against its fields"
    )

    @property
    def kind(self) -> str:
        """G, R, E, O or T."""
        return self.id[0]

    def with_own_code(self, code: str) -> "Component":
        """The component with code that somebody wrote; nothing is known yet of how it stands to the fields."""
        return self.model_copy(update={"code": code, "origin": "by_hand", "conflict": None, "by_hand": ""})

    @property
    def recognised(self) -> bool:
        """Whether the code does what the spec says, and no more: not known of most code by hand or imported."""
        return self.origin not in ("by_hand", "imported") or self.by_hand == "same"

    def amount(self, path: str) -> Quantity | None:
        """The number that its code was written with for a field: the writer's, where S leaves it open; SI units."""
        for note in self.assumed:
            if note.field == path and note.amount is not None:
                return note.amount
        value = value_at(self.spec, path)
        return value if isinstance(value, float | int | tuple) else None


class Structure(Frozen):
    """S, with the text it was read from."""

    text: str = ""
    settings: Component = Component(id="G", spec=SettingsSpec())
    place: Component = Component(id="R", spec=PlaceSpec())
    ego: Component = Component(id="E", spec=EgoSpec())
    objects: tuple[Component, ...] = ()
    restrictions: Component = Component(id="T", spec=RestrictionsSpec())
    not_understood: tuple[Unmet, ...] = Field((), description="spans of the text that no component took up")
    arrangement: tuple[tuple[ComponentId, str], ...] = Field(
        (), description="a program that was opened or edited by hand, piece by piece (layout.py); empty: in S's order"
    )

    @model_validator(mode="before")
    @classmethod
    def _of_before(cls, data: Any) -> Any:
        """Sessions kept the places of scattered code with each component (until 0.1)."""
        if not isinstance(data, dict):
            return data
        parts = [data.get(k) for k in ("settings", "place", "ego", "restrictions")] + list(data.get("objects") or ())
        old = [p for p in parts if isinstance(p, dict) and "layout" in p]
        rows = sorted((place, p["id"], text) for p in old for place, text in p.pop("layout"))
        return {**data, "arrangement": [row[1:] for row in rows]} if rows else data

    read_by: str = Field("", description="the method that read the text; empty: not known, or nothing was read")
    background: tuple[Unmet, ...] = Field((), description="spans that are about something else than the scene")
    clauses: tuple[tuple[int, int], ...] = Field((), description="the text's clauses, where the method parted it")
    unread: tuple[tuple[int, int], ...] = Field((), description="words of the text on which no field rests")

    @property
    def components(self) -> tuple[Component, ...]:
        """In the order of writing (Algorithm 1): G, R, E, O1..N, T."""
        return (self.settings, self.place, self.ego, *self.objects, self.restrictions)

    @property
    def ids(self) -> tuple[ComponentId, ...]:
        return tuple(c.id for c in self.components)

    @property
    def blank(self) -> bool:
        """Whether there is nothing yet: no text, no object, no code of somebody's own."""
        return not self.text and not self.objects and not any(c.code.strip() for c in self.components)

    def __getitem__(self, cid: ComponentId) -> Component:
        for component in self.components:
            if component.id == cid:
                return component
        raise KeyError(f"there is no component {cid}; there are {', '.join(self.ids)}")

    def __contains__(self, cid: ComponentId) -> bool:
        return cid in self.ids

    def with_component(self, component: Component) -> "Structure":
        """A copy in which that component takes the place of the one with its id."""
        slot = {"G": "settings", "R": "place", "E": "ego", "T": "restrictions"}.get(component.id)
        if slot:
            return self.model_copy(update={slot: component})
        self[component.id]
        objects = tuple(component if o.id == component.id else o for o in self.objects)
        return self.model_copy(update={"objects": objects})

    def with_spec(self, cid: ComponentId, spec: AnySpec | None = None, **changes: object) -> "Structure":
        """A copy in which a component has that spec, or its own with some fields changed."""
        component = self[cid]
        return self.with_component(
            component.model_copy(update={"spec": (spec or component.spec).model_copy(update=changes)})
        )

    def next_object_id(self) -> ComponentId:
        numbers = [int(o.id[1:]) for o in self.objects]
        return f"O{max(numbers, default=0) + 1}"


def given_up(structure: Structure) -> tuple[str, ...]:
    """What was said and has another value now, since the place or its roads do not have it: "E speed 130 km/h ->
    91 km/h"."""
    return tuple(f"{c.id} {a.called} {a.was} -> {a.value}" for c in structure.components for a in c.assumed if a.was)


def unrecognised(structure: Structure) -> tuple[ComponentId, ...]:
    """The actors whose code S does not wholly say, so that what it requires covers them in part only."""
    return tuple(c.id for c in structure.components if c.kind in "EO" and not c.recognised)
