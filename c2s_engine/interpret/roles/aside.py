"""Who is said to come from a side of the road, and is therefore not ego."""

import re

from c2s_engine.interpret.who.mentions import Cast

FROM_ASIDE = re.compile(
    r"^(?!.*\b(?:turn|chang|merg|mov|swerv|veer)\w*\b.* from ).*\bfrom (?:the |its )?"
    r"(?:left|right|rear|behind|front|opposite (?:side|direction|carriageway|lane))\b"
    r"(?! (?:\w+ )?(?:lane|side|turn|shoulder|kerb|curb)\b)"
    r"|\b(?:from|out of|leav\w+) (?:the |a |an )?(?:\w+ )?(?:street|road|driveway) (?:on|to)"
    r" (?:the |its )(?:left|right)\b"
    r"|\b(?:comes?|came|coming|approach\w*) (?:along |up )?(?:the wrong way|against the traffic)\b"
    r"|^\S+ (?:\S+ )?at the (?:left|right)(?:-hand)? (?:kerb|curb)\b"
)
"""A way by which one comes towards somebody who is not named: that is ego."""


def after(i: int, cast: Cast) -> str:
    """A word with what follows it in its sentence."""
    return " ".join(w.norm for w in cast.words[i : i + 10] if w.sentence == cast.words[i].sentence)


def from_aside(i: int, cast: Cast) -> bool:
    """Whether one is said to come from a side, not who does something meanwhile ("by a car while crossing")."""
    return FROM_ASIDE.search(re.split(r" (?:while|whilst|when|as|who)\b", after(i, cast))[0]) is not None
