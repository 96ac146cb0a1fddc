"""An allow-list over the Scenic syntax tree: what a program may name, import and reach. Nothing is executed here.

A lint, not a sandbox: the process that runs the program is confined as well (confine.py). Only what the user wrote is
looked at; the installed Scenic's library is trusted.
"""

import ast
import builtins
import functools
import importlib
import types
from collections.abc import Mapping
from importlib.resources import files
from typing import Any

import yaml

from c2s_engine import driving
from c2s_engine.check import world
from c2s_engine.structure.diagnostics import Diagnostic

FIX = "leave it out; if this is your own file and you trust it, check it with `c2s check FILE --trust`"
_BUILTIN = frozenset(dir(builtins))
LONGEST = 4000  # digits or characters of one literal


@functools.cache
def rules() -> dict[str, Any]:
    """The lists of safety.yaml, as sets."""
    data = yaml.safe_load(files("c2s_engine.check").joinpath("safety.yaml").read_text(encoding="utf-8"))
    sets = {k: frozenset(map(str, v)) for k, v in data.items() if k != "imports"}
    return {**sets, **{f"import_{k}": frozenset(v) for k, v in data["imports"].items()}}


def examine(tree: Any) -> list[Diagnostic]:
    """What a statement's Scenic tree names beyond the allow-list."""
    from scenic.syntax import ast as s

    found: list[Diagnostic] = []
    modules: set[str] = set()

    def refuse(node: ast.AST, what: str, code: str = "unsafe") -> None:
        line, column = getattr(node, "lineno", None), getattr(node, "col_offset", None)
        found.append(
            Diagnostic(
                stage="safety", code=code, message=f"not allowed in a scenario: {what}", fix=FIX, line=line,
                column=None if column is None else column + 1,
            )
        )  # fmt: skip

    plain = {id(base) for node in ast.walk(tree) if isinstance(node, ast.ClassDef) for base in node.bases}
    for node in ast.walk(tree):
        if isinstance(node, ast.Name):
            if id(node) in plain and node.id == "object":
                continue  # `class Name(object)`: a class of Python's, where Scenic would make one of objects
            if reason := bad_name(node.id):
                refuse(node, reason)
        elif isinstance(node, ast.Attribute):
            inherited = node.attr == "__init__" and isinstance(node.value, ast.Call) and not node.value.args
            if (reason := bad_attribute(node.attr)) and not inherited:
                refuse(node, reason)
            elif node.attr in leaks() or node.attr in rules()["machinery"]:
                refuse(node, f"{node.attr} of a module beside the program", "passed on")
        elif isinstance(node, ast.Import):
            for alias in node.names:
                if alias.name in rules()["import_whole"]:
                    modules.add(alias.asname or alias.name)
                else:
                    refuse(node, f"import {alias.name}", f"import {alias.name} *")
        elif isinstance(node, ast.ImportFrom):
            for alias in node.names:
                if node.level or not importable(node.module or "", alias.name):
                    refuse(node, f"from {node.module} import {alias.name}", f"import {node.module} {alias.name}")
        elif isinstance(node, s.Model):
            if node.name not in rules()["import_models"]:
                refuse(node, f"the world model {node.name}", f"model {node.name} *")
        elif isinstance(node, s.Simulator):
            refuse(node, "a simulator of its own")
        elif isinstance(node, s.New):
            if reason := bad_name(node.className):
                refuse(node, reason)
        elif isinstance(node, s.WithSpecifier):
            if reason := bad_attribute(node.prop):
                refuse(node, reason)
        elif isinstance(node, s.PropertyDef):
            if reason := bad_attribute(node.property):
                refuse(node, reason)
        elif isinstance(node, ast.FunctionDef | ast.ClassDef | s.BehaviorDef | s.MonitorDef | s.ScenarioDef):
            if node.name.startswith("__") and node.name not in rules()["methods"]:
                refuse(node, f"to define {node.name}")
            if isinstance(node, ast.ClassDef) and any(k.arg == "metaclass" for k in node.keywords):
                refuse(node, "a metaclass")
        elif isinstance(node, ast.arg):
            if node.arg.startswith("__"):
                refuse(node, f"the name {node.arg}")
        elif isinstance(node, ast.MatchClass):
            for attribute in node.kwd_attrs:
                if reason := bad_attribute(attribute):
                    refuse(node, reason)
        elif isinstance(node, ast.Constant):
            if isinstance(node.value, str | bytes) and len(node.value) > 50 * LONGEST:
                refuse(node, "so long a literal")
            if isinstance(node.value, int) and node.value.bit_length() > LONGEST:
                refuse(node, "so large a number")
        elif isinstance(node, ast.AsyncFunctionDef | ast.Await | ast.AsyncFor | ast.AsyncWith):
            refuse(node, "async code")
    return found


def bad_name(name: str) -> str:
    """Why a program may not read or bind a name; empty where it may."""
    if name.startswith(("__", "_Scenic")):
        return f"the name {name}"
    if name in _BUILTIN and name not in rules()["builtins"]:
        return f"Python's {name}"
    if name in rules()["machinery"]:
        return f"Scenic's internal {name}"
    if name in leaks():
        return f"{name}, which the world model only uses itself"
    return ""


def bad_attribute(name: str) -> str:
    """Why a program may not read an attribute; empty where it may."""
    if name.startswith("_") and name not in rules()["private"]:
        return f"the private attribute {name}"
    if name in rules()["attributes"]:
        return f"the attribute {name}"
    return ""


def importable(module: str, name: str) -> bool:
    """Whether a program may import a name from a module: only what the module itself defines."""
    if name == "*":
        return module in rules()["import_star"]
    if name.startswith("_"):
        return False
    if module in rules()["import_plain"]:
        return not isinstance(_value(module, name), types.ModuleType)
    if not any(module == m or module.startswith(m + ".") for m in rules()["import_scenic"]):
        return False
    if world.source_of(module) is not None:
        known = world.world(module)
        return known is not None and name in known.names and not bad_name(name)
    return _own(_value(module, name))


def _value(module: str, name: str) -> Any:
    try:
        return getattr(importlib.import_module(module), name, None)
    except ImportError:
        return None


def _own(value: Any) -> bool:
    """Whether a value belongs to Scenic: no module, and nothing callable that another package defines."""
    if value is None or isinstance(value, types.ModuleType):
        return False
    home = getattr(value, "__module__", None)
    return not callable(value) or (isinstance(home, str) and home.startswith("scenic."))


@functools.cache
def leaks() -> frozenset[str]:
    """Names that a world model passes on without meaning to: modules, and other packages' functions."""
    found = (world.leaks(name) for name in rules()["import_star"] if name.startswith("scenic."))
    return frozenset().union(*found) | (driving.modules() - set(rules()["import_whole"]))


def allowed(diagnostic: Diagnostic, pairs: set[tuple[str, str]]) -> bool:
    """Whether the user's setting allows what a diagnostic refuses: an import of (module, name or *)."""
    word, _, rest = diagnostic.code.partition(" ")
    module, _, name = rest.rpartition(" ")
    return word in ("import", "model") and ((module, name) in pairs or (module, "*") in pairs)


def beside(diagnostic: Diagnostic, modules: Mapping[str, frozenset[str]]) -> bool:
    """Whether what a diagnostic refuses is fine after all: an import of what a module beside the program defines, and,
    where there are no such modules, attributes under which they would pass on what they import themselves."""
    word, _, rest = diagnostic.code.partition(" ")
    module, _, name = rest.rpartition(" ")
    if diagnostic.code == "passed on":
        return not modules
    if word != "import" or module not in modules:
        return False
    return name == "*" or name in modules[module] or f"{module}.{name}" in modules
