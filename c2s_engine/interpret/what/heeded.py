"""What is not done although it should or was meant to be: lights and signs that are not heeded, turns that another
keeps ego from."""

from __future__ import annotations

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.towards import side

RUNS = {"heed_red": "run_red", "heed_stop": "run_stop"}
JUNCTION = frozenset(("turn", "u_turn", "go_straight", "cross_path"))


def unheeded(clauses: Clauses) -> None:
    """Who does not see or obey a light or a sign runs it; who does is only said to."""
    for event in [e for e in clauses.events if e.act in RUNS]:
        if event.mode == "negated":
            event.act, event.mode = RUNS[event.act], "fact"
    for event in clauses.events:
        if event.act == "keep_lane" and event.mode == "negated":
            event.act, event.mode = "drift", "fact"  # "fails to keep its lane"


BACK = re.compile(
    r"\b(?:back|return\w*|in again|(?:its|the|his|her|my) (?:own |original |initial )?lane|ahead of|in front of)\b"
)


def merged_back(clauses: Clauses) -> None:
    """Who moves back after it overtook only ends that: "overtakes a tractor and merges back"."""
    for event in clauses.events:
        if event.act not in ("lane_change", "cut_in") or not event.done or not event.agent.ego:
            continue
        own = [e for e in clauses.events if e.agent is event.agent and e.done and e.order < event.order]
        passes = [e for e in own if e.act == "overtake"]
        out = [e for e in own if e.act == "lane_change"]
        if passes and not out and side(event) is None and BACK.search(event.text):
            event.mode = "hypothetical"
