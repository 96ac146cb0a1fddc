"""Values that several are given in order: "ego and the van drive at 50 and 30 km/h (respectively)"."""

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.scan import Span
from c2s_engine.interpret.scene import Scene

IN_ORDER = re.compile(r"\brespective(?:ly)?\b|\bin (?:that|this) order\b")


def shared_out(scene: Scene) -> None:
    """The speeds and distances of those that a sentence names, one each."""
    for number, (start, end) in enumerate(scene.sentences):
        told = [s for s in scene.spans if s.kind == "quantity" and start <= s.start < end]
        in_order = IN_ORDER.search(scene.plain[start:end]) is not None
        for dimension in ("speed", "distance"):
            spans = [s for s in told if s.data["dimension"] == dimension and s.data.get("role") != "limit"]
            listed = [s for s in spans if "each" in s.data]
            spans = listed if listed and not in_order else spans
            values = [v for s in spans for v in s.data.get("each", (s.data["low"],))]
            if len(values) > 1 and (in_order or len(listed) == 1):
                _share(scene, number, dimension, spans, values)


def _share(scene: Scene, number: int, dimension: str, spans: list[Span], values: list[float]) -> None:
    """Give each of as many road users as there are values its own."""
    own = [scene.cast.of[i] for i in sorted(scene.cast.of) if scene.words[i].sentence == number]
    before = [
        i for i in sorted(scene.cast.of) if scene.words[i].sentence == number and scene.words[i].start < spans[0].start
    ]
    named = [scene.cast.of[i] for i in before] if dimension == "speed" else own
    parties: list[Entity] = [e for e in dict.fromkeys(named) if (e.mover or e.ego) and e.count == 1]
    if len(parties) != len(values):
        return
    for entity, value in zip(parties, values, strict=True):
        scene.where(entity).gap = (value, value)
