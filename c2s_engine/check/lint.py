"""What can be said of a program without running it."""

import ast
from dataclasses import dataclass
from typing import Any

from c2s_engine.structure.diagnostics import Diagnostic


@dataclass
class PieceFacts:
    """What one top-level statement defines and uses."""

    defines: frozenset[str] = frozenset()


def gather(tree: Any) -> PieceFacts:
    return PieceFacts()


def check(facts: list[PieceFacts], where: Any) -> tuple[Diagnostic, ...]:
    return ()


def preamble(tree: Any) -> tuple[bool, bool, str | None]:
    """Of a statement: may it precede a snapshot (params and constants only), is it `model`, which map does it set."""
    from scenic.syntax import ast as s

    simple, model, path = True, False, None
    for node in tree.body:
        if isinstance(node, s.Model):
            model = True
        elif isinstance(node, s.Param):
            for element in node.elts:
                value = _constant(element.value)
                simple = simple and value is not _UNKNOWN
                if element.identifier == "map" and isinstance(value, str):
                    path = value
        elif not (isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)):
            simple = False
    return simple, model, path


_UNKNOWN = object()


def _constant(node: ast.AST) -> Any:
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "localPath":
        return _constant(node.args[0]) if len(node.args) == 1 and not node.keywords else _UNKNOWN
    try:
        return ast.literal_eval(node)
    except (ValueError, TypeError, SyntaxError, MemoryError, RecursionError):
        return _UNKNOWN
