"""A "crossing" where people cross: a crosswalk."""

import re

from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.what.clauses import Clauses

CROSSING = re.compile(
    r"(?<!\brail )(?<!\brailway )(?<!\blevel )(?<!\brailroad )(?<!\btrain )(?<!\bgrade )"
    r"\b(?:before|at|for|to|towards?|on|over|onto|near|short of|reach\w*|approach\w*|past|from|in front of) "
    r"(?:an?|the|this|that|its) (?:school |foot |busy |marked |raised |next )?crossings?\b"
    r"(?! (?:of|the|an?|paths?|traffic|vehicles?|cars?|streets?|roads?|from|in front|guard|point|where)\b)"
)
JUNCTION = re.compile(
    r"\b(?:junctions?|intersections?|crossroads?|roundabout|turn(?:s|ed|ing)?|(?:traffic )?(?:lights?|signals?)"
    r"|level crossing|railway|railroad|trains?|trams?|(?:side|main|minor|cross)[- ](?:road|street)s?"
    r"|give[- ]way|stop sign|right of way|priority)\b"
)
"""What tells that roads cross there, or rails."""
THERE = frozenset(("cross_road", "stationary", "wait", "yield", "stop"))


def on_foot(plain: str, road: Road, clauses: Clauses) -> None:
    """Note a crosswalk where people cross, or wait, at a crossing of which nothing tells that roads meet there."""
    match = CROSSING.search(plain)
    if match is None or road.crosswalk or road.kind == "intersection" or JUNCTION.search(plain):
        return
    if any(e.done and e.agent.person and e.agent.type != "animal" and e.act in THERE for e in clauses.events):
        road.crosswalk = True
        road.spans.setdefault("crosswalk", match.span())
