"""Who "had pulled over" before the story begins stands at the side of the road."""

from __future__ import annotations

ACTS = frozenset(
    (
        "turn_or_change",
        "leave_road",
        "lane_change",
        "stop",
        "brake_stop",
        "cut_out",
        "cut_in",
        "turn",
        "travel",
        "drift",
        "exit_road",
    )
)
