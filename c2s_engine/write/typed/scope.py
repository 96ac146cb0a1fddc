"""What a fragment may call things: variables of components, constants, numbers as Scenic text."""

import keyword
import re

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import high, low
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write.typed.tables import RESERVED, WORKS


def number(value: float) -> str:
    """A number as short as two decimals allow."""
    return f"{round(value, 2) + 0.0:.2f}".rstrip("0").rstrip(".") or "0"


def quantity(value: float | tuple[float, float]) -> str:
    """A quantity as Scenic: a number, or Range(low, high)."""
    if isinstance(value, tuple | list) and low(value) != high(value):
        return f"Range({number(low(value))}, {number(high(value))})"
    return number(low(value))


def variables(structure: Structure) -> dict[str, str]:
    """The variable of every object, and of ego: unique, no reserved word; the first of several for a counted object."""
    found = {"ego": "ego", "E": "ego"}
    taken = {"ego"}
    for component in structure.objects:
        spec = component.spec
        base = spec.name if isinstance(spec, ObjectSpec) else component.id.lower()
        base = re.sub(r"\W", "_", base)
        if base in RESERVED or keyword.iskeyword(base) or base.upper() == base:
            base = f"the_{base}".lower()
        name, n = base, 2
        while name in taken:
            name, n = f"{base}_{n}", n + 1
        taken.add(name)
        found[component.id] = name
    return found


def reference(structure: Structure, cid: str) -> str:
    """How to refer to a component's object in code: its variable, or the first of its list."""
    name = variables(structure)[cid]
    if cid in ("ego", "E"):
        return "ego"
    spec = structure[cid].spec
    many = isinstance(spec, ObjectSpec) and (spec.count > 1 or spec.type in WORKS)
    return f"{name}[0]" if many else name


def constant(structure: Structure, cid: str) -> str:
    """The prefix of a component's constants: LEAD for `lead`."""
    return variables(structure)[cid].upper()


def camel(name: str) -> str:
    return "".join(part.capitalize() for part in name.split("_"))
