"""What a text denies and somebody still does: "ego does not swerve but brakes" is not only that it brakes."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.demands import apart
from c2s_engine.interpret.changes.refer import doing, refer
from c2s_engine.structure.components import Component, Structure

DENIED = re.compile(
    r"\b(?P<who>(?:the )?[\w-]+) (?:(?:does|do|should|must|shall|will) ?(?:not|n.t)|never) (?:yet |any more )?"
    r"(?P<verb>[a-z]+)(?: way)?(?= but\b|,|;|\.|$)"
)
REACTIONS = {"brake": "brak|stop|react", "yield": "yield|giv", "evade": "swerv|evad|react"}


def still_done(text: str, structure: Structure) -> list[str]:
    """The demands for what a text denies of those who still do it."""
    found = []
    for match in DENIED.finditer(". ".join(part for sentence in text.split(". ") for part in apart(sentence))):
        who = refer(match["who"], structure, alone=False)
        if who is not None and _does(who, match["verb"]):
            found.append(f"{'ego' if who.id == 'E' else who.id.lower()} does not {match['verb']}")
    return list(dict.fromkeys(found))


def _does(who: Component, verb: str) -> bool:
    """Whether somebody does by S what a verb says, as an act or as a reaction."""
    acts = [p.action for p in getattr(who.spec, "phases", ())]
    reaction = REACTIONS.get(getattr(who.spec, "reaction", ""), "(?!)")
    told = any(re.match(stem, verb) for stem in language.table("refine")["doers"])
    return bool(re.match(reaction, verb)) or told and doing(verb, acts) or verb in acts
