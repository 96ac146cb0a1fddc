"""What can be recognised of an imported component: a typed spec, and one sentence that says what its code does.

What S cannot say of it is listed as unmet: it stays code, and falls away where the component is written anew.
"""

import ast
import functools
import re
from collections.abc import Mapping, Sequence
from importlib.resources import files
from pathlib import PurePath
from typing import Any, get_args

import yaml

from c2s_engine.check import circumstances
from c2s_engine.check.conduct import Conduct, Reader
from c2s_engine.check.telling import listed, placed, runs, sentence, statement, statements, where_of
from c2s_engine.check.values import Values, said
from c2s_engine.check.whereabouts import Whereabouts
from c2s_engine.structure import specs
from c2s_engine.structure.components import Unmet
from c2s_engine.structure.vocabulary import VehicleType

_BLUEPRINT = re.compile(r"[a-z]+(\.[a-z0-9_]+)+")
COUNTED = 8  # the most that S counts


@functools.cache
def table() -> dict[str, Any]:
    return yaml.safe_load(files("c2s_engine.check").joinpath("importer.yaml").read_text(encoding="utf-8"))


class Context:
    """The whole program: its statements with their components, and for each the statements that make what it uses."""

    def __init__(self, units: Sequence[Any], makers: Sequence[Sequence[int]]) -> None:
        self.units = units
        self.makers = makers
        self.values = Values(list(units))
        self.attributes = [_attributes(u) for u in units]
        self.made = {u.component: self._main(u) for u in units if u.kind in ("ego", "object")}
        self.ids = {self.name(c) or c: c for c in self.made}
        self.types = {name: self._type(self.made[c]) or "other" for name, c in self.ids.items() if self.made[c]}
        self.whereabouts = Whereabouts(self.values, self.types, table()["halves"])
        self.reader = Reader(self.values, self.ids, table())
        junctions = {n for i, u in enumerate(units) if self._junction(i) for n in u.defines} | {"intersection"}
        self.restrictions = circumstances.Restrictions(self.values, self.whereabouts, self.ids, junctions)
        self.limits, self.left = self.restrictions.read([u for u in units if u.kind == "restriction"])

    def describe(self, cid: str, units: Sequence[Any]) -> tuple[Any, str, tuple[Unmet, ...]]:
        """Spec, description and what S does not say of a component made of these statements."""
        if cid == "G":
            return (*self._settings(units), ())
        if cid == "R":
            return (*self._place(units), ())
        if cid == "T":
            return self._restrictions(units)
        return self._object(cid, units)

    # What the statements make.

    def _main(self, unit: Any) -> Any:
        """The object that a statement makes; ego's where it makes several."""
        from scenic.syntax import ast as s

        own = [n.value for n in ast.walk(unit.tree) if isinstance(n, s.TrackedAssign) and isinstance(n.target, s.Ego)]
        inside = [n for value in own for n in ast.walk(value) if isinstance(n, s.New)]
        return next(iter(inside or self._objects([unit])), None)

    def _objects(self, units: Sequence[Any]) -> list[Any]:
        from scenic.syntax import ast as s

        return [n for n in _nodes(units, s.New) if n.className not in table()["points"]]

    def name(self, cid: str) -> str:
        """The name that an object has in the program; empty where it has none."""
        if cid == "E":
            return "ego"
        unit = next(u for u in self.units if u.component == cid and u.kind == "object")
        made = self.made[cid]
        for node in ast.walk(unit.tree):
            if not isinstance(node, ast.Assign) or not isinstance(node.targets[0], ast.Name):
                continue
            if made is None or any(part is made for part in ast.walk(node.value)):
                return node.targets[0].id
        return ""

    def _type(self, made: Any) -> str | None:
        """The type of S of an object's class, through the classes that the program derives."""
        name = made.className if made is not None else ""
        for _ in range(10):
            if name in table()["types"]:
                return str(table()["types"][name])
            name = self.values.classes.get(name, "")
        return None

    def _junction(self, i: int) -> bool:
        """Whether a statement draws an intersection."""
        tree, own = self.units[i].tree, self.attributes[i]
        drawn = any(isinstance(n, ast.Call) and getattr(n.func, "id", "") == "Uniform" for n in ast.walk(tree))
        reached = own.union(*(self.attributes[j] for j in self.makers[i]))
        return drawn and "intersections" in reached and not own & {"maneuvers", "incomingLanes"}

    def _ancestors(self, cid: str) -> list[int]:
        """The statements that a component's object rests on, the nearest first; what its behaviour is given leads."""
        from scenic.syntax import ast as s

        made = self.made.get(cid)
        given = [w.value for w in getattr(made, "specifiers", ()) if isinstance(w, s.WithSpecifier)]
        given = [n.id for value in given for n in ast.walk(value) if isinstance(n, ast.Name)]
        found: list[int] = []

        def visit(i: int) -> None:
            if i not in found and self.units[i].kind != "definition":
                found.append(i)
                for j in sorted(self.makers[i], key=lambda j: (not self.units[j].defines & set(given), -j)):
                    visit(j)

        for i, unit in enumerate(self.units):
            if unit.component == cid and unit.kind in ("ego", "object"):
                visit(i)
        return found

    # The components.

    def _settings(self, units: Sequence[Any]) -> tuple[Any, str]:
        from scenic.syntax import ast as s

        params = {p.identifier: self.values.literal(p.value) for n in _nodes(units, s.Param) for p in n.elts}
        models = [n.name for n in _nodes(units, s.Model)]
        path, town, weather = params.get("map"), params.get("carla_map"), params.get("weather")
        name = town if isinstance(town, str) else PurePath(str(path)).stem if path else None
        preset = weather if isinstance(weather, str) and re.fullmatch(r"[A-Z][a-z]\w+", weather) else None
        told = [f"the map is {name}" if name else "", f"the weather is {preset}" if preset else ""]
        told += [f"the world model is {models[-1]}" if models else ""]
        others = sorted(k for k in params if k not in ("map", "carla_map", "weather"))
        told += ["it sets " + listed(others) if others else ""]
        return specs.SettingsSpec(map=name, preset=preset), sentence(told, "Settings of the program")

    def _place(self, units: Sequence[Any]) -> tuple[Any, str]:
        trees = {i: u.tree for i, u in enumerate(self.units)}
        spec = circumstances.place(trees, self._ancestors("E"), self.restrictions.to_junction)
        names = [n for u in units for n in sorted(u.defines - u.loops) if not n.startswith("_")]
        named = listed(list(dict.fromkeys(names)))
        if spec.kind != "intersection":
            return spec, sentence([f"places and values on the road network: {named}" if named else ""], "")
        arms = f" of {spec.arms} roads" if spec.arms else ""
        lights = " with traffic lights" if spec.control == "signal" else ""
        ways = {"left": "turns left", "right": "turns right", "straight": "goes straight", "u_turn": "turns round"}
        way = f", where ego {ways[spec.manoeuvre]}" if spec.manoeuvre else ""
        return spec, sentence([f"an intersection{arms}{lights}{way}", f"the code names {named}" if named else ""], "")

    def _restrictions(self, units: Sequence[Any]) -> tuple[Any, str, tuple[Unmet, ...]]:
        from scenic.syntax import ast as s

        required = [u for u in units if _nodes([u], s.Require | s.RequireMonitor) and u.kind == "restriction"]
        ends = [u for u in units if _nodes([u], s.TerminateWhen | s.TerminateSimulationWhen)]
        durations = [said(v) for n in _nodes(units, s.TerminateAfter) if (v := self._seconds(n)) is not None]
        told = [
            f"it requires {statements(required)}" if required else "",
            f"it ends when {statements(ends)}" if ends else "",
            f"it ends after {durations[-1]} s" if durations else "",
            "values are recorded" if _nodes(units, s.Record | s.RecordInitial | s.RecordFinal) else "",
        ]
        left = [u for u in self.left if u.component == "T"]
        return self.limits, sentence(told, ""), tuple(_stays(statement(u)) for u in left)

    def _seconds(self, node: Any) -> Any:
        from scenic.syntax import ast as s

        return self.values.number(node.duration.value) if isinstance(node.duration, s.Seconds) else None

    def _object(self, cid: str, units: Sequence[Any]) -> tuple[Any, str, tuple[Unmet, ...]]:
        from scenic.syntax import ast as s

        made = self.made.get(cid)
        if made is None:
            return self._made_elsewhere(cid, units)
        name, kind = self.name(cid), self._type(made)
        with_ = {w.prop: w.value for w in made.specifiers if isinstance(w, s.WithSpecifier)}
        blueprint = self.values.literal(with_.get("blueprint"))
        model = blueprint if isinstance(blueprint, str) and _BLUEPRINT.fullmatch(blueprint) else None
        behavior = with_.get("behavior")
        conduct = self.reader.of(behavior) if behavior is not None else Conduct()
        count = self._count(units)
        speed, phases = _steady(conduct)
        common: dict[str, Any] = {"model": model, "speed": speed, "phases": phases}
        unmet = (
            [] if conduct.whole else [_stays(f"what {runs(behavior)} does{' beyond that' if phases or speed else ''}")]
        )
        if cid == "E":
            vehicle: Any = kind if kind in get_args(VehicleType) else "car"
            common |= {"reaction": "brake" if conduct.brakes else "none", "hard": conduct.hard}
            spec: Any = specs.EgoSpec(type=vehicle, **common)
            return spec, self._object_sentence(cid, made, common, None, behavior, conduct, units), tuple(unmet)
        placement = None if count > 1 else self._placement(cid, name, made, common)
        if placement is None:
            unmet.append(_stays("its place"))
        else:
            common["placement"] = placement
        common |= {"count": count} if 1 < count <= COUNTED else {}
        own = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name)
        spec = specs.ObjectSpec(name=own or kind or "actor", type=kind or "obstacle", **common)
        return spec, self._object_sentence(cid, made, common, placement, behavior, conduct, units), tuple(unmet)

    def _placement(self, cid: str, name: str, made: Any, common: dict[str, Any]) -> specs.Placement | None:
        """Where an object starts; one on the opposite approach also gets the way that it takes."""
        found = self.whereabouts.placement(name or cid, made, self.ids)
        if found is not None:
            return found
        opposite, way = circumstances.approach({i: u.tree for i, u in enumerate(self.units)}, self._ancestors(cid))
        if not opposite:
            return None
        action = {"left": "turn_left", "right": "turn_right", "straight": "go_straight", "u_turn": "u_turn"}
        if way is not None and not common["phases"]:
            common["phases"] = (specs.Phase.model_validate({"action": action[way]}),)
        return specs.Placement(position="opposite_approach")

    def _made_elsewhere(self, cid: str, units: Sequence[Any]) -> tuple[Any, str, tuple[Unmet, ...]]:
        """A component whose statement makes no object by itself: a function that it calls does, or nothing is there."""
        classes = list(dict.fromkeys(n.className for n in self._objects(units)))
        told = f"{'Ego' if cid == 'E' else cid} is made by a function{': ' if classes else ''}{listed(classes)}."
        spec = specs.EgoSpec() if cid == "E" else specs.ObjectSpec(type="obstacle")
        return spec, told if units else "", (_stays("the whole component"),) if units else ()

    def _count(self, units: Sequence[Any]) -> int:
        """How often a loop `for ... in range(N)` makes the object; 0 where none does."""
        for node in _nodes([u for u in units if u.kind == "object"], ast.For | ast.comprehension):
            call = node.iter
            if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "range" and len(call.args) == 1:
                value = self.values.number(call.args[0])
                if isinstance(value, float) and value >= 1:
                    return int(value)
        return 0

    def _object_sentence(
        self,
        cid: str,
        made: Any,
        common: Mapping[str, Any],
        placement: Any,
        behavior: Any,
        conduct: Conduct,
        units: Sequence[Any],
    ) -> str:
        """The sentence on an object."""
        kind = self._type(made)
        count, objects = self._count(units), len(self._objects(units))
        where = placed(placement, self.ids) if placement is not None else where_of(made)
        subject = "Ego" if cid == "E" else self.name(cid) or cid
        text = f"{subject} is a {kind.replace('_', ' ') if kind else made.className}"
        text += f" ({common['model']})" if common["model"] else ""
        text += f", made {count} times," if count > 1 else ""
        text += f" {where}" if where else ""
        if behavior is not None:
            text += f"{'' if text.endswith(',') else ','} which runs {runs(behavior)}"
        speeds = [said(p.speed) for p in conduct.phases if p.speed is not None]
        text += f" ({speeds[0]} m/s)" if speeds else ""
        text += " and brakes for what is near" if conduct.brakes and cid == "E" else ""
        return text.rstrip(",") + (f"; the component makes {objects} objects." if objects > 1 else ".")


def _steady(conduct: Conduct) -> tuple[Any, tuple[specs.Phase, ...]]:
    """Speed and phases of a spec: one that just drives on needs no phase."""
    phases = conduct.phases
    if phases and phases[0].action == "keep_lane" and phases[0].trigger is None and phases[0].duration is None:
        return phases[0].speed, tuple(phases[1:])
    return None, tuple(phases)


def _stays(text: str) -> Unmet:
    return Unmet(text=text, reason="no field of S says it: it stays code, until this component's code is rewritten")


def _nodes(units: Sequence[Any], kinds: Any) -> list[Any]:
    return [n for u in units for n in ast.walk(u.tree) if isinstance(n, kinds)]


def _attributes(unit: Any) -> set[str]:
    return {n.attr for n in ast.walk(unit.tree) if isinstance(n, ast.Attribute)}
