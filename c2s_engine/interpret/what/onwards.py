"""What is told of one by its name or goes on from what it did before: "a left-turning van", "drifted left and mounted
the kerb"."""

from __future__ import annotations

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.towards import side

TOWARDS = frozenset(("drift", "swerve", "lane_change", "turn_or_change", "lose_control"))
TURNING = re.compile(r"\b(?P<side>left|right)[- ]turning\b")


def same_side(clauses: Clauses) -> None:
    """Let who leaves the road after going to one side leave it on that side, where none is told."""
    for event in clauses.events:
        if event.act != "leave_road" or not event.done or side(event) is not None:
            continue
        here = clauses.words[event.word].sentence
        before = [e for e in clauses.events if e.agent is event.agent and e.done and e.order < event.order]
        near = [e for e in before if e.act in TOWARDS and here - clauses.words[e.word].sentence <= 1]
        if near and near[-1] is max(before, key=lambda e: e.order):
            event.side = side(near[-1])
