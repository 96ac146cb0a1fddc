"""Speeds that are told by the limit of the road: "ego at the limit", "the van drives 10 over the limit"."""

import re

from c2s_engine.interpret import language


def in_order(parts: list[str]) -> list[str]:
    """The demands of a text, those that tell a speed by the limit behind the one that tells the limit."""
    if not any(re.search(_table()["set"], part) for part in parts):
        return parts
    return sorted(parts, key=lambda part: bool(re.search(_table()["said"], part)))


def _table() -> dict[str, str]:
    found: dict[str, str] = language.table("refine")["limits"]
    return found
