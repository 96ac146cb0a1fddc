"""Whom an entry of a typology calls "vehicle", without an article."""

from c2s_engine.interpret.who.mentions import Cast, Entity

ROLE_WORDS = frozenset(("lead", "oncoming", "parked", "stationary", "crossing", "adjacent", "cut_in", "slow"))


def bare_first(vehicles: list[Entity], cast: Cast) -> list[Entity]:
    """The "vehicle" without an article of which an entry of a typology tells first: "Vehicle is backing up ..."."""
    for entity in vehicles[:1]:
        first = cast.words[entity.mentions[0].word]
        before = cast.words[first.i - 1] if first.i else None
        alone = before is None or before.sentence != first.sentence or before.norm in (":", ",")
        acting = first.dep in ("nsubj", "nsubjpass") and not any(c < first.i for c in first.children)
        if entity.noun == "vehicle" and not entity.label and alone and acting and not entity.roles & ROLE_WORDS:
            return [entity]
    return []
