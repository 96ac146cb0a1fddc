"""Traps that raise nothing where they stand: identity with what is drawn only later, names lost within a behaviour."""

import ast
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from c2s_engine.check import catalogue
from c2s_engine.structure.diagnostics import Diagnostic

_DRAWS = {"Uniform", "Discrete", "Options", "Range", "DiscreteRange", "Normal", "TruncatedNormal"}
_INNER = (ast.Lambda, ast.ListComp, ast.SetComp, ast.GeneratorExp, ast.DictComp)


@dataclass(frozen=True)
class Silent:
    """Of one statement: `drawn`, the names that it gives a random value; `made`, a name and the one that it comes from;
    `same`, the names that a condition on others compares by identity (line, column, whether it asks for another)."""

    drawn: frozenset[str] = frozenset()
    made: tuple[tuple[str, str], ...] = ()
    same: tuple[tuple[str, int, int, bool], ...] = ()


def gather(tree: Any) -> Silent:
    """What of a statement at the top matters here; within behaviours, requirements and what a monitor is given values
    are drawn already."""
    from scenic.syntax import ast as s

    later = s.BehaviorDef | s.MonitorDef | s.Require | s.RequireMonitor | s.TerminateWhen | ast.FunctionDef
    if any(isinstance(n, later) for n in ast.walk(tree)):
        return Silent()
    drawn, made = set(), []
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
            name, value = node.targets[0].id, node.value
            if isinstance(value, ast.Call) and isinstance(value.func, ast.Name) and value.func.id in _DRAWS:
                drawn.add(name)
            elif root := _root(value):
                made.append((name, root))
    inner = [n for outer in ast.walk(tree) if isinstance(outer, _INNER) for n in ast.walk(outer)]
    same = {found for n in inner if isinstance(n, ast.Compare) for found in _identity(n)}
    return Silent(frozenset(drawn), tuple(made), tuple(sorted(same)))


def _identity(node: ast.Compare) -> Iterator[tuple[str, int, int, bool]]:
    for operator, one, other in zip(node.ops, [node.left, *node.comparators], node.comparators, strict=False):
        if isinstance(operator, ast.Is | ast.IsNot):
            for side in (one, other):
                if root := _root(side):
                    yield root, node.lineno, node.col_offset + 1, isinstance(operator, ast.IsNot)


def _root(node: ast.AST) -> str:
    """The name that a chain of attributes and members begins with."""
    while isinstance(node, ast.Attribute | ast.Subscript):
        node = node.value
    return node.id if isinstance(node, ast.Name) else ""


def identities(facts: Iterable[Silent]) -> list[Diagnostic]:
    """Conditions that compare by identity with a value that is drawn only later, in the order of the program."""
    drawn: set[str] = set()
    found = []
    for fact in facts:
        for name, line, column, other in fact.same:
            if name in drawn:
                always = "true" if other else "false"
                found.append(catalogue.finding("identity_of_random", line, column, name=name, always=always))
        drawn |= fact.drawn | {name for name, root in fact.made if root in drawn}
    return found


def lost_names(node: Any) -> list[Diagnostic]:
    """In a behaviour or monitor: parameters of a lambda that are also its local variables, so that Scenic looks for
    them there."""
    local = {n.id for n in ast.walk(node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
    inner = [n for n in ast.walk(node) if isinstance(n, _INNER[1:])]
    local -= {n.id for c in inner for g in c.generators for n in ast.walk(g.target) if isinstance(n, ast.Name)}
    return [
        catalogue.finding("lambda_of_local", n.lineno, n.col_offset + 1, name=a.arg)
        for n in ast.walk(node) if isinstance(n, ast.Lambda) for a in n.args.args if a.arg in local
    ]  # fmt: skip
