"""What can be recognised of an imported component: a typed spec, and one sentence that says what its code does."""

import ast
import re
from pathlib import PurePath
from typing import Any, get_args

from c2s_engine.structure import specs
from c2s_engine.structure.vocabulary import VehicleType


class Context:
    """The whole program, for looking up what a name stands for."""

    def __init__(self, units: list[Any]) -> None:
        self.classes = {
            n.name: n.bases[0].id
            for u in units
            for n in u.tree.body
            if isinstance(n, ast.ClassDef) and n.bases and isinstance(n.bases[0], ast.Name)
        }
        self.constants: dict[str, Any] = {}
        for unit in units:
            for node in unit.tree.body:
                target = node.targets[0] if isinstance(node, ast.Assign) else None
                if isinstance(target, ast.Name) and isinstance(node.value, ast.Constant):
                    self.constants[target.id] = node.value.value

    def value(self, node: Any) -> Any:
        """A literal's value, also through a constant's name; None where it is computed."""
        if isinstance(node, ast.Constant):
            return node.value
        if isinstance(node, ast.Name):
            return self.constants.get(node.id)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "localPath" and node.args:
            return self.value(node.args[0])
        return None

    def describe(self, cid: str, units: list[Any]) -> tuple[Any, str]:
        """Spec and description of a component made of these statements."""
        if cid == "G":
            return self._settings(units)
        if cid == "R":
            return specs.PlaceSpec(), self._places(units)
        if cid == "T":
            return self._restrictions(units)
        return self._object(cid, units)

    def _settings(self, units: list[Any]) -> tuple[Any, str]:
        from scenic.syntax import ast as s

        params = {p.identifier: self.value(p.value) for n in _nodes(units, s.Param) for p in n.elts}
        models = [n.name for n in _nodes(units, s.Model)]
        path, town, weather = params.get("map"), params.get("carla_map"), params.get("weather")
        name = town if isinstance(town, str) else PurePath(str(path)).stem if path else None
        preset = weather if isinstance(weather, str) and re.fullmatch(r"[A-Z]\w+", weather) else None
        said = [f"the map is {name}" if name else "", f"the weather is {preset}" if preset else ""]
        said += [f"the world model is {models[-1]}" if models else ""]
        others = sorted(k for k in params if k not in ("map", "carla_map", "weather"))
        said += ["it sets " + ", ".join(others) if others else ""]
        return specs.SettingsSpec(map=name, preset=preset), _sentence(said, "Settings of the program")

    def _places(self, units: list[Any]) -> str:
        names = [n for u in units for n in sorted(u.defines) if not n.startswith("_")]
        return _sentence([f"places and values on the road network: {', '.join(names[:8])}" if names else ""], "")

    def _restrictions(self, units: list[Any]) -> tuple[Any, str]:
        from scenic.syntax import ast as s

        required = len(_nodes(units, s.Require)) + len(_nodes(units, s.RequireMonitor))
        ends = len(_nodes(units, s.TerminateWhen)) + len(_nodes(units, s.TerminateSimulationWhen))
        duration = None
        for node in _nodes(units, s.TerminateAfter):
            value = self.value(getattr(node.duration, "value", None))
            if isinstance(node.duration, s.Seconds) and isinstance(value, int | float) and 0 < value <= 120:
                duration = float(value)
        said = [
            f"{required} requirement{'s' * (required != 1)}" if required else "",
            f"it ends on {ends} condition{'s' * (ends != 1)}" if ends else "",
            f"it ends after {duration:g} s" if duration else "",
            "values are recorded" if _nodes(units, s.Record | s.RecordInitial | s.RecordFinal) else "",
        ]
        return specs.RestrictionsSpec(duration=duration), _sentence(said, "")

    def _object(self, cid: str, units: list[Any]) -> tuple[Any, str]:
        from scenic.syntax import ast as s

        from c2s_engine.check.importer import table, type_of

        made = [n for n in _nodes(units, s.New) if n.className not in table()["points"]]
        own = next((n for u in units if u.kind in ("ego", "object") for n in sorted(u.defines)), "")
        kind = type_of(made[0].className, self.classes) if made else None
        with_ = {w.prop: w.value for n in made[:1] for w in n.specifiers if isinstance(w, s.WithSpecifier)}
        blueprint = self.value(with_.get("blueprint"))
        blueprint = (
            blueprint if isinstance(blueprint, str) and re.fullmatch(r"[a-z]+(\.[a-z0-9_]+)+", blueprint) else None
        )
        behavior = with_.get("behavior")
        runs = behavior.func.id if isinstance(behavior, ast.Call) and isinstance(behavior.func, ast.Name) else ""
        noun = kind.replace("_", " ") if kind else (made[0].className if made else "object")
        where = _where(made[0]) if made else ""
        more = f", one of {len(made)} objects" if len(made) > 1 else ""
        subject = "Ego" if cid == "E" else (own or cid)
        model = f" ({blueprint})" if blueprint else ""
        text = (
            f"{subject} is a {noun}{model}{f' {where}' if where else ''}{more}{f' that runs {runs}' if runs else ''}."
        )
        if not made:
            text = f"{subject} is set up by the program." if cid == "E" and units else ""
        if cid == "E":
            vehicle = kind if kind in get_args(VehicleType) else "car"
            return specs.EgoSpec(type=vehicle, model=blueprint), text
        return specs.ObjectSpec(name=own or "actor", type=kind or "obstacle", model=blueprint), text


def _nodes(units: list[Any], kinds: Any) -> list[Any]:
    return [n for u in units for n in ast.walk(u.tree) if isinstance(n, kinds)]


def _where(node: Any) -> str:
    """How an object is placed, from its first specifier of position."""
    from scenic.syntax import ast as s

    words = {
        s.AtSpecifier: "at", s.OnSpecifier: "on", s.InSpecifier: "in", s.ContainedInSpecifier: "in",
        s.FollowingSpecifier: "following", s.OffsetBySpecifier: "offset by", s.BeyondSpecifier: "beyond",
    }  # fmt: skip
    for specifier in node.specifiers:
        if isinstance(specifier, s.DirectionOfSpecifier):
            direction = {s.LeftOf: "left of", s.RightOf: "right of", s.AheadOf: "ahead of", s.Behind: "behind"}
            return f"{direction[type(specifier.direction)]} {_text(specifier.position)}"
        if type(specifier) in words:
            values = [getattr(specifier, f) for f in ("base", "position", "region", "field") if hasattr(specifier, f)]
            texts = [_text(v) for v in values if v is not None]
            return f"{words[type(specifier)]} {texts[-1]}" if texts else ""
    return ""


def _text(node: Any) -> str:
    """A short expression in words: its source, or the name that it starts from."""
    parts = list(ast.walk(node))
    if any(type(part).__module__.startswith("scenic") for part in parts):
        name = next((part.id for part in parts if isinstance(part, ast.Name)), "")
        return f"a place near {name}" if name else "a place"
    try:
        text = ast.unparse(node)
    except (AttributeError, ValueError, RecursionError):
        return "a place"
    return text if len(text) <= 40 and "\n" not in text and "<" not in text else "a place"


def _sentence(parts: list[str], otherwise: str) -> str:
    said = "; ".join(p for p in parts if p) or otherwise
    return f"{said[0].upper()}{said[1:]}." if said else ""
