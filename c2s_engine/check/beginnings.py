"""What of a statement matters if it stands before a program's `model` or is it, so that snapshots can be shared."""

import ast
from dataclasses import dataclass
from typing import Any

from c2s_engine import driving

_UNKNOWN = object()


@dataclass(frozen=True)
class Beginning:
    """What matters of a statement if it stands before `model` or is it."""

    simple: bool  # it may precede a snapshot: constant params, or a sentence
    model: bool
    library: bool = False  # it imports the driving library: a snapshot after `model` may have done that too
    params: tuple[tuple[str, str], ...] = ()  # names and values, the latter as dumps of their trees
    map: str | None = None  # the map that it sets


def beginning(tree: Any) -> Beginning:
    """The beginning that a statement is part of, or would be."""
    from scenic.syntax import ast as s

    node = tree.body[0] if len(tree.body) == 1 else None
    if isinstance(node, s.Model):
        return Beginning(True, True)
    if isinstance(node, ast.ImportFrom) and node.module == driving.MODULE:
        return Beginning(False, False, library=True)
    if not isinstance(node, s.Param):
        return Beginning(
            isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant),
            any(isinstance(n, s.Model) for n in tree.body),
        )
    values = {element.identifier: _constant(element.value) for element in node.elts}
    return Beginning(
        simple=_UNKNOWN not in values.values(),
        model=False,
        params=tuple((element.identifier, ast.dump(element.value)) for element in node.elts),
        map=next((v for k, v in values.items() if k == "map" and isinstance(v, str)), None),
    )


def _constant(node: ast.AST) -> Any:
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "localPath":
        return _constant(node.args[0]) if len(node.args) == 1 and not node.keywords else _UNKNOWN
    try:
        return ast.literal_eval(node)
    except (ValueError, TypeError, SyntaxError, MemoryError, RecursionError):
        return _UNKNOWN
