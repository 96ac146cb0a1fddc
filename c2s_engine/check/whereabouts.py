"""Where the objects of an imported program stand to one another: along a lane and beside it, from a common place.

A place is a chain of steps (`following roadDirection from P for 20`, `right of P by 3`, `at P offset by 3 @ 0`) from a
root that nothing more is known of. Two objects with the same root stand to each other as their steps say.
"""

import ast
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from c2s_engine.check.values import DEPTH, Number, Values, ends_of, minus, plus
from c2s_engine.structure.specs import Placement

SAME_LANE = 1.2  # m to the side


@dataclass(frozen=True)
class Spot:
    """`along` in the direction of travel and `side` to the right, both m from the root, of an object's middle."""

    root: str
    along: Number = 0.0
    side: Number = 0.0

    def moved(self, along: Number = 0.0, side: Number = 0.0) -> "Spot":
        return Spot(self.root, plus(self.along, along), plus(self.side, side))


class Whereabouts:
    """Follows the chains; `types`: the types of S of the objects, by their names; `halves`: sizes by type, m."""

    def __init__(self, values: Values, types: Mapping[str, str], halves: Mapping[str, list[float]]) -> None:
        self.values = values
        self.types = types
        self.halves = halves
        self.stop = ""  # the object whose own place is not followed further

    def of(self, name: str, depth: int = 0) -> Spot:
        """The spot of what a name stands for; a name of which nothing is known is a root."""
        from scenic.syntax import ast as s

        node = None if name == self.stop else self.values.assigned.get(name)
        if depth > DEPTH or node is None:
            return Spot(name)
        if isinstance(node, s.New):
            return self.made(node, name, depth)
        return self._spot(node, depth + 1) or Spot(name)

    def made(self, node: Any, name: str, depth: int = 0) -> Spot:
        """The spot of an object or oriented point that a statement makes under a name."""
        from scenic.syntax import ast as s

        length, width = self._half(name)
        for specifier in node.specifiers:
            found: Spot | None = None
            if isinstance(specifier, s.FollowingSpecifier):
                base = (
                    self._spot(specifier.base, depth + 1) if specifier.base is not None else self.of("ego", depth + 1)
                )
                distance = self.values.number(specifier.distance)
                found = base.moved(along=distance) if base is not None and distance is not None else None
            elif isinstance(specifier, s.DirectionOfSpecifier):
                found = self._beside(specifier, length, width, depth)
            elif isinstance(specifier, s.AtSpecifier):
                found = self._spot(specifier.position, depth + 1)
            elif isinstance(specifier, s.OffsetBySpecifier):
                found = self._offset(self.of("ego", depth + 1), specifier.offset)
            if found is not None:
                return found
        return Spot(name)

    def _beside(self, specifier: Any, length: float, width: float, depth: int) -> Spot | None:
        """`ahead of`, `behind`, `left of`, `right of`: measured from side to side of objects."""
        base = self._spot(specifier.position, depth + 1)
        distance = 0.0 if specifier.distance is None else self.values.number(specifier.distance)
        if base is None or distance is None:
            return None
        far, wide = self._half(specifier.position.id) if isinstance(specifier.position, ast.Name) else (0.0, 0.0)
        kind = type(specifier.direction).__name__
        if kind in ("AheadOf", "Behind"):
            step = plus(distance, length + far)
            return base.moved(along=step if kind == "AheadOf" else minus(0.0, step))
        if kind in ("LeftOf", "RightOf"):
            step = plus(distance, width + wide)
            return base.moved(side=step if kind == "RightOf" else minus(0.0, step))
        return None

    def _spot(self, node: Any, depth: int) -> Spot | None:
        from scenic.syntax import ast as s

        if depth > DEPTH:
            return None
        if isinstance(node, ast.Name):
            return self.of(node.id, depth + 1)
        if isinstance(node, s.RelativeToOp):
            base = self._spot(node.left, depth + 1)
            return self._offset(base, node.right) if base is not None else None
        if isinstance(node, s.OffsetAlongOp):
            base = self._spot(node.base, depth + 1)
            return self._offset(base, node.offset) if base is not None else None
        return None

    def _offset(self, base: Spot, node: Any) -> Spot | None:
        from scenic.syntax import ast as s

        if isinstance(node, ast.Name):
            node = self.values.assigned.get(node.id)
        if isinstance(node, s.VectorOp):
            pair = (node.left, node.right)
        elif isinstance(node, ast.Tuple) and len(node.elts) == 2:
            pair = (node.elts[0], node.elts[1])
        else:
            return None
        side, along = self.values.number(pair[0]), self.values.number(pair[1])
        return None if side is None or along is None else base.moved(along, side)

    def _half(self, name: str) -> tuple[float, float]:
        """Half the length and width of an object of that name; of a point: none."""
        kind = self.types.get(name)
        if kind is None:
            return 0.0, 0.0
        length, width = self.halves.get(kind, self.halves["other"])
        return length, width

    def placement(self, name: str, node: Any, ids: Mapping[str, str]) -> Placement | None:
        """Where the object stands as S says it; None where it shares no root with ego or an object before it."""
        known = [other for other in ids if other != name and other in self.types]
        known.sort(key=lambda other: (other != self._base(node), other != "ego"))
        for other in known:
            here, there = self._from(other, name, node)
            if other != "ego" and (here.root == name or int(ids[other][1:]) > int(ids.get(name, "O99")[1:])):
                continue
            if there.root == here.root:
                of = "ego" if other == "ego" else ids[other]
                return self._placed(name, node, of, minus(here.along, there.along), minus(here.side, there.side), other)
        return None

    def _from(self, other: str, name: str, node: Any) -> tuple[Spot, Spot]:
        """The spots of an object and of another: from the other itself, where the one is placed by it."""
        self.stop = other
        here = self.made(node, name)
        self.stop = ""
        return (here, Spot(other)) if here.root == other else (self.made(node, name), self.of(other))

    def _base(self, node: Any) -> str:
        """What an object is placed by, where that is a name."""
        from scenic.syntax import ast as s

        for specifier in node.specifiers:
            if isinstance(specifier, s.FollowingSpecifier | s.DirectionOfSpecifier | s.AtSpecifier):
                place = specifier.base if isinstance(specifier, s.FollowingSpecifier) else specifier.position
                first = (
                    next((n for n in ast.walk(place) if isinstance(n, ast.Name)), None) if place is not None else None
                )
                return first.id if first is not None else "ego"
        return "ego"

    def _placed(self, name: str, node: Any, of: str, along: Number, side: Number, other: str) -> Placement:
        kind, facing = self.types.get(name, "other"), _facing(node)
        vehicle = kind in ("car", "van", "truck", "bus", "motorcycle", "bicycle")
        apart = self._half(name)[0] + self._half(other)[0]
        low, high = ends_of(along)
        left, right = ends_of(side)
        lengthwise = "ahead" if low > 0 else "behind" if high < 0 else "abreast"
        hand = "right" if left + right > 0 else "left"
        level = along if low >= 0 else None
        if abs(left + right) / 2 <= SAME_LANE:
            gap = _apart(along if low > 0 else minus(0.0, along), apart) if lengthwise != "abreast" else None
            return Placement(position="behind" if lengthwise == "behind" else "ahead", of=of, gap=gap, facing=facing)
        if not vehicle or facing == "across":
            return Placement(position="roadside", of=of, side=hand, gap=level, facing=facing)
        if facing == "against" and hand == "left":
            return Placement(position="oncoming_lane", of=of, gap=_apart(along, apart) if low > 0 else None)
        if lengthwise == "abreast":
            return Placement(position="beside", of=of, side=hand, facing=facing)
        gap = _apart(along if low > 0 else minus(0.0, along), apart)
        position = "left_lane" if hand == "left" else "right_lane"
        return Placement(position=position, of=of, along=lengthwise, gap=gap, facing=facing)


def _apart(distance: Number, apart: float) -> Number:
    low, high = (round(max(0.0, end - apart), 2) for end in ends_of(distance))
    return low if low == high else (low, high)


def _facing(node: Any) -> Any:
    """`facing` or `with heading`, where it is turned by a right angle or round."""
    from scenic.syntax import ast as s

    for specifier in node.specifiers:
        heading = None
        if isinstance(specifier, s.FacingSpecifier):
            heading = specifier.heading
        elif isinstance(specifier, s.WithSpecifier) and specifier.prop == "heading":
            heading = specifier.value
        for part in ast.walk(heading) if heading is not None else ():
            if isinstance(part, s.DegOp):
                try:
                    turn = abs(ast.literal_eval(part.operand)) % 360
                except (ValueError, TypeError):
                    continue
                return {90: "across", 270: "across", 180: "against"}.get(turn)
    return None
