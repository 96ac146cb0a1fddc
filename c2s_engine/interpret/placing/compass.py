"""Compass directions of two vehicles: which way one comes from, seen from the other."""

import re

from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import Entity

COMPASS = {"north": 0, "east": 90, "south": 180, "west": 270}


def _heading(text: str) -> int | None:
    match = re.search(r"\b(north|south|east|west)(?:bound|ward|wards|erly)?\b", text)
    if match is None:
        return None
    from_it = re.search(r"(from|of) (the )?(north|south|east|west)\b(?!bound)", text)
    return (COMPASS[match[1]] + (180 if from_it else 0)) % 360


def compass(scene: Scene, entity: Entity) -> str | None:
    """left, right (coming from there), opposite or same, by the compass directions of ego and the other."""

    def heading(who: Entity) -> int | None:
        for event in scene.clauses.events:
            if event.agent is who:
                found = _heading(event.whole)
                if found is not None:
                    return found
        for mention in who.mentions:
            words = [
                w.norm
                for w in scene.words[max(0, mention.word - 1) : mention.word + 8]
                if w.sentence == scene.words[mention.word].sentence
            ]
            found = _heading(" ".join(words))
            if found is not None:
                return found
        return None

    own, other = heading(scene.cast.ego), heading(entity)
    if own is None or other is None:
        return None
    return {0: "same", 90: "left", 180: "opposite", 270: "right"}[(other - own) % 360]
