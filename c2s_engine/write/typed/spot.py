"""A spot as Scenic: what a fragment says of where its object starts, and how it counts members of a row."""

from dataclasses import dataclass

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write.typed import scope, stations
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.usual import row_step


@dataclass(frozen=True)
class Spot:
    """`constants`: lines before the object; `specifiers`: where (`i` counts members); `line`: its way's points."""

    constants: tuple[str, ...]
    specifiers: tuple[str, ...]
    line: str
    lane: int | None = None
    approach: str | None = None
    off_road: bool = False


def position_constant(structure: Structure, cid: str) -> str:
    """The constant that says how far along the lane something starts, m."""
    return "EGO_AT" if cid in ("ego", "E") else f"{scope.constant(structure, cid)}_AT"


def measured(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan, sign: int) -> list[str]:
    """`X_GAP = gap` and `X_AT = OTHER_AT + X_GAP + half lengths`."""
    start, gap, half = stations.from_base(structure, spec, plan, sign)
    op, at = "+" if sign > 0 else "-", position_constant(structure, cid)
    base, halves = position_constant(structure, start), scope.number(half)
    text, name = scope.quantity(gap), f"{at.removesuffix('_AT')}_GAP"
    if text == "0":
        return [f"{at} = {base} {op} {halves}  # m along the lane"]
    along = f"{at} = {base} {op} {name} {op} {halves}  # m along the lane; their bodies take {halves}"
    return [f"{name} = {text}  # m, bumper to bumper", along]


def member(spec: ObjectSpec, base: str, sign: int = 1) -> str:
    """Where the i-th member of a row is, from where the first is."""
    if spec.count == 1:
        return base
    return f"{base} {'+' if sign > 0 else '-'} {scope.number(row_step(spec))} * i"
