"""R and T of an imported program as far as S can say them: the kind of intersection, ego's way, distances, endings."""

import ast
from collections.abc import Mapping, Sequence
from typing import Any

from c2s_engine.check.conduct import between_of
from c2s_engine.check.values import Values, ends_of
from c2s_engine.check.whereabouts import Whereabouts
from c2s_engine.maps.expressions import MANOEUVRE_TYPE
from c2s_engine.structure.specs import Condition, PlaceSpec, RestrictionsSpec

_ARMS = {"is3Way": 3, "is4Way": 4}
_WAYS = {kind: way for way, kind in MANOEUVRE_TYPE.items()}
LONGEST = 120.0  # s: what S takes as a run's length


def place(trees: Mapping[int, Any], ancestors: Sequence[int], to_junction: Any) -> PlaceSpec:
    """The place that ego's way rests on: `ancestors` are the statements that ego's object uses, the nearest first.

    `to_junction` is the range of ego's distance to the intersection (m), where the program requires one.
    """
    arms: set[int] = set()
    control = manoeuvre = None
    junction = False
    for i in ancestors:
        for node in ast.walk(trees[i]):
            if not isinstance(node, ast.Attribute):
                continue
            junction |= node.attr == "intersections"
            if node.attr in _ARMS:
                arms.add(_ARMS[node.attr])
            if isinstance(node.value, ast.Name) and node.value.id == "ManeuverType" and manoeuvre is None:
                manoeuvre = _WAYS.get(node.attr)
        control = control or _signals(trees[i])
    if not junction:
        return PlaceSpec()
    found: dict[str, Any] = {"kind": "intersection", "control": control, "manoeuvre": manoeuvre}
    return PlaceSpec(**found, arms=min(arms) if len(arms) == 1 else None, distance=to_junction)


def approach(trees: Mapping[int, Any], ancestors: Sequence[int]) -> tuple[bool, str | None]:
    """Whether an object's way begins on the approach opposite to ego's, and the manoeuvre that its way is."""
    attributes = [n for i in ancestors for n in ast.walk(trees[i]) if isinstance(n, ast.Attribute)]
    found = [_WAYS.get(n.attr) for n in attributes if isinstance(n.value, ast.Name) and n.value.id == "ManeuverType"]
    return any(n.attr == "reverseManeuvers" for n in attributes), found[0] if found else None


def _signals(tree: Any) -> str | None:
    """`signal` where a filter asks for traffic lights; that it asks for none does not tell what there is."""
    denied = {id(n.operand) for n in ast.walk(tree) if isinstance(n, ast.UnaryOp) and isinstance(n.op, ast.Not)}
    asked = [n for n in ast.walk(tree) if isinstance(n, ast.Attribute) and n.attr == "isSignalized"]
    return "signal" if any(id(n) not in denied for n in asked) else None


class Restrictions:
    """Reads T's statements; `ids`: the components of the objects by name; `junctions`: names of intersections."""

    def __init__(self, values: Values, whereabouts: Whereabouts, ids: Mapping[str, str], junctions: set[str]) -> None:
        self.values = values
        self.whereabouts = whereabouts
        self.ids = ids
        self.junctions = junctions
        self.to_junction: Any = None

    def read(self, units: Sequence[Any]) -> tuple[RestrictionsSpec, list[Any]]:
        """The spec, and the statements that it does not hold."""
        from scenic.syntax import ast as s

        require: list[Condition] = []
        ends: list[Condition] = []
        duration: float | None = None
        left: list[Any] = []
        for unit in units:
            for node in unit.tree.body:
                if isinstance(node, s.TerminateAfter):
                    value = self.values.number(getattr(node.duration, "value", None))
                    if isinstance(node.duration, s.Seconds) and isinstance(value, float) and 0 < value <= LONGEST:
                        duration = value
                        continue
                elif isinstance(node, s.Require) and (said := self._distance(node.cond)) is not None:
                    if isinstance(said, Condition):
                        require.append(said)
                    continue
                elif isinstance(node, s.TerminateWhen | s.TerminateSimulationWhen):
                    said = self._distance(node.cond, ending=True)
                    if isinstance(said, Condition):
                        ends.append(said)
                        continue
                elif not isinstance(node, s.Require | s.RequireMonitor | s.Record | s.RecordInitial | s.RecordFinal):
                    continue
                left.append(unit)
        spec = RestrictionsSpec(require=tuple(require), terminate_when=tuple(ends), duration=duration)
        return spec, left

    def _distance(self, cond: Any, ending: bool = False) -> Condition | bool | None:
        """A distance between two objects, or how far ego has come; True: ego's distance to the intersection."""
        limits = self._limits(cond)
        if limits is None:
            return None
        node, low, high = limits
        between = between_of(node)
        if between is None or not isinstance(between[0], ast.Name):
            return None
        base = "ego" if between[1] is None else between[1].id if isinstance(between[1], ast.Name) else ""
        both = sorted((between[0].id, base), key=lambda n: n != "ego")
        pair = [n for n in both if n in self.ids]
        others = [n for n in both if n not in self.ids]
        if len(pair) == 2 and pair[0] != pair[1]:
            first, second = ("ego" if n == "ego" else self.ids[n] for n in pair)
            return Condition(kind="distance", subject=first, other=second, minimum=low, maximum=high)
        if pair == ["ego"] and len(others) == 1:
            if others[0] in self.junctions and low is not None and high is not None and not ending:
                self.to_junction = (low, high)
                return True
            if ending and high is None and self._began_at(others[0]):
                return Condition(kind="travelled", subject="ego", minimum=low)
        return None

    def _began_at(self, name: str) -> bool:
        """Whether ego starts at (within a step of) a place of the program."""
        start, there = self.whereabouts.of("ego"), self.whereabouts.of(name)
        return start.root == there.root and all(abs(e) < 0.5 for e in (*ends_of(start.along), *ends_of(there.along)))

    def _limits(self, cond: Any) -> tuple[Any, float | None, float | None] | None:
        """What is compared, the least and the greatest it may be."""
        if not isinstance(cond, ast.Compare):
            return None
        terms = [cond.left, *cond.comparators]
        numbers = [self.values.number(t) for t in terms]
        measured = [i for i, n in enumerate(numbers) if n is None]
        if len(measured) != 1 or not 2 <= len(terms) <= 3 or (len(terms) == 3 and measured != [1]):
            return None
        low = high = None
        for i, op in enumerate(cond.ops):
            value = numbers[i] if numbers[i] is not None else numbers[i + 1]
            upward = isinstance(op, ast.Lt | ast.LtE)
            if not isinstance(op, ast.Lt | ast.LtE | ast.Gt | ast.GtE) or not isinstance(value, float):
                return None
            if upward == (numbers[i] is None):
                high = value
            else:
                low = value
        return terms[measured[0]], low, high
