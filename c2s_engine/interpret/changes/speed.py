"""Changes of how fast somebody is: a speed to have, a difference, another's, or a pace."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, base_of, from_to, name_of, quantity_of, value_of, without_unit
from c2s_engine.interpret.changes.refer import refer, spec_of
from c2s_engine.interpret.entities import PERSONS
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import Edit, SetField
from c2s_engine.structure.quantity import high, middle

PACES = frozenset(("brake", "stop", "accelerate", "stationary", "wait"))
"""Actions that change how fast somebody goes."""


def _table() -> dict[str, Any]:
    found: dict[str, Any] = language.table("refine")["pace"]
    return found


def speed_difference(clause: str, structure: Structure) -> Found | None:
    """ "10 km/h slower", "speed up ego by 15 km/h", "20 percent faster", "as fast as ego": no act of driving."""
    table = _table()
    told = re.search(table["meanwhile"], clause)
    if told or not (re.search(table["by_so_much"], clause) or _like(clause)):
        return None
    return speed(clause, structure)


def speed(clause: str, structure: Structure) -> Found | None:
    """ "Ego at 50 km/h", "the lead drives 20 km/h", "faster", "10 km/h slower", "twice as fast"."""
    table = _table()
    if re.search(table["denied"], clause) and quantity_of(clause, "speed") is None:
        return None
    if re.search(table["between_two"], clause):
        return None
    if re.search(r"\blimit\b", clause) or re.search(table["of_distance"], clause) and "speed" not in clause:
        return None
    quantity = quantity_of(clause, "speed") or without_unit(clause, table["bare"], 1 / 3.6)
    change = _factor(clause)
    other = _like(clause)
    base = refer(other["other"], structure, alone=False) if other else None
    said = clause[: other.start()] if base is not None and other is not None else clause
    if quantity is not None and not re.search(table["by_so_much"], clause):
        change = None  # a speed to have, not one more or less
    who = speed_owners(said, structure)
    if not who or quantity is None and change is None and base is None:
        return None
    each = [_at_speed(c, quantity, change, base) for c in who]
    edits: list[Edit] = [edit for edit, _ in each]
    return [
        *edits,
        *(_set_off(c) for c, edit in zip(who, edits, strict=True) if _stands(c)),
    ], "; ".join(words for _, words in each)


def _stands(component: Component) -> bool:
    """Whether somebody only stands."""
    phases = getattr(component.spec, "phases", ())
    return bool(phases) and all(p.action == "stationary" and p.trigger is None for p in phases)


def _set_off(component: Component) -> Edit:
    """He who only stood stands no longer."""
    return SetField(component=component.id, path="phases", value=())


def _like(clause: str) -> re.Match[str] | None:
    return next((m for pattern in _table()["like"] if (m := re.search(pattern, clause))), None)


def _factor(clause: str) -> float | None:
    """By what the speed now is multiplied; below 1: it becomes less. None where no change is said."""
    table = _table()
    for pattern, factor in table["factors"]:
        if re.search(pattern, clause):
            return float(factor)
    less, more = re.search(table["less"], clause), re.search(table["more"], clause)
    if not less and not more or not re.search(table["of_speed"], clause):
        return None
    share = None
    if percent := re.search(r"(\d+(?:\.\d+)?) ?(?:%|per ?cent)", clause):
        share = float(percent[1]) / 100
    else:
        shares = (*table["parts"], *table["shares"])
        share = next((s for pattern, s in shares if re.search(pattern, clause)), 0.25 if less else 0.3)
    return 1 - share if less else 1 + share


def speed_owners(clause: str, structure: Structure) -> list[Component]:
    """Whose speed it is."""
    table = {**language.table("refine"), **_table()}
    if re.search(table["all"], clause):
        others = [c for c in _moving(structure) if spec_of(c).type not in PERSONS]
        out = re.search(table["but_for"], clause)
        spared = refer(out["whom"], structure, alone=False) if out else None
        meant = others if re.search(r"\b(?:else|others)\b", clause) else [structure.ego, *others]
        return [c for c in meant if spared is None or c.id != spared.id]
    vehicles = [c for c in structure.objects if spec_of(c).type not in PERSONS and spec_of(c).speed]
    joint = re.match(table["joint"], clause)
    both = [refer(joint[name], structure, alone=False) for name in ("one", "other")] if joint else []
    found = [c for c in both if c is not None]
    if len(found) == 2:
        return found
    if re.search(r"\bboth\b", clause) and vehicles:
        return [structure.ego, vehicles[0]] if len(vehicles) == 1 else vehicles if len(vehicles) == 2 else []
    one = refer(clause, structure, alone=True)
    nobody = structure.objects and re.search(table["nobody"], clause)
    unclear = nobody
    if one is None and not unclear:
        one = structure.ego
    return [one] if one is not None else []


def _moving(structure: Structure) -> list[Component]:
    return [c for c in structure.objects if (now := spec_of(c).speed) is not None and high(now) > 0.1]


def _at_speed(
    component: Component, quantity: dict[str, Any] | None, change: float | None, base: Component | None
) -> tuple[Edit, str]:
    """One component at a speed, or changed from its own or another's (`base`)."""
    value: Any
    if quantity is not None and change is None:
        value = value_of(quantity)
        words = f" at {middle(value) * 3.6:.0f} km/h"
    else:
        now = base_of(component if base is None else base, "speed", 10.0)
        times = change or 1.0
        more = now[0] * times if quantity is None else now[0] + quantity["low"] * (-1 if times < 1 else 1)
        value = round(max(0.5, more), 2)
        words = f": {from_to('speed', now, value, 'km/h', 3.6)}" if base is None else f" at {value * 3.6:.0f} km/h"
    edit = SetField(component=component.id, path="speed", value=value)
    return edit, f"{name_of(component)}{words}"


def walked(clause: str, structure: Structure) -> Found | None:
    """ "The boy runs", "let the car roll at walking pace"."""
    component = refer(clause, structure, alone=False)
    if component is None or re.search(_table()["no_pace"], clause):
        return None
    walks = component.id != "E" and spec_of(component).type in PERSONS
    for pattern, value, anybody in _table()["paces"]:
        if re.search(pattern, clause) and (walks or anybody):
            edit = SetField(component=component.id, path="speed", value=float(value))
            return [edit], f"{name_of(component)} at {value * 3.6:.0f} km/h"
    return None


def kept(clause: str, structure: Structure) -> Found | None:
    """ "The van keeps on going": whatever would change its speed is left out."""
    match = re.match(r"(?P<who>.+) keeps on going$", clause)
    component = refer(match["who"], structure, alone=False) if match else None
    if component is None or component.id == "E":
        return None
    phases = tuple(p for p in spec_of(component).phases if p.action not in PACES)
    if phases == spec_of(component).phases:
        return None
    return [SetField(component=component.id, path="phases", value=phases)], f"{name_of(component)} goes on as it does"
