"""What a program's names stand for, as far as that can be told without running it: numbers, ranges, definitions."""

import ast
from collections.abc import Mapping
from typing import Any

from c2s_engine import driving

Number = float | tuple[float, float]
DEPTH = 12  # names that stand for names
_DRAWS = {"Range", "VerifaiRange", "DiscreteRange", "VerifaiDiscreteRange"}
_CHOICES = {"Uniform", "Options", "VerifaiOptions"}


class Values:
    """The top level of a program: the names assigned once, the global parameters, the definitions."""

    def __init__(self, units: list[Any]) -> None:
        from scenic.syntax import ast as s

        self.assigned: dict[str, Any] = {}
        self.params: dict[str, Any] = {}
        self.behaviors: dict[str, Any] = {}
        self.classes: dict[str, str] = {}
        self.library = False  # the driving library is imported
        for unit in units:
            for node in unit.tree.body:
                if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
                    name = node.targets[0].id
                    self.assigned[name] = None if name in self.assigned else node.value
                elif isinstance(node, s.TrackedAssign) and isinstance(node.target, s.Ego):
                    self.assigned["ego"] = node.value
                elif isinstance(node, ast.ImportFrom) and node.module == driving.MODULE:
                    self.library = True
                elif isinstance(node, s.Param):
                    self.params |= {p.identifier: p.value for p in node.elts}
                elif isinstance(node, s.BehaviorDef):
                    self.behaviors[node.name] = node
                elif isinstance(node, ast.ClassDef) and node.bases and isinstance(node.bases[0], ast.Name):
                    self.classes[node.name] = node.bases[0].id

    def literal(self, node: Any) -> Any:
        """A literal's value, also through a name or `localPath`; None where it is computed."""
        for _ in range(DEPTH):
            if isinstance(node, ast.Constant):
                return node.value
            if isinstance(node, ast.Name):
                node = self.assigned.get(node.id)
            elif _called(node) == "localPath" and node.args:
                node = node.args[0]
            else:
                return None
        return None

    def number(self, node: Any, local: Mapping[str, Any] | None = None, depth: int = 0) -> Number | None:
        """The number or range (low, high) of an expression; `local` are the nodes of a behaviour's arguments."""
        local = local or {}
        if depth > DEPTH:
            return None
        if isinstance(node, ast.Constant):
            given = node.value
            return float(given) if isinstance(given, int | float) and not isinstance(given, bool) else None
        if isinstance(node, ast.Name):
            inner = local.get(node.id) if node.id in local else self.assigned.get(node.id)
            return None if inner is None else self.number(inner, {}, depth + 1)
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "globalParameters":
            return self.number(self.params.get(node.attr), {}, depth + 1)
        if isinstance(node, ast.Subscript):
            return self.number(self._element(node), local, depth + 1)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            value = self.number(node.operand, local, depth + 1)
            return None if value is None else _scaled(value, -1.0)
        if isinstance(node, ast.BinOp):
            return _combined(
                node.op, self.number(node.left, local, depth + 1), self.number(node.right, local, depth + 1)
            )
        called = _called(node)
        if called in _DRAWS | _CHOICES and node.args:
            ends = [self.number(a, local, depth + 1) for a in node.args]
            if all(e is not None for e in ends):
                return _number(min(ends_of(e)[0] for e in ends if e is not None),
                               max(ends_of(e)[1] for e in ends if e is not None))  # fmt: skip
        return None

    def _element(self, node: Any) -> Any:
        """The element that a constant index takes of a list, given by name or as it stands."""
        held = self.assigned.get(node.value.id) if isinstance(node.value, ast.Name) else node.value
        index = node.slice.value if isinstance(node.slice, ast.Constant) else None
        if isinstance(held, ast.List | ast.Tuple) and isinstance(index, int) and index < len(held.elts):
            return held.elts[index]
        return None


def ends_of(value: Number) -> tuple[float, float]:
    """The least and the greatest value of a number or range."""
    return value if isinstance(value, tuple) else (value, value)


def said(value: Number) -> str:
    """A number or range in figures."""
    low, high = ends_of(value)
    return f"{low:g}" if low == high else f"{low:g} to {high:g}"


def plus(a: Number, b: Number) -> Number:
    """The sum of two numbers or ranges that are drawn independently."""
    return _number(ends_of(a)[0] + ends_of(b)[0], ends_of(a)[1] + ends_of(b)[1])


def minus(a: Number, b: Number) -> Number:
    """The difference of two numbers or ranges that are drawn independently."""
    return plus(a, _scaled(b, -1.0))


def _called(node: Any) -> str:
    return node.func.id if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""


def _number(low: float, high: float) -> Number:
    return low if low == high else (low, high)


def _scaled(value: Number, factor: float) -> Number:
    low, high = sorted(factor * end for end in ends_of(value))
    return _number(low, high)


def _combined(op: Any, a: Number | None, b: Number | None) -> Number | None:
    if a is None or b is None:
        return None
    if isinstance(op, ast.Add):
        return plus(a, b)
    if isinstance(op, ast.Sub):
        return minus(a, b)
    if isinstance(op, ast.Mult) and not (isinstance(a, tuple) and isinstance(b, tuple)):
        return _scaled(b, a) if not isinstance(a, tuple) else _scaled(a, ends_of(b)[0])
    if isinstance(op, ast.Div) and not isinstance(b, tuple) and b:
        return _scaled(a, 1 / b)
    return None
