"""S as requirements are derived from it: who there is, what each component rests on, the bounds."""

from functools import cache
from typing import Any

import yaml

from c2s_engine import paths
from c2s_engine.require.paces import speed_at
from c2s_engine.structure.components import FITTED, READ, Component, Structure
from c2s_engine.structure.facts import EGO, called, component_of
from c2s_engine.structure.quantity import Range, high, low
from c2s_engine.structure.requirements import Kind, Requirement, Value
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec

TURNS = ("turn_left", "turn_right", "go_straight", "u_turn")
"""Ways over a junction: who stood before it begins its own as it sets out."""
STOPS = ("stop", "wait", "yield")


@cache
def bounds() -> dict[str, Any]:
    """The table of bounds (data/requirements.yaml)."""
    return yaml.safe_load(paths.shipped("requirements.yaml").read_text("utf-8"))


@cache
def vocabulary() -> dict[str, Any]:
    """The meanings of S's names (data/vocabulary.yaml); of an action, the events that show it."""
    return yaml.safe_load(paths.shipped("vocabulary.yaml").read_text("utf-8"))


def shown_by(action: str) -> tuple[str, ...]:
    """The events that show an action, any of them."""
    return tuple(vocabulary()["actions"][action].get("shows", ()))


def kmh(least: float, most: float) -> str:
    """A speed or a range of speeds (m/s) as people read it."""
    return f"{least * 3.6:.0f} km/h" if least == most else f"{least * 3.6:.0f} to {most * 3.6:.0f} km/h"


class Scene:
    """S, read once. Actors are named as in references: 'ego', 'O1'."""

    def __init__(self, structure: Structure):
        self.structure = structure
        assert isinstance(structure.ego.spec, EgoSpec) and isinstance(structure.place.spec, PlaceSpec)
        self.ego, self.place = structure.ego.spec, structure.place.spec
        self.objects = {o.id: o.spec for o in structure.objects if isinstance(o.spec, ObjectSpec)}

    def component(self, actor: str) -> Component:
        return self.structure.ego if actor == "ego" else self.structure[actor]

    @property
    def actors(self) -> dict[str, EgoSpec | ObjectSpec]:
        return {"ego": self.ego, **self.objects}

    def recognised(self, actor: str) -> bool:
        """Whether the component's spec says what it does: not so where its code is by hand or was imported."""
        return self.component(actor).recognised

    def of_text(self, actor: str) -> bool:
        """Whether what its run must not show is known: its spec says what it does, or a text that its code by hand
        departs from did."""
        by_hand = self.component(actor).origin == "by_hand" and bool(self.structure.text)
        return by_hand or self.recognised(actor)

    def says(self, actor: str, field: str) -> bool:
        """Whether S says a field of a component: of imported ones only what was recognised, never what is a default."""
        if self.recognised(actor):
            return True
        name, spec = field.split(".")[0], self.actors[actor]
        return getattr(spec, name) != type(spec).model_fields[name].get_default(call_default_factory=True)

    def stated(self, component: str, field: str) -> bool:
        """Whether the text says it: S may have assumed it."""
        return all(a.field != field or a.by in (FITTED, READ) for a in self.structure[component].assumed)

    def speed(self, actor: str, said: EgoSpec | ObjectSpec | Phase, path: str) -> Range | None:
        """The speed (m/s) that S says in a number or in a word, from and to; None: it says none."""
        if said.speed is not None and (said.pace is None or self.stated(component_of(actor), path)):
            stated = self.stated(component_of(actor), path)
            return (low(said.speed), high(said.speed)) if stated else None
        return speed_at(self.actors[actor].type, said.pace, self.place) if said.pace is not None else None

    def named(self, actor: str | None) -> str:
        """How sentences call an actor."""
        if actor is None:
            return "another"
        return "ego" if actor == "ego" else f"{actor} ({self.objects[actor].name})"

    def phases(self) -> list[tuple[str, int, Phase]]:
        """(actor, index, phase) of all; who goes on with a turn after a stop on the way sets out again."""
        return [(a, i, p.model_copy(update={"action": "start"}) if _goes_on(spec.phases[: i + 1]) else p)
                for a, spec in self.actors.items() for i, p in enumerate(spec.phases)]  # fmt: skip

    def overtakes(self, one: str | None, other: str) -> bool:
        """Whether one actor overtakes another; it may be left open whom."""
        spec = self.actors.get(called(one or EGO))
        whom = "ego" if isinstance(spec, ObjectSpec) else other
        return spec is not None and any(p.action == "overtake" and (p.target or whom) == other for p in spec.phases)

    def make(self, kind: Kind, check: str, actor: str, path: str, text: str, *, other: str | None = None,
             component: str | None = None, **values: Value) -> Requirement:  # fmt: skip
        """A requirement with its id and its clause."""
        cid = component or component_of(actor)
        links = [(link.field, link.span) for link in self.structure[cid].links if link.span and link.kind == "text"]
        exact = [span for field, span in links if field and f"{path}.".startswith(f"{field}.")]
        spans = exact or [span for _, span in links]
        clause = (min(s[0] for s in spans), max(s[1] for s in spans)) if len(spans) == 1 else next(iter(spans), None)
        return Requirement(
            id=f"{cid}.{path}", kind=kind, component=cid, text=text, clause=clause, check=check, actor=actor,
            other=other, values=values,
        )  # fmt: skip


def _goes_on(phases: tuple[Phase, ...]) -> bool:
    """Whether the last of some phases goes on with the way over a junction that was begun before a stop."""
    begun = [p.action for p in phases[:-2]]
    return len(phases) > 2 and phases[-1].action in TURNS and phases[-1].action in begun and phases[-2].action in STOPS
