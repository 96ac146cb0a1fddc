"""Lanes by number: "the number two lane", "lane 3", counted from the left unless what happens tells otherwise."""

from __future__ import annotations

from c2s_engine.interpret.surroundings import lanes

NTH = "|".join(lanes.NTH)
