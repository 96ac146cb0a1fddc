"""Which component of S a phrase means: "the lead", "O2", "the second car", "the pedestrian's", "it"."""

import re
from collections.abc import Iterable
from typing import get_args

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.chosen import chosen
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.structure.vocabulary import MOTOR, Action, ObjectType

FAMILY = {
    "vehicle": MOTOR,
    "rider": ("bicycle", "motorcycle"),
    "pedestrian": ("pedestrian", "child"),
    "obstacle": ("obstacle", "box", "debris", "container", "barrel"),
    "car": ("car", "police_car"),
    "child": ("child", "pedestrian"),
    "truck": ("truck", "pickup", "fire_truck"),
}


def objects_of(structure: Structure, kind: str) -> list[Component]:
    """The objects that a noun of that type can mean."""
    family = FAMILY.get(kind, (kind,))
    exact = [c for c in structure.objects if spec_of(c).type == kind]
    return exact or [c for c in structure.objects if spec_of(c).type in family]


def spec_of(component: Component) -> ObjectSpec:
    """The component's spec as an object's."""
    assert isinstance(component.spec, ObjectSpec)
    return component.spec


def refer(text: str, structure: Structure, *, alone: bool = True) -> Component | None:
    """The component that the first noun of a phrase means, or None. `alone`: "it" means the only object."""
    plain = scan.normalised(text)
    if ones := re.search(r"\b(parked|oncoming|crossing) ones?\b", plain):
        placed = [c for c in structure.objects if ones[1] in spec_of(c).placement.position]
        if placed:
            return placed[0]
    match = re.search(r"\bo([1-9][0-9]?)\b", plain)
    if match and f"O{match[1]}" in structure:
        return structure[f"O{match[1]}"]
    names = [s for s in scan.names(plain) if s.kind in ("actor", "ego", "label") and s.data.get("noun") != "traffic"]
    for component in structure.objects:
        name = spec_of(component).name.replace("_", " ")
        if re.search(rf"\b{re.escape(name)}\b", plain) and (len(name) > 2):
            first = plain.find(name)
            if not names or first <= names[0].end:
                roles = names[0].data.get("roles", ()) if names and names[0].start <= first else ()
                alike = objects_of(structure, spec_of(component).type)
                return chosen(plain[:first], name, roles, alike, structure.text)
    for span in names:
        if span.kind == "ego":
            return structure.ego
        if "label" in span.data and (meant := labelled(span.data["label"], structure)):
            return meant
        if span.kind == "label":
            return None
        found = objects_of(structure, span.data["type"])
        if span.data.get("noun") in language.words("adults"):
            found = [c for c in found if spec_of(c).type != "child"]
        alike = [c for c in found if (spec_of(c).count > 1) == bool(span.data.get("plural"))]
        found = alike or found
        if not found and span.data["type"] in ("child", "pedestrian"):
            found = []
        found = found or [c for c in structure.objects if span.data["noun"] in spec_of(c).name.split("_")]
        if found:
            return chosen(plain[: span.start], span.data["noun"], span.data["roles"], found, structure.text)
        if language.actor_nouns().get(span.data.get("noun", "")):
            return None
    if (
        alone
        and re.search(r"\b(it|its|that one|he|she|they|them|their|his|her|that)\b|^\s*$", plain)
        and structure.objects
    ):
        movers = list(structure.objects)
        return movers[0] if len(movers) == 1 else movers[-1]
    return None


def labelled(label: str, structure: Structure) -> Component | None:
    """Who has a label ("2" of "Unit 2", "npc 7", "pov") by the text, or by his name in the program; number 1 that
    nobody else has is ego."""
    named = next((c for c in structure.objects if label in _labels(c)), None)
    return named or (structure.ego if label == "1" else None)


def _labels(component: Component) -> set[str]:
    """The labels by which the text tells of an object, and that of its name ("v2")."""
    name = spec_of(component).name
    told = [scan.normalised(link.label) for link in component.links if link.kind == "text"]
    spans = [(s, words) for words in (name, *told) for s in scan.names(words)]
    return {s.data["label"] for s, words in spans if "label" in s.data and (s.start, s.end) == (0, len(words))}


def first_actor_type(sentence: str) -> ObjectType:
    """The type of the first road user or thing that a sentence names; a car where it names none."""
    types = (s.data["type"] for s in scan.names(scan.normalised(sentence)) if s.kind == "actor")
    return next((t for t in types if t in get_args(ObjectType)), "car")


def actions_of(component: Component) -> list[str]:
    """What an object does, in order."""
    return [p.action for p in spec_of(component).phases]


def doing(words: str, actions: Iterable[str]) -> bool:
    """Whether one of the actions is what the words say that begin with a stem of doing."""
    for stem, done in language.table("refine")["doers"].items():
        if re.search(rf"\b(?:{stem})", words) and any(action in done for action in actions):
            return True
    return False


def actions_named(words: str) -> list[Action]:
    """The acts that the words tell by a verb of doing, the likeliest first."""
    stems = language.table("refine")["doers"].items()
    return next((done for stem, done in stems if re.search(rf"\b(?:{stem})", words)), [])
