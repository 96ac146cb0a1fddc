"""Who is only said not to do something is there all the same: "the child does not step onto the road" stands there."""

from __future__ import annotations

STEPS = frozenset(("cross_road", "enter_road"))
