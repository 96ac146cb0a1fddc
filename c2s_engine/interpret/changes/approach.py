"""How far ego is from the place at the start: "let ego start 60 m before the intersection"."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, quantity_of, value_of
from c2s_engine.interpret.surroundings.approach import PLACE
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import SetField
from c2s_engine.structure.specs import PlaceSpec

OPEN = ("road", "straight", "curve", "motorway")
"""Kinds of place to which there is no distance."""


def start_distance(clause: str, structure: Structure) -> Found | None:
    """ "Ego is 60 m from the junction", "the intersection is 60 m ahead": only where there is such a place."""
    far = quantity_of(clause, "distance")
    place = structure.place.spec
    assert isinstance(place, PlaceSpec)
    if far is None or place.kind in OPEN and not place.crosswalk:
        return None
    said = f"{clause[: far['at']]}<far>{clause[far['end'] :]}"
    forms = (form.replace("{place}", PLACE) for form in language.table("refine")["start_distance"])
    if not any(re.match(form, said) for form in forms):
        return None
    edit = SetField(component="R", path="distance", value=value_of(far))
    return [edit], f"ego starts {far['low']:g} m before the place"
