"""The names that a statement binds, changes and reads at the program's top level, as far as scopes let them out."""

import ast
from dataclasses import dataclass, field
from typing import Any

MUTATORS = frozenset({"append", "extend", "insert", "add", "update", "remove", "pop", "clear", "sort", "setdefault"})
_COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)


@dataclass
class Names:
    """What a statement does to names: `loops` are those of `bound` that only its loops run through."""

    bound: set[str] = field(default_factory=set)
    changed: set[str] = field(default_factory=set)
    read: set[str] = field(default_factory=set)
    loops: set[str] = field(default_factory=set)


def names(tree: Any) -> Names:
    """The names of a module of one top-level statement (or of several)."""
    found = Names()
    for node in tree.body:
        _visit(node, frozenset(), found)
    found.loops -= {n.id for node in tree.body for n in _assigned(node)}
    return found


def _visit(node: Any, local: frozenset[str], found: Names) -> None:
    from scenic.syntax import ast as s

    if isinstance(node, _COMPREHENSIONS):
        inner = local | {n.id for g in node.generators for n in ast.walk(g.target) if isinstance(n, ast.Name)}
        _children(node, inner, found)
    elif isinstance(node, ast.Lambda):
        _children(node, local | _arguments(node.args), found)
    elif isinstance(node, s.BehaviorDef | s.MonitorDef | s.ScenarioDef | ast.FunctionDef | ast.ClassDef):
        found.bound.add(node.name)
        _children(node, local | _locals(node), found)
    elif isinstance(node, ast.Import | ast.ImportFrom):
        found.bound |= {(a.asname or a.name).split(".")[0] for a in node.names} - {"*"}
    elif isinstance(node, ast.Name):
        if isinstance(node.ctx, ast.Load):
            found.read |= {node.id} - local
        else:
            found.bound |= {node.id} - local
    else:
        if isinstance(node, s.New):
            found.read.add(node.className)
        elif isinstance(node, ast.For):
            found.loops |= {n.id for n in ast.walk(node.target) if isinstance(n, ast.Name)} - local
        elif isinstance(node, ast.AugAssign) and isinstance(node.target, ast.Name):
            found.read |= {node.target.id} - local
        found.changed |= _changed(node) - local
        _children(node, local, found)


def _children(node: Any, local: frozenset[str], found: Names) -> None:
    for child in ast.iter_child_nodes(node):
        _visit(child, local, found)


def _changed(node: Any) -> set[str]:
    """The name whose value a call or an assignment to a part of it changes."""
    target: Any = None
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in MUTATORS:
        target = node.func.value
    elif isinstance(node, ast.Attribute | ast.Subscript) and isinstance(node.ctx, ast.Store):
        target = node.value
    while isinstance(target, ast.Attribute | ast.Subscript):
        target = target.value
    return {target.id} if isinstance(target, ast.Name) else set()


def _arguments(node: Any) -> set[str]:
    extra = [a for a in (node.vararg, node.kwarg) if a is not None]
    return {a.arg for a in (*node.posonlyargs, *node.args, *node.kwonlyargs, *extra)}


def _locals(node: Any) -> set[str]:
    """The names that a definition keeps to itself: its arguments and what it assigns."""
    held = {n.id for n in ast.walk(node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
    if isinstance(node, ast.ClassDef):
        return held
    outside = {name for n in ast.walk(node) if isinstance(n, ast.Global) for name in n.names}
    return (held | _arguments(node.args) | {"self"}) - outside


def _assigned(node: Any) -> list[ast.Name]:
    """The names assigned in a node, other than by its loops' heads."""
    heads = {id(n) for f in ast.walk(node) if isinstance(f, ast.For) for n in ast.walk(f.target)}
    stored = [n for n in ast.walk(node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)]
    return [n for n in stored if id(n) not in heads]
