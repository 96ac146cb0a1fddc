"""Values that several are given in order: "ego and the van drive at 50 and 30 km/h (respectively)"."""

import re

from c2s_engine.interpret.scene import Scene

IN_ORDER = re.compile(r"\brespective(?:ly)?\b|\bin (?:that|this) order\b")


def shared_out(scene: Scene) -> None:
    """The speeds and distances of those that a sentence names, one each."""
    for _number, (start, end) in enumerate(scene.sentences):
        told = [s for s in scene.spans if s.kind == "quantity" and start <= s.start < end]
        in_order = IN_ORDER.search(scene.plain[start:end]) is not None
        for dimension in ("speed", "distance"):
            spans = [s for s in told if s.data["dimension"] == dimension and s.data.get("role") != "limit"]
            listed = [s for s in spans if "each" in s.data]
            spans = listed if listed and not in_order else spans
