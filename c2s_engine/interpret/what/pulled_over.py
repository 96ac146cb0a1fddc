"""Who "had pulled over" before the story begins stands at the side of the road."""

from __future__ import annotations

from c2s_engine.interpret.entities import MOTOR
from c2s_engine.interpret.what.clauses import Clauses

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


def had_pulled_over(clauses: Clauses) -> None:
    """Let such a one stand, at the roadside where it is another than ego."""
    for event in clauses.events:
        if event.act not in ACTS or event.mode != "fact" or event.agent.type not in MOTOR:
            continue
