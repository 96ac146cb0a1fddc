"""Sentences on imported code: where an object stands, which statements there are, what an expression is."""

import ast
import re
from collections.abc import Mapping, Sequence
from typing import Any

from c2s_engine.check.values import said
from c2s_engine.structure import specs

SHOWN = 60  # characters of a statement in a sentence


def runs(behavior: Any) -> str:
    """The name of a behaviour."""
    return text_of(behavior.func if isinstance(behavior, ast.Call) else behavior)


def statement(unit: Any) -> str:
    """The code of a statement in one line, without comments and its keyword."""
    lines = [re.sub(r"(^|\s)#.*$", "", line).strip().rstrip("\\") for line in unit.text.splitlines()]
    text = " ".join(" ".join(line for line in lines if line).split())
    text = re.sub(r"^(require( monitor)?|terminate( simulation)? when)\s+", "", text)
    return text if len(text) <= SHOWN else text[: SHOWN - 3].rstrip() + "..."


def statements(units: Sequence[Any]) -> str:
    shown = [statement(u) for u in units]
    return listed(shown, 3)


def listed(names: Sequence[str], most: int = 8) -> str:
    more = len(names) - most
    return ", ".join(names[:most]) + (f" and {more} more" if more > 0 else "")


def placed(placement: specs.Placement, ids: Mapping[str, str]) -> str:
    """A recognised placement in words."""
    of = next((n for n, c in ids.items() if c == placement.of), placement.of)
    if placement.position == "opposite_approach":
        return "on the approach opposite to ego's"
    gap = f"{said(placement.gap)} m " if placement.gap else ""
    if placement.position in ("ahead", "behind"):
        return f"{gap}{'ahead of' if placement.position == 'ahead' else 'behind'} {of}"
    lengthwise = {"behind": " behind", "ahead": " ahead of"}.get(placement.along or "", "")
    if placement.position in ("left_lane", "right_lane"):
        return f"{gap}{lengthwise.strip() or 'beside'} {of} in the lane to the {placement.position.partition('_')[0]}"
    if placement.position == "oncoming_lane":
        return f"{gap}ahead of {of} in the oncoming lane"
    return f"{gap}{'ahead of' if gap else 'beside'} {of} at its {placement.side} side"


def where_of(node: Any) -> str:
    """How an object is placed, from its first specifier of position."""
    from scenic.syntax import ast as s

    words = {
        s.AtSpecifier: "at", s.OnSpecifier: "on", s.InSpecifier: "in", s.ContainedInSpecifier: "in",
        s.FollowingSpecifier: "along the road from", s.OffsetBySpecifier: "offset by", s.BeyondSpecifier: "beyond",
    }  # fmt: skip
    for specifier in node.specifiers:
        if isinstance(specifier, s.DirectionOfSpecifier):
            direction = {s.LeftOf: "left of", s.RightOf: "right of", s.AheadOf: "ahead of", s.Behind: "behind"}
            word = direction.get(type(specifier.direction))
            return f"{word} {text_of(specifier.position)}" if word else ""
        if type(specifier) in words:
            fields = ("base",) if isinstance(specifier, s.FollowingSpecifier) else ("position", "region", "offset")
            values = [getattr(specifier, f) for f in fields if hasattr(specifier, f)]
            text = text_of(values[0]) if values and values[0] is not None else "ego"
            return "" if text == "a place" else f"{words[type(specifier)]} {text}"
    return ""


def text_of(node: Any) -> str:
    """A short expression in words: its source, or the name that it starts from."""
    parts = list(ast.walk(node))
    if any(type(part).__module__.startswith("scenic") for part in parts):
        name = next((part.id for part in parts if isinstance(part, ast.Name)), "")
        return f"a place near {name}" if name else "a place"
    try:
        text = ast.unparse(node)
    except (AttributeError, ValueError, RecursionError):
        return "a place"
    return text if len(text) <= 40 and "\n" not in text and "<" not in text else "a place"


def sentence(parts: Sequence[str], otherwise: str) -> str:
    told = "; ".join(p for p in parts if p) or otherwise
    return f"{told[0].upper()}{told[1:]}{'' if told.endswith('...') else '.'}" if told else ""
