"""An allow-list over the Scenic syntax tree: what a program may name, import and reach. Nothing is executed here.

A lint, not a sandbox: the process that runs the program is confined as well (confine.py). Only what the user wrote is
looked at; the installed Scenic's library is trusted.
"""

import ast
import builtins
import functools
import importlib
import types
from collections.abc import Callable, Iterator, Mapping
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
    plain = {id(base) for node in ast.walk(tree) if isinstance(node, ast.ClassDef) for base in node.bases}
    found = []
    for node in ast.walk(tree):
        if id(node) in plain and getattr(node, "id", "") == "object":
            continue  # `class Name(object)`: a class of Python's, where Scenic would make one of objects
        rule = _rule_of(node.__class__.__mro__)
        found += [_refused(node, what, code) for what, code in rule(node) if what] if rule else []
    return found


def _refused(node: ast.AST, what: str, code: str) -> Diagnostic:
    line, column = getattr(node, "lineno", None), getattr(node, "col_offset", None)
    return Diagnostic(
        stage="safety", code=code, message=f"not allowed in a scenario: {what}", fix=FIX, line=line,
        column=None if column is None else column + 1,
    )  # fmt: skip


Refusals = Iterator[tuple[str, str]]
"""What is not allowed (empty: nothing), and its code."""


@functools.cache
def _rule_of(bases: tuple[type, ...]) -> Callable[[Any], Refusals] | None:
    return next((rule for kinds, rule in _rules() if set(kinds) & set(bases)), None)


@functools.cache
def _rules() -> tuple[tuple[tuple[type, ...], Callable[[Any], Refusals]], ...]:
    """What each kind of node is examined for."""
    from scenic.syntax import ast as s

    return (
        ((ast.Name,), lambda node: _unsafe(bad_name(node.id))),
        ((ast.Attribute,), _attribute),
        ((ast.Import,), _import),
        ((ast.ImportFrom,), _import_from),
        ((s.Model,), _model),
        ((s.Simulator,), lambda node: _unsafe("a simulator of its own")),
        ((s.New,), lambda node: _unsafe(bad_name(node.className))),
        ((s.WithSpecifier,), lambda node: _unsafe(bad_attribute(node.prop))),
        ((s.PropertyDef,), lambda node: _unsafe(bad_attribute(node.property))),
        ((ast.FunctionDef, ast.ClassDef, s.BehaviorDef, s.MonitorDef, s.ScenarioDef), _definition),
        ((ast.arg,), lambda node: _unsafe(f"the name {node.arg}" if node.arg.startswith("__") else "")),
        ((ast.MatchClass,), lambda node: _unsafe(*map(bad_attribute, node.kwd_attrs))),
        ((ast.Constant,), _constant),
        ((ast.AsyncFunctionDef, ast.Await, ast.AsyncFor, ast.AsyncWith), lambda node: _unsafe("async code")),
    )


def _unsafe(*whats: str) -> Refusals:
    yield from ((what, "unsafe") for what in whats)


def _attribute(node: ast.Attribute) -> Refusals:
    inherited = node.attr == "__init__" and isinstance(node.value, ast.Call) and not node.value.args
    if (reason := bad_attribute(node.attr)) and not inherited:
        yield reason, "unsafe"
    elif node.attr in leaks() or node.attr in rules()["machinery"]:
        yield f"{node.attr} of a module beside the program", "passed on"


def _import(node: ast.Import) -> Refusals:
    for alias in node.names:
        if alias.name not in rules()["import_whole"]:
            yield f"import {alias.name}", f"import {alias.name} *"


def _import_from(node: ast.ImportFrom) -> Refusals:
    for alias in node.names:
        if node.level or not importable(node.module or "", alias.name):
            yield f"from {node.module} import {alias.name}", f"import {node.module} {alias.name}"


def _model(node: Any) -> Refusals:
    if node.name not in rules()["import_models"]:
        yield f"the world model {node.name}", f"model {node.name} *"


def _definition(node: Any) -> Refusals:
    if node.name.startswith("__") and node.name not in rules()["methods"]:
        yield f"to define {node.name}", "unsafe"
    if isinstance(node, ast.ClassDef) and any(k.arg == "metaclass" for k in node.keywords):
        yield "a metaclass", "unsafe"


def _constant(node: ast.Constant) -> Refusals:
    if isinstance(node.value, str | bytes) and len(node.value) > 50 * LONGEST:
        yield "so long a literal", "unsafe"
    if isinstance(node.value, int) and node.value.bit_length() > LONGEST:
        yield "so large a number", "unsafe"


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
