"""Any Scenic program as S: each top-level statement, with the comments before it, goes to one component.

Who needs a statement decides where it goes: what only ego needs is E's, what describes places is R's, each object is
an O with the behaviours that only it runs, requirements are T's, and what all share is G's. Nothing is executed.
"""

import ast
import io
from collections import defaultdict
from dataclasses import dataclass, field
from itertools import groupby
from typing import Any

from c2s_engine.check import describe, diagnose, pieces, scopes, upgrade
from c2s_engine.check.describe import table
from c2s_engine.check.protocol import ImportRequest, ImportResult
from c2s_engine.structure.components import Component, Structure

SINGLE = ("G", "R", "E", "T")


@dataclass
class Unit:
    """A top-level statement with the comment lines before it."""

    text: str
    tree: Any
    kind: str = ""  # settings, place, object, ego, restriction, definition, constant, other
    defines: frozenset[str] = frozenset()  # by itself, or by changing what others made
    uses: frozenset[str] = frozenset()
    loops: frozenset[str] = frozenset()  # the names in `defines` that only loops run through
    component: str = ""
    classes: list[str] = field(default_factory=list)


def import_program(request: ImportRequest) -> ImportResult:
    """Decompose a program; where it is of Scenic 2, upgrade it first."""
    text = request.text
    try:
        newer = upgrade.upgraded(text, request.filename)
        found = units(newer, request.filename)
    except upgrade.NotUpgraded as left:
        return ImportResult(diagnostics=(left.diagnostic,))
    except Exception as error:
        program = diagnose.Program(text, request.filename)
        return ImportResult(diagnostics=(diagnose.diagnose(error, "parse", program),))
    assign(found)
    changed = newer if newer != text else None
    return ImportResult(
        structure=build(found), upgraded=changed, diff=upgrade.difference(text, newer, request.filename)
    )


def units(text: str, filename: str) -> list[Unit]:
    """The program cut at its top-level statements; raises what the parser raises. The texts joined are the program."""
    try:
        cuts = pieces.cut(text)
    except pieces.Cut:
        pieces.parse(text, filename)
        raise
    lines = list(io.StringIO(text, newline="\n"))
    found: list[Unit] = []
    begin = 0
    for piece in cuts:
        end = piece.last
        found.append(Unit("".join(lines[begin:end]), pieces.parse(piece.text, filename, piece.first - 1)))
        begin = end
    rest = "".join(lines[begin:])
    if not found:
        return [Unit(text, ast.Module(body=[], type_ignores=[]), kind="settings")]
    found[-1].text += rest
    for unit in found:
        classify(unit)
    return found


def classify(unit: Unit) -> None:
    """What a statement is by itself, what it defines and what it uses."""
    from scenic.syntax import ast as s

    known = table()
    kinds: set[str] = set()
    for node in ast.walk(unit.tree):
        if isinstance(node, s.New):
            unit.classes.append(node.className)
        elif isinstance(node, s.TrackedAssign):
            kinds.add("ego" if isinstance(node.target, s.Ego) else "place")
    for node in unit.tree.body:
        if isinstance(node, s.Model | s.Param | s.Simulator | ast.Import | ast.ImportFrom):
            kinds.add("settings")
        elif isinstance(node, s.BehaviorDef | s.MonitorDef | s.ScenarioDef | ast.FunctionDef | ast.ClassDef):
            kinds.add("definition")
        elif isinstance(node, _restrictions()):
            kinds.add("restriction")
        elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            kinds.add("settings")
    found = scopes.names(unit.tree)
    made = [c for c in unit.classes if c not in known["points"]]
    whole_scenario = any(isinstance(n, s.ScenarioDef) for n in unit.tree.body)
    if "ego" in kinds and (not kinds & {"definition"} or whole_scenario):
        unit.kind = "ego"
        found.bound.add("ego")
    elif made and (not kinds & {"definition"} or whole_scenario):
        unit.kind = "object"
    elif "restriction" in kinds:
        unit.kind = "restriction"
    elif "settings" in kinds:
        unit.kind = "settings"
    elif "definition" in kinds:
        unit.kind = "definition"
    elif "place" in kinds or found.read & set(known["places"]) or unit.classes:
        unit.kind = "place"
    else:
        unit.kind = "constant" if found.bound or found.changed else "other"
    unit.defines = frozenset(found.bound | found.changed)
    unit.uses = frozenset(found.read | found.changed)
    unit.loops = frozenset(found.loops)


def _restrictions() -> tuple[type, ...]:
    from scenic.syntax import ast as s

    return (
        s.Require, s.RequireMonitor, s.Record, s.RecordInitial, s.RecordFinal, s.Mutate,
        s.TerminateWhen, s.TerminateSimulationWhen, s.TerminateAfter,
    )  # fmt: skip


def assign(found: list[Unit]) -> None:
    """Give each statement its component."""
    makers = _makers(found)
    for i, unit in enumerate(found):
        if unit.kind in ("other", "constant") and any(_makes_objects(found[j]) for j in makers[i]):
            unit.kind = "object"
    number = 0
    for unit in found:
        if unit.kind == "ego":
            unit.component = "E"
        elif unit.kind == "object":
            number += 1
            unit.component = f"O{number}"
        elif unit.kind == "restriction":
            unit.component = "T"
        elif unit.kind == "settings":
            unit.component = "G"
        elif unit.kind == "place":
            unit.component = "R"
    spread(found, makers)
    before = "G"
    for i, unit in enumerate(found):
        if not unit.component:
            unit.component = next((found[j].component for j in makers[i] if found[j].component), before)
        before = unit.component


def _makers(found: list[Unit]) -> list[list[int]]:
    """For each statement those that make what it uses: the ones before it, for and among definitions all."""
    by_name: dict[str, list[int]] = defaultdict(list)
    for i, unit in enumerate(found):
        for name in unit.defines:
            by_name[name].append(i)
    return [
        sorted({
            j
            for name in unit.uses
            for j in by_name[name]
            if j != i and (j < i or "definition" in (unit.kind, found[j].kind) or unit.kind == "restriction")
        })
        for i, unit in enumerate(found)
    ]  # fmt: skip


def _makes_objects(unit: Unit) -> bool:
    """Whether a definition is of a function that places objects: calling it makes them."""
    functions = any(isinstance(n, ast.FunctionDef) for n in unit.tree.body)
    return functions and any(c not in table()["points"] for c in unit.classes)


def spread(found: list[Unit], makers: list[list[int]]) -> None:
    """Definitions and constants go where they are needed; places made of random or constant values only, too."""
    users: dict[int, set[int]] = defaultdict(set)
    for i, made in enumerate(makers):
        for j in made:
            users[j].add(i)
    on_map = _on_map(found, makers)
    for _ in found:
        changed = False
        for i in range(len(found) - 1, -1, -1):
            unit = found[i]
            if unit.component or unit.kind not in ("definition", "constant"):
                continue
            owners = {found[j].component for j in users[i]}
            if not owners or "" in owners:
                continue
            shared = "R" if i in on_map and len(owners) > 1 and unit.kind == "constant" else ""
            unit.component = shared or _common(owners, unit.kind)
            changed = True
        if not changed:
            break
    for unit in found:
        if not unit.component and unit.kind == "definition":
            unit.component = "T" if _is_monitor(unit) else "G"


def _on_map(found: list[Unit], makers: list[list[int]]) -> set[int]:
    """The statements whose values rest on places of the road network, directly or through others."""
    resting = {i for i, unit in enumerate(found) if unit.kind == "place"}
    for i, made in enumerate(makers):
        if resting & set(made):
            resting.add(i)
    return resting


def _common(owners: set[str], kind: str) -> str:
    if len(owners) == 1:
        return next(iter(owners))
    if kind == "definition" and "E" in owners:
        return "E"
    movers = sorted((o for o in owners if o.startswith("O")), key=lambda o: int(o[1:]))
    return movers[0] if kind == "definition" and movers else "G"


def _is_monitor(unit: Unit) -> bool:
    from scenic.syntax import ast as s

    return any(isinstance(n, s.MonitorDef) for n in unit.tree.body)


def build(found: list[Unit]) -> Structure:
    """The structure: each component with its code, a spec and a description; and how they are arranged."""
    grouped: dict[str, list[Unit]] = defaultdict(list)
    for unit in found:
        grouped[unit.component].append(unit)
    ids = ["G", "R", "E", *sorted((c for c in grouped if c.startswith("O")), key=lambda c: int(c[1:])), "T"]
    context = describe.Context(found, _makers(found))
    components = {cid: _component(cid, grouped[cid], context) for cid in ids}
    return Structure(
        settings=components["G"],
        place=components["R"],
        ego=components["E"],
        objects=tuple(components[c] for c in ids if c.startswith("O")),
        restrictions=components["T"],
        arrangement=tuple((cid, "".join(u.text for u in run)) for cid, run in groupby(found, lambda u: u.component)),
    )


def _component(cid: str, members: list[Unit], context: "describe.Context") -> Component:
    spec, description, unmet = context.describe(cid, members)
    code = "".join(unit.text for unit in members)
    return Component(id=cid, description=description, spec=spec, code=code, origin="imported", unmet=unmet)
