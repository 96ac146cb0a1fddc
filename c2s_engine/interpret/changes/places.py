"""What of a place a change leaves as it is: where somebody was before, and whose side alone becomes another."""

import re
from typing import Any

from c2s_engine.interpret.changes.phases import mapped
from c2s_engine.interpret.changes.refer import spec_of
from c2s_engine.interpret.changes.scene_context import located_in, on_its_way, table
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.edits import AddObject
from c2s_engine.structure.specs import ObjectSpec


def placed_before(was: Component, now: Component, there: Component, clause: str) -> dict[str, Any]:
    """Where it was: of one whose place the clause tells anew, where it really is, but for what is not told."""
    old, new = spec_of(was).placement.model_dump(), spec_of(now).placement.model_dump()
    assumed = any(a.field == "placement.position" for a in now.assumed)
    if assumed or not located_in(clause) or on_its_way(clause, there):
        return old
    real = spec_of(there).placement.model_dump()
    return real | {key: new[key] for key in ("gap", "hidden_by") if new[key] is None}


EDGES = ("roadside", "sidewalk")
"""Places beside the road, one on each side of it."""


def kept_place(changed: list[tuple[str, Any]], there: Component, told: str) -> list[tuple[str, Any]]:
    """The changes without another place at the road's edge where only the side is told."""
    spec = there.spec
    edge = isinstance(spec, ObjectSpec) and spec.placement.position in EDGES
    named = re.search(rf"{table()['roadside']}|\b(?:sidewalk|pavement|footpath|verge|shoulder)\b", told)
    hidden = any(path == "placement.hidden_by" for path, _ in changed)
    return [
        c for c in changed if not (edge and not hidden and not named and c[0] == "placement.position" and c[1] in EDGES)
    ]


def only_by_ego(told: str) -> bool:
    """Whether a sentence names ego only as the one by whom somebody is or to whom he does something."""
    spans = [s for s in scan.names(told) if s.kind == "ego"]
    return bool(spans) and all(re.search(table()["by_ego"], told[: s.start]) for s in spans)


def added_as(component: Component, cid: ComponentId, ids: dict[str, str], structure: Structure) -> AddObject:
    """One who is new, under his id here; as fast as the one before or behind whom he is put, where no speed is told."""
    spec = spec_of(component)
    place = spec.placement
    of = ids.get(place.of, place.of)
    placement = place.model_copy(update={"of": of, "hidden_by": ids.get(place.hidden_by or "", place.hidden_by)})
    update: dict[str, Any] = {"placement": placement, "phases": tuple(mapped(p, ids) for p in spec.phases)}
    untold = any(a.field == "speed" for a in component.assumed) and spec.speed
    if untold and of in structure and of != "ego" and place.position in ("ahead", "behind"):
        update["speed"] = spec_of(structure[of]).speed
    lost = tuple(u.model_copy(update={"span": None}) for u in component.unmet)
    return AddObject(
        spec=spec.model_copy(update=update), description=component.description, component=cid, unmet=lost
    )
