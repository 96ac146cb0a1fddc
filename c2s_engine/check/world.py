"""The names that a world model gives to a program, read from the installed Scenic without running the model."""

import ast
import builtins
import contextlib
import functools
import hashlib
import importlib
import importlib.util
import inspect
import pickle
import sys
import types
from dataclasses import dataclass, field
from importlib.metadata import version
from pathlib import Path
from typing import Any

from c2s_engine import driving, paths
from c2s_engine.check import caching, library


@dataclass
class Module:
    """What a Scenic module defines, and what it takes over from others."""

    names: frozenset[str] = frozenset()
    stars: tuple[str, ...] = ()
    behaviors: dict[str, tuple[tuple[str, ...], bool]] = field(default_factory=dict)
    imports: tuple[tuple[str, str, str], ...] = ()  # (module, name or nothing for the module itself, name here)


@dataclass(frozen=True)
class World:
    """What a model gives: names, behaviours with their parameters (and whether they take any), actions, params."""

    names: frozenset[str]
    behaviors: dict[str, tuple[tuple[str, ...], bool]]
    actions: frozenset[str]
    params: frozenset[str]

    def with_names_of(self, other: "World") -> "World":
        """This world, and what a module imported into it gives."""
        return World(
            self.names | other.names, {**self.behaviors, **other.behaviors}, self.actions | other.actions,
            self.params | other.params,
        )  # fmt: skip


@functools.cache
def world(model: str) -> World | None:
    """The world of a model module; None where it is not an installed Scenic module."""
    path = source_of(model)
    return None if path is None else world_of(_module(path))


def world_of(module: Module) -> World:
    """The world that a module gives, with all that it takes over from others."""
    names, behaviors = set(module.names), dict(module.behaviors)
    todo, seen = list(module.stars), set()
    while todo:
        name = todo.pop()
        if name in seen:
            continue
        seen.add(name)
        path = source_of(name)
        if path is None:
            names |= _python_names(name)
            continue
        module = _module(path)
        names |= module.names
        behaviors.update(module.behaviors)
        todo.extend(module.stars)
    plain = {n for n in names if not n.startswith("param ")}
    return World(
        names=frozenset(plain) | language(),
        behaviors=behaviors,
        actions=frozenset(n for n in plain if n.endswith("Action")),
        params=frozenset(n[6:] for n in names if n.startswith("param ")),
    )


@functools.cache
def language() -> frozenset[str]:
    """The names that every program has: Scenic's own and Python's."""
    from scenic.syntax import veneer

    return frozenset(veneer.__all__) | frozenset(dir(builtins)) | {"self", "__name__", "__file__"}


def source_of(name: str) -> Path | None:
    """The .scenic file of a library module, without importing it."""
    if name == driving.MODULE:
        return driving.path()
    parent, _, last = name.rpartition(".")
    if not parent.startswith("scenic"):
        return None
    try:
        package = importlib.util.find_spec(parent)
    except (ImportError, ValueError):
        return None
    for folder in (package.submodule_search_locations or []) if package else []:
        path = Path(folder) / f"{last}.scenic"
        if path.is_file():
            return path
    return None


def _python_names(name: str) -> set[str]:
    try:
        module = importlib.import_module(name)
    except ImportError:
        return set()
    exported = getattr(module, "__all__", None)
    return set(exported) if exported is not None else {n for n in vars(module) if not n.startswith("_")}


def _module(path: Path) -> Module:
    source = path.read_bytes()
    cached = _cache(source)
    found = _read(cached) or (library.wait() and _read(cached))
    if found:
        return found
    from c2s_engine.check import pieces

    return keep(source, pieces.parse(source.decode(), str(path)))


def keep(source: bytes, tree: Any) -> Module:
    """Read a module's syntax tree, and keep what was read in the cache."""
    module = read_module(tree)
    caching.write(_cache(source), pickle.dumps(module))
    return module


def _cache(source: bytes) -> Path:
    tag = source + version("scenic").encode() + sys.version.encode() + b"world 2"
    return paths.cache_folder() / "modules" / f"{hashlib.blake2b(tag, digest_size=16).hexdigest()}.world"


def _read(cached: Path) -> Module | None:
    try:
        return pickle.loads(cached.read_bytes())
    except (OSError, pickle.UnpicklingError, EOFError, AttributeError, ImportError):
        return None


def read_module(tree: Any) -> Module:
    """What a Scenic syntax tree defines at its top level (and in its branches)."""
    from scenic.syntax import ast as s

    names: set[str] = set()
    stars: list[str] = []
    imports: list[tuple[str, str, str]] = []
    behaviors: dict[str, tuple[tuple[str, ...], bool]] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            if node.names[0].name == "*":
                stars.append(node.module or "")
            else:
                names |= {a.asname or a.name for a in node.names}
                imports += [(node.module or "", a.name, a.asname or a.name) for a in node.names]
        elif isinstance(node, ast.Import):
            names |= {a.asname or a.name.split(".")[0] for a in node.names}
            imports += [(a.name, "", a.asname or a.name.split(".")[0]) for a in node.names]
        elif isinstance(node, s.BehaviorDef):
            names.add(node.name)
            behaviors[node.name] = signature(node.args)
        elif isinstance(node, ast.ClassDef | ast.FunctionDef | s.MonitorDef | s.ScenarioDef):
            names.add(node.name)
        elif isinstance(node, s.Model):
            stars.append(node.name)
        elif isinstance(node, s.Param):
            names |= {f"param {p.identifier}" for p in node.elts}
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            names.add(node.id)
    return Module(frozenset(names), tuple(stars), behaviors, tuple(imports))


def signature(arguments: ast.arguments) -> tuple[tuple[str, ...], bool]:
    """The parameters of a behaviour, and whether it takes any keyword."""
    named = [a.arg for a in (*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs)]
    return tuple(named), arguments.kwarg is not None


@functools.cache
def blueprints() -> frozenset[str]:
    """The CARLA blueprints that the installed Scenic knows."""
    from scenic.simulators.carla import blueprints as b

    return (
        frozenset(v for values in b.ids.values() for v in values)
        | frozenset(b.oldBlueprintNames)
        | _legacy(b.oldBlueprintNames)
    )


def _legacy(renamed: dict[str, tuple[str, ...]]) -> frozenset[str]:
    return frozenset(old for names in renamed.values() for old in names)


@functools.cache
def enumerations() -> dict[str, frozenset[str]]:
    """The members of the enumerations that programs name."""
    from scenic.domains.driving import roads

    found: dict[str, Any] = dict(inspect.getmembers(roads, inspect.isclass))
    return {name: frozenset(m.name for m in found[name]) for name in ("ManeuverType", "VehicleType") if name in found}


_HARMLESS = frozenset({"math", "random", "time", "numbers", "itertools", "Optional", "Union", "Any", "List", "Tuple"})


@functools.cache
def leaks(name: str) -> frozenset[str]:
    """Names of a module that are other modules, or functions and classes from outside Scenic."""
    path = source_of(name)
    if path is None:
        try:
            found = vars(importlib.import_module(name))
        except ImportError:
            return frozenset()
        return frozenset(n for n, v in found.items() if not n.startswith("__") and _foreign(v)) - _HARMLESS
    module = _module(path)
    leaked: set[str] = set()
    for source, original, here in module.imports:
        if not original:
            leaked.add(here)
            continue
        with contextlib.suppress(ImportError):
            if _foreign(getattr(importlib.import_module(source), original, None)):
                leaked.add(here)
    for star in module.stars:
        leaked |= leaks(star)
    return frozenset(leaked) - _HARMLESS


def _foreign(value: Any) -> bool:
    if isinstance(value, types.ModuleType):
        return True
    home = getattr(value, "__module__", None)
    return callable(value) and isinstance(home, str) and not home.startswith(("scenic.", "builtins", "typing"))
