"""What stands ahead of one who leaves the lane in front of ego: hidden by it until then."""

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

REVEALS = re.compile(
    r"only (?:then|now)|comes? into view|into (?:its |@?\w+ 's )?view|becomes? visible|reveal|expos|uncover|unveil"
    r"|suddenly (?:confronted|faced)|cannot see|can not see|hidden|conceal|appears? (?:in front|ahead)|see past|unseen"
    r"|until then|behind it"
)
LEAVES = frozenset(("cut_out", "lane_change", "swerve", "turn_or_change", "exit_road"))
BACK = frozenset(("cut_in", "lane_change", "drift"))
SPREAD = frozenset(("construction_zone", "lane_closure"))
"""What is too long to be hidden by one that drives ahead of it."""


def reveal(cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Hide what stands behind one that leaves ego's lane: where the text says that it is seen only then, or names it
    for the first time right after."""
    leaving = next((e for e in clauses.events if e.done and e.act in LEAVES and _leads(e.agent, of)), None)
    if leaving is None:
        return
    told = REVEALS.search(" ".join(w.norm for w in cast.words)) is not None
    for entity in cast.entities:
        where = of[entity]
        beyond = where.of is leaving.agent and where.rel == "behind"  # "behind it" is seen from ego
        if (
            entity is leaving.agent
            or where.hidden_by is not None
            or where.lane not in (None, "same")
            or entity.type in SPREAD
            or not _stands(entity, clauses)
            or not (told)
        ):
            continue
        where.hidden_by = leaving.agent
        if where.of is None or where.of.ego or beyond:
            where.of, where.rel = leaving.agent, "ahead"
        if told and not any(
            e.agent is leaving.agent and e.order > leaving.order and e.act in BACK for e in clauses.events
        ):
            leaving.act = "cut_out"


def _leads(entity: Entity, of: dict[Entity, Where]) -> bool:
    """Whether one drives ahead of ego in its lane, as far as is told."""
    if entity.ego or not entity.mover:
        return False
    return of[entity].lane in (None, "same") and of[entity].rel in (None, "ahead")


def _stands(entity: Entity, clauses: Clauses) -> bool:
    acts = any(e.agent is entity and e.act == "stationary" for e in clauses.events)
    return acts or "stationary" in entity.roles or not entity.mover
