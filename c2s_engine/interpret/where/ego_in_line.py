"""Ego as one of a line of vehicles that were told together: "three cars drive in a row, the last one is ego"."""

from __future__ import annotations

from c2s_engine.interpret.entities import ORDINALS

NUMBERS = {**{name: at + 1 or -1 for name, at in ORDINALS.items()}, "middle": 0, "rearmost": -1, "hindmost": -1}
NUMBER = f"(?P<n>{'|'.join(NUMBERS)})"
