"""The typed writer: renders each component's spec, and says whose specs it looks at for that."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c2s_engine.maps.expressions import PlaceCode, place_code
from c2s_engine.maps.extras import MapExtras
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.quantity import high
from c2s_engine.structure.regenerate import spec_references
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write.typed import kernel, scope
from c2s_engine.write.typed.ego import write_ego
from c2s_engine.write.typed.objects import write_object
from c2s_engine.write.typed.place import candidates, write_place
from c2s_engine.write.typed.plan import Plan, make_plan
from c2s_engine.write.typed.restrictions import write_restrictions
from c2s_engine.write.typed.settings import write_settings
from c2s_engine.write.typed.spread import spread
from c2s_engine.write.typed.tables import is_static
from c2s_engine.write.typed.threats import threatening


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
        """The objects that the component's spec names; what else it rests on comes through the plan (`inputs`)."""
        return spec_references(structure, cid) - {"E"}

    def inputs(self, structure: Structure, cid: ComponentId) -> Any:
        """The facts of the plan, and of the objects named, that the fragment rests on."""
        if cid == "G":
            return []
        structure = spread(structure)
        plan = make_plan(structure, self.room)
        return [self._facts(structure, cid, plan), structure[cid].spec.model_dump(mode="json") if cid[0] == "O" else 0]

    def _facts(self, structure: Structure, cid: ComponentId, plan: Plan) -> Any:
        if cid == "T":
            return [plan.duration, self._named(structure, cid)]
        if cid == "R":
            return [self._place_facts(plan), sorted(self._kernel(structure, plan))]
        facts: list[Any] = [
            plan.place.kind, plan.place.control, plan.place.manoeuvre, plan.place.oncoming, round(plan.ego_speed, 2),
            plan.distance, structure.ego.spec.model_dump(include={"reaction", "phases"}), sorted(plan.offsets),
            [a for a in plan.approaches if cid != "E"], self._named(structure, cid),
        ]  # fmt: skip
        still = [[c.id, c.spec.model_dump(mode="json", include={"type", "placement"})] for c in structure.objects if
                 isinstance(c.spec, ObjectSpec) and is_static(c.spec)]  # fmt: skip
        facts.append([s for s in still if s[0] != cid])
        facts.append([[o, scope.variables(structure)[o]] for o in plan.leads.get(cid, ())])
        if cid == "E":
            return [
                *facts,
                [[o, scope.variables(structure)[o]] for o in threatening(structure)],
                structure.settings.spec.model_dump().get("light"),
            ]
        return facts

    def _place_facts(self, plan: Plan) -> list[Any]:
        return [
            plan.place.model_dump(mode="json"), plan.before, plan.after if plan.distance is None else 0, plan.distance,
            sorted(plan.offsets), plan.base, plan.approaches, plan.oncoming, plan.ramp, plan.exit_lane,
        ]  # fmt: skip

    def _named(self, structure: Structure, cid: ComponentId) -> list[Any]:
        names = scope.variables(structure)
        others = sorted(spec_references(structure, cid) - {"E"})
        own = [names.get(cid)]
        return own + [[names[o], structure[o].spec.model_dump(mode="json", exclude_defaults=True)] for o in others]

    def write(self, structure: Structure, cid: ComponentId) -> Component:
        """The component with its fragment; raises ResolveError where specs contradict each other."""
        component = structure[cid]
        structure = spread(structure)
        plan = make_plan(structure, self.room)
        body = self._body(structure, cid, plan)
        border = f"## {cid}: {_one_line(component.description)}".rstrip(": ").rstrip()
        return component.model_copy(update={"code": f"{border}\n{body}\n", "origin": "rendered", "conflict": None})

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
        return write_place(plan, code, self._kernel(structure, plan))

    def place(self, plan: Plan) -> PlaceCode:
        """The code that selects the place on the map."""
        room = (plan.before + plan.after) * self.room if plan.distance is None else high(plan.distance) + plan.before
        spec = plan.place.model_copy(update={"kind": "on_ramp"}) if plan.ramp else plan.place
        return place_code(spec, self.map.extras, room=room)

    def candidates(self, structure: Structure) -> str:
        """The list from which the program draws its place; how long it is says how many places there are."""
        plan = make_plan(spread(structure), self.room)
        return candidates(plan, self.place(plan))

    def _kernel(self, structure: Structure, plan: Plan) -> frozenset[str]:
        others = write_ego(structure, plan) + "".join(write_object(structure, c.id, plan) for c in structure.objects)
        return kernel.needed(others)


def _one_line(text: str) -> str:
    return " ".join(text.split())
