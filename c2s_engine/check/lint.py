"""What can be said of a program without running it: undefined names, mistaken units, misused behaviours, no ego."""

import ast
import functools
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib.metadata import PackageNotFoundError, distribution
from typing import Any

from c2s_engine import driving
from c2s_engine.check import catalogue, silent
from c2s_engine.check import world as worlds
from c2s_engine.check.likeness import near as _near
from c2s_engine.structure.diagnostics import Diagnostic

BUILT_IN_PARAMS = frozenset({"map", "map_options", "time_step"})
TABLE_METHODS = frozenset({"get", "items", "keys", "values"})


@dataclass
class PieceFacts:
    """What one top-level statement defines and uses (lines are the program's)."""

    defines: frozenset[str] = frozenset()
    free: tuple[tuple[str, int, int], ...] = ()  # names read here that nothing in the statement binds
    behaviors: dict[str, tuple[tuple[str, ...], bool]] = field(default_factory=dict)
    monitors: tuple[tuple[str, int], ...] = ()
    required: frozenset[str] = frozenset()  # monitors that are required
    params: frozenset[str] = frozenset()
    params_read: tuple[tuple[str, int], ...] = ()
    steps: tuple[tuple[str, str, tuple[str, ...], int], ...] = ()  # (take or do or with, name, keywords, line)
    model: str = ""
    ego: bool = False
    objects: bool = False
    stars: frozenset[str] = frozenset()  # modules of which all names are imported
    found: tuple[Diagnostic, ...] = ()
    quiet: silent.Silent = silent.Silent()


def gather(tree: Any) -> PieceFacts:
    """The facts of one statement's Scenic tree."""
    from scenic.syntax import ast as s

    bound: set[str] = set()
    reads: list[tuple[str, int, int]] = []
    facts = PieceFacts()
    behaviors: dict[str, tuple[tuple[str, ...], bool]] = {}
    monitors, required, params, params_read, steps, found = [], set(), set(), [], [], []
    for node in ast.walk(tree):
        line = getattr(node, "lineno", 0)
        if isinstance(node, ast.Name):
            if isinstance(node.ctx, ast.Load):
                reads.append((node.id, line, node.col_offset + 1))
            else:
                bound.add(node.id)
        elif isinstance(node, ast.arg):
            bound.add(node.arg)
        elif isinstance(node, ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef | s.ScenarioDef):
            bound.add(node.name)
        elif isinstance(node, s.BehaviorDef):
            bound.add(node.name)
            behaviors[node.name] = worlds.signature(node.args)
            found += silent.lost_names(node)
        elif isinstance(node, s.MonitorDef):
            bound.add(node.name)
            monitors.append((node.name, line))
            found += silent.lost_names(node)
        elif isinstance(node, ast.ExceptHandler) and node.name:
            bound.add(node.name)
        elif isinstance(node, ast.Import | ast.ImportFrom):
            bound |= {a.asname or a.name.split(".")[0] for a in node.names}
            if isinstance(node, ast.ImportFrom) and node.names[0].name == "*":
                facts.stars |= {node.module or ""}
        elif isinstance(node, ast.Global | ast.Nonlocal):
            bound |= set(node.names)
        elif isinstance(node, ast.MatchAs | ast.MatchStar) and node.name:
            bound.add(node.name)
        elif isinstance(node, s.Model):
            facts.model = node.name
        elif isinstance(node, s.TrackedAssign):
            facts.ego = facts.ego or isinstance(node.target, s.Ego)
        elif isinstance(node, s.New):
            facts.objects = True
            reads.append((node.className, line, node.col_offset + 1))
        elif isinstance(node, s.Param):
            params |= {p.identifier for p in node.elts}
        elif isinstance(node, s.RequireMonitor):
            required |= {n.id for n in ast.walk(node) if isinstance(n, ast.Name)}
        elif isinstance(node, s.Take | s.Do | s.DoFor | s.DoUntil):
            word = "take" if isinstance(node, s.Take) else "do"
            steps += [(word, *call) for call in map(_call, node.elts) if call]
        elif isinstance(node, s.WithSpecifier):
            if node.prop == "behavior" and (call := _call(node.value)):
                steps.append(("with", *call))
            found += _blueprint(node)
        elif isinstance(node, s.FacingSpecifier):
            found += _degrees(node)
        elif isinstance(node, ast.Attribute):
            if isinstance(node.value, ast.Name) and node.value.id == "globalParameters":
                params_read.append((node.attr, line))
            found += _member(node)
        elif isinstance(node, ast.Compare):
            found += _against_string(node) + _in_list(node)
    facts.defines = frozenset(bound)
    facts.free = tuple(r for r in reads if r[0] not in bound)
    facts.behaviors, facts.monitors, facts.required = behaviors, tuple(monitors), frozenset(required)
    facts.params, facts.params_read = frozenset(params), tuple(params_read)
    facts.steps, facts.found, facts.quiet = tuple(steps), tuple(found), silent.gather(tree)
    return facts


def _call(node: ast.AST) -> tuple[str, tuple[str, ...], int] | None:
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        return node.func.id, tuple(k.arg for k in node.keywords if k.arg), node.lineno
    return None


def _blueprint(node: Any) -> list[Diagnostic]:
    value = node.value
    if node.prop != "blueprint" or not isinstance(value, ast.Constant) or not isinstance(value.value, str):
        return []
    if value.value in worlds.blueprints() or value.value.startswith(("walker.", "controller.", "sensor.")):
        return []
    near = _near(value.value, worlds.blueprints())
    return [catalogue.finding("unknown_blueprint", node.lineno, node.col_offset + 1, name=value.value, near=near)]


def _degrees(node: Any) -> list[Diagnostic]:
    value: Any = node.heading
    if isinstance(value, ast.UnaryOp) and isinstance(value.op, ast.USub):
        value = value.operand
    if isinstance(value, ast.Constant) and isinstance(value.value, int | float) and value.value > 2 * math.pi:
        number = f"{value.value:g}"
        return [catalogue.finding("degrees", value.lineno, value.col_offset + 1, name=number)]
    return []


def _member(node: ast.Attribute) -> list[Diagnostic]:
    members = worlds.enumerations().get(node.value.id) if isinstance(node.value, ast.Name) else None
    if members is None or node.attr in members or node.attr.startswith("guess"):
        return []
    near = next((m for m in members if m.startswith(node.attr) or node.attr.startswith(m)), None) or _near(
        node.attr, members
    )
    whole = f"{node.value.id}.{node.attr}"  # type: ignore[attr-defined]
    fixed = f"{node.value.id}.{near}" if near else ""  # type: ignore[attr-defined]
    return [
        catalogue.finding(
            "enumeration", node.lineno, node.col_offset + 1, name=whole, near=fixed, members=", ".join(sorted(members))
        )
    ]


def _against_string(node: ast.Compare) -> list[Diagnostic]:
    sides = [node.left, *node.comparators]
    text = next((s.value for s in sides if isinstance(s, ast.Constant) and isinstance(s.value, str)), None)
    kind = any(isinstance(s, ast.Attribute) and s.attr == "type" for s in sides)
    if text is None or not kind:
        return []
    member = text.upper().replace(" ", "_").replace("-", "_")
    meant = next((m for m in worlds.enumerations()["ManeuverType"] if m.startswith(member) or member.startswith(m)), "")
    near = f"ManeuverType.{meant}" if meant else ""
    return [catalogue.finding("enum_string", node.lineno, node.col_offset + 1, name=repr(text), near=near)]


def _in_list(node: ast.Compare) -> list[Diagnostic]:
    """`ego in network.roads`: an object (or its position) is no member of a list of elements."""
    of = node.comparators[0]
    if not isinstance(of, ast.Attribute) or not isinstance(of.value, ast.Name) or of.value.id != "network":
        return []
    if of.attr not in _REGIONS or not isinstance(node.ops[0], ast.In | ast.NotIn):
        return []
    thing = node.left.value if isinstance(node.left, ast.Attribute) and node.left.attr == "position" else node.left
    if type(thing).__name__ != "Ego" and thing is node.left and getattr(thing, "id", "") != "ego":
        return []
    near = _REGIONS[of.attr]
    return [catalogue.finding("element_as_region", node.lineno, of.col_offset + 1, name=of.attr, near=near)]


_REGIONS = {
    "roads": "roadRegion", "lanes": "laneRegion", "intersections": "intersectionRegion", "crossings": "crossingRegion",
    "sidewalks": "sidewalkRegion", "shoulders": "shoulderRegion",
}  # fmt: skip
"""The regions of a network that hold all elements of its lists."""


def check(
    facts: list[PieceFacts], where: Any, beside: Mapping[str, worlds.World] | None = None, model: str | None = None
) -> tuple[Diagnostic, ...]:
    """The findings of a whole program; `beside`: the modules beside it; `model`: what takes its world model's place."""
    own = beside or {}
    found = [d for f in facts for d in f.found] + silent.identities(f.quiet for f in facts)
    said = next((f.model for f in facts if f.model), "")
    world = worlds.world(model or said) if said else None
    defined = frozenset().union(*(f.defines for f in facts)) if facts else frozenset()
    if world is not None:
        stars = frozenset().union(*(f.stars for f in facts))
        more = [own.get(name) or worlds.world(name) for name in sorted(stars)]
        for module in more:
            world = world.with_names_of(module) if module else world
        if all(more):
            found += _undefined(facts, defined | world.names)
        found += _misused(facts, world) + _verifai(facts, defined)
        params = frozenset().union(*(f.params for f in facts)) | world.params | BUILT_IN_PARAMS
        for name, line in (p for f in facts for p in f.params_read):
            if name not in params | TABLE_METHODS:
                found.append(catalogue.finding("undeclared_param", line, None, name=name, near=_near(name, params)))
    elif not said and not model and (lost := _of_a_world(facts, defined)):
        found.append(catalogue.finding("world_untold", lost[1], lost[2], name=lost[0]))
    if any(f.objects for f in facts) and not any(f.ego for f in facts) and not own.keys() - {driving.MODULE}:
        found.append(catalogue.finding("no_ego", None, None))
    required = frozenset().union(*(f.required for f in facts)) if facts else frozenset()
    for name, line in (m for f in facts for m in f.monitors):
        if name not in required:
            found.append(catalogue.finding("monitor_unused", line, None, name=name))
    return tuple(where.locate(d) for d in sorted(found, key=lambda d: d.line or 0))


def _of_a_world(facts: list[PieceFacts], defined: frozenset[str]) -> tuple[str, int, int] | None:
    """The first use of a name that only world models have, in a program that takes no other names over."""
    if any(f.stars for f in facts):
        return None
    world = worlds.world("scenic.simulators.carla.model")
    own = (world.names if world else frozenset()) - worlds.language() - defined
    return next((use for f in facts for use in f.free if use[0] in own), None)


def _undefined(facts: list[PieceFacts], known: frozenset[str]) -> list[Diagnostic]:
    found: list[Diagnostic] = []
    params = frozenset().union(*(f.params for f in facts))
    for fact in facts:
        for name, line, column in fact.free:
            if name in known:
                continue
            if name == "wait":
                found.append(catalogue.finding("wait_is_no_behavior", line, column))
            elif name in params:
                found.append(catalogue.finding("bare_param", line, column, name=name))
            else:
                found.append(catalogue.finding("undefined_name", line, column, name=name, near=_near(name, known)))
    return found


@functools.cache
def _has_verifai() -> bool:
    """Whether VerifAI itself is installed: the stand-in draws in its place, but Scenic alone would not compile."""
    try:
        return bool(distribution("verifai"))
    except PackageNotFoundError:
        return False


def _verifai(facts: list[PieceFacts], defined: frozenset[str]) -> list[Diagnostic]:
    """One note, at the first name of VerifAI's that the program draws from, where VerifAI is not there to draw."""
    uses = (use for f in facts for use in f.free)
    first = next((u for u in uses if u[0].startswith("Verifai") and u[0] not in defined), None)
    if first is None or _has_verifai():
        return []
    return [catalogue.finding("verifai", first[1], first[2], name=first[0])]


def _misused(facts: list[PieceFacts], world: worlds.World) -> list[Diagnostic]:
    found: list[Diagnostic] = []
    behaviors = dict(world.behaviors)
    for fact in facts:
        behaviors.update(fact.behaviors)
    for word, name, keywords, line in (s for f in facts for s in f.steps):
        if word == "take" and name in behaviors:
            found.append(catalogue.finding("take_behavior", line, None, name=name))
        elif word in ("do", "with") and name in world.actions and name not in behaviors:
            found.append(catalogue.finding("do_action", line, None, name=name))
        elif name in behaviors and word != "take":
            known, open_ended = behaviors[name]
            unknown = [] if open_ended else [k for k in keywords if k not in known]
            members = ", ".join(known) or "none"
            for keyword in unknown:
                near = _near(keyword, known) or _contains(keyword, known)
                values = {"name": keyword, "near": near, "of": name, "members": members}
                found += [catalogue.finding("wrong_keyword", line, None, **values)]
    return found


def _contains(name: str, names: tuple[str, ...]) -> str:
    holding = [n for n in names if name in n]
    return holding[0] if len(holding) == 1 else ""
