"""Who leaves his lane and comes back: the way back leads to the other side."""

import re

COMES_BACK = re.compile(
    r"(?:come|get|go|move|steer|swing|pull|slip|drive|cut|find (?:its|his|her) way) (?:\w+ly |just |right )?back\b"
    r"(?! (?:and forth|to|in|into|onto|over) (?!(?:its|his|her|their|the) (?:own |correct |proper |right )*"
    r"(?:lane|side|half)\b)\w)"
)
"""How one comes back over the line, where nothing is said of the lane."""
