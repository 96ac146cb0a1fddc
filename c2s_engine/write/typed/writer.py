"""The typed writer: renders each component's spec, and says when a fragment is no longer what it would render."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from c2s_engine.maps.expressions import PlaceCode, place_code
from c2s_engine.maps.extras import MapExtras
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.quantity import high
from c2s_engine.write.typed import kernel
from c2s_engine.write.typed.ego import write_ego
from c2s_engine.write.typed.objects import write_object
from c2s_engine.write.typed.place import EGO_VARIES, candidates, write_place
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.planning import make_plan
from c2s_engine.write.typed.restrictions import write_restrictions
from c2s_engine.write.typed.settings import write_settings
from c2s_engine.write.typed.spread import spread


@dataclass(frozen=True)
class MapChoice:
    """The map that the program names: its file's name, CARLA's name for it, and what the writer knows of it."""

    name: str
    path: Path
    carla_map: str | None
    digest: str
    extras: MapExtras


class TypedWriter:
    """Spec to Scenic, closed under compilation: what resolves on the map compiles, samples and runs there."""

    name = "typed"

    def __init__(self, chosen: MapChoice, room: float = 1.0):
        self.map = chosen
        self.room = room

    def config(self) -> dict[str, Any]:
        return {"writer": self.name, "version": 1, "map": self.map.digest, "room": self.room}

    def reads(self, structure: Structure, cid: ComponentId) -> frozenset[ComponentId]:
        """No fragment is looked at: what is rendered rests on specs alone, and those are in `inputs`."""
        return frozenset()

    def inputs(self, structure: Structure, cid: ComponentId) -> Any:
        """What would be written now: whatever of S the fragment rests on, its key changes exactly when it does."""
        return "" if cid == "G" else self._rendered(structure, cid)

    def write(self, structure: Structure, cid: ComponentId) -> Component:
        """The component with its fragment; raises ResolveError where specs contradict each other."""
        component = structure[cid]
        border = f"## {cid}: {_one_line(component.description)}".rstrip(": ").rstrip()
        code = f"{border}\n{self._rendered(structure, cid)}\n"
        return component.model_copy(update={"code": code, "origin": "rendered", "conflict": None})

    def _rendered(self, structure: Structure, cid: ComponentId) -> str:
        structure = spread(structure)
        return self._body(structure, cid, make_plan(structure, self.room))

    def _body(self, structure: Structure, cid: ComponentId, plan: Plan) -> str:
        if cid == "G":
            return write_settings(structure.settings, self.map.path.name, self.map.carla_map)
        if cid == "E":
            return write_ego(structure, plan)
        if cid == "T":
            return write_restrictions(structure, plan)
        if cid.startswith("O"):
            return write_object(structure, cid, plan)
        code = self.place(plan)
        return write_place(plan, code, self._kernel(structure, plan), self._stop_signs)

    def place(self, plan: Plan) -> PlaceCode:
        """The code that selects the place on the map, one with the limit where there is one (the program posts it)."""
        room = high(plan.distance) + plan.before if plan.distance is not None else self._room(plan)
        spec = plan.place.model_copy(update={"kind": "on_ramp"}) if plan.ramp else plan.place
        short = plan.place.kind != "roundabout" and plan.exit_room < 25  # every junction has that much behind it
        exit_room = 0 if short else plan.exit_room
        found = place_code(spec, self.map.extras, room=room, exit_room=exit_room)
        if spec.speed_limit is None:
            return found
        anywhere = spec.model_copy(update={"speed_limit": None})
        other = place_code(anywhere, self.map.extras, room=room, exit_room=exit_room)
        if found.missing:
            return other
        return replace(found, expression=f"({found.expression} or {other.expression})", comment=found.comment)

    def _room(self, plan: Plan) -> float:
        """How long ego's lane must be where nothing ends it, m: no shorter than what stands on it ahead of ego."""
        least = plan.before + EGO_VARIES + plan.reach if plan.reach > 0 else 0.0
        return max((plan.before + plan.after) * self.room, least)

    def candidates(self, structure: Structure) -> str:
        """The list from which the program draws its place; how long it is says how many places there are."""
        plan = make_plan(spread(structure), self.room)
        return candidates(plan, self.place(plan), self._stop_signs)

    @property
    def _stop_signs(self) -> frozenset[tuple[int, int]]:
        controls = self.map.extras.controls
        return frozenset((c.junction, c.road) for c in controls if c.kind == "stop" and c.junction is not None)

    def _kernel(self, structure: Structure, plan: Plan) -> frozenset[str]:
        others = write_ego(structure, plan) + "".join(write_object(structure, c.id, plan) for c in structure.objects)
        return kernel.needed(others)


def _one_line(text: str) -> str:
    return " ".join(text.split())
