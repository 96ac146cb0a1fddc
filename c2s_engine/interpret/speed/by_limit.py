"""Speeds told by the posted limit: "at the limit", "keeps to the limit"."""

import re

from c2s_engine.interpret.scene import Scene

NUMBER = r"\d+(?:\.\d+)? ?(?:km/h|kph|kmh|mph|m/s)?"
LIMIT = (
    r"(?:the |its |their |this |that |his |her |my |our )?"
    rf"(?:local |current |posted |legal |permitted |allowed |maximum |speed |signed |{NUMBER} )*limit\b"
)
AT_LIMIT = re.compile(
    r"\b(?:at|doing|does|do|drives?|driving|drove|keeps? to|keeping to|kept to|sticks? to|exactly|just|observes"
    rf"|respects) {LIMIT}(?! of| is| was|,? \d)"
)


def by_limit(scene: Scene) -> None:
    """The speeds that are told by the posted limit."""
    limit = scene.road.speed_limit
    if limit is None:
        return
