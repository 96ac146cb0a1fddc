"""Speeds told by the posted limit: "at the limit", "keeps to the limit"."""

import re

NUMBER = r"\d+(?:\.\d+)? ?(?:km/h|kph|kmh|mph|m/s)?"
LIMIT = (
    r"(?:the |its |their |this |that |his |her |my |our )?"
    rf"(?:local |current |posted |legal |permitted |allowed |maximum |speed |signed |{NUMBER} )*limit\b"
)
AT_LIMIT = re.compile(
    r"\b(?:at|doing|does|do|drives?|driving|drove|keeps? to|keeping to|kept to|sticks? to|exactly|just|observes"
    rf"|respects) {LIMIT}(?! of| is| was|,? \d)"
)
