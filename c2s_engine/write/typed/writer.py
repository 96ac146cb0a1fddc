"""The typed writer: renders each component's spec, and says when a fragment is no longer what it would render."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c2s_engine import driving
from c2s_engine.maps.expressions import STRETCHES
from c2s_engine.maps.extras import MapExtras
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.program import border
from c2s_engine.write.typed.among import among
from c2s_engine.write.typed.decided import with_decisions
from c2s_engine.write.typed.ego import write_ego
from c2s_engine.write.typed.objects import write_object
from c2s_engine.write.typed.place import call, write_place
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
        return {"writer": self.name, "library": driving.digest(), "map": self.map.digest, "room": self.room}

    def reads(self, structure: Structure, cid: ComponentId) -> frozenset[ComponentId]:
        """No fragment is looked at: what is rendered rests on specs alone, and those are in `inputs`."""
        return frozenset()

    def inputs(self, structure: Structure, cid: ComponentId) -> Any:
        """What would be written now: whatever of S the fragment rests on, its key changes exactly when it does."""
        return "" if cid == "G" else self._rendered(structure, cid)

    def write(self, structure: Structure, cid: ComponentId) -> Component:
        """The component with its fragment; raises ResolveError where specs contradict each other."""
        component = structure[cid]
        code = f"{border(component)}\n{self._rendered(structure, cid)}\n"
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
            return among(structure, cid, write_object(structure, cid, plan), plan)
        return write_place(plan)

    def decided(self, structure: Structure) -> Structure:
        """S with what the writer chose for it or changed in it among what is assumed."""
        return with_decisions(structure, self.room)

    def candidates(self, structure: Structure, share: float = 0.0, across: bool = False) -> str:
        """The list from which the program draws its place; how long it is says how many places there are. `share`: of
        stretches of road only those with so much of the room that is wanted, up to the next junction or (`across`)
        straight over junctions."""
        return str(call(make_plan(spread(structure), self.room), share, across))

    def stretch(self, structure: Structure) -> float:
        """How much road (m) the structure takes where nothing but road is asked for; 0 at junctions and the like."""
        plan = make_plan(spread(structure), self.room)
        return plan.before + plan.after if plan.place.kind in STRETCHES and not plan.ramp else 0.0
