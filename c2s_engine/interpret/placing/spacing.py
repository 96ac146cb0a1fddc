"""How far apart the members of a group are: "three trucks 20 m apart", "with 15 m between them"."""

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.scene import Scene
from c2s_engine.structure.specs import Placement

AFTER = re.compile(
    r"\s*(?:apart\b|(?:from|to|behind|after) (?:each other|one another|the next)\b"
    r"|between (?:them|each|every|the (?:vehicles|cars|trucks|lorries|two|three)|one and the next)\b"
    r"|(?:behind|after|ahead of|in front of) (?:the (?:first|other|leading|front|one in front)\b|another\b)"
    r"|(?:gaps?|intervals?|spacings?)\b)"
)
BEFORE = re.compile(
    r"\b(?:spac(?:ed|ing)|intervals?|gaps?|separated)(?: between (?:them|each|the \w+))?(?: of| by| at| is| are|:|,)*"
    r"(?: about| around| roughly| some)?\s*$"
)


def spacing_of(scene: Scene, entity: Entity) -> float | tuple[float, float] | None:
    """The distance between the members of a group, where its sentence or the next tells it."""
    if entity.count < 2 or not entity.mentions:
        return None
    at = scene.words[entity.mentions[0].word].sentence
    for word in scene.words:
        span = word.span
        if span is None or span.kind != "quantity" or span.data["dimension"] != "distance":
            continue
        before = scene.plain[max(0, span.start - 50) : span.start]
        apart = AFTER.match(scene.plain[span.end : span.end + 40]) is not None
        if word.sentence in (at, at + 1) and (apart or BEFORE.search(before)):
            low, high = span.data["low"], span.data["high"]
            return round(low, 1) if high - low < 0.5 else (round(low, 1), round(high, 1))
    return None


def without_spacing(placement: Placement, spacing: float | tuple[float, float] | None) -> Placement:
    """The placement without a gap that only says how far apart the members are."""
    same = spacing is not None and placement.gap == spacing
    return placement.model_copy(update={"gap": None}) if same else placement
