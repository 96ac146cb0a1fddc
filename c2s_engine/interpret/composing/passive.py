"""Whether ego is said not to react."""

import re

from c2s_engine.interpret.scene import Scene

RESPONSES = ("brake", "brake_stop", "stop")
NO_REACTION = re.compile(
    r"\b(?:does not|doesn't|do not|don't|did not|didn't|fails? to|failed to|without|never|not) (?:even |at all )?"
    r"(?:react|respond|brak|slow|reduc|decelerat|notic)\w*"
)


def remains_passive(scene: Scene) -> bool:
    """Whether the text denies that ego reacts ("does not react at all", "ego doesn't brake"): not where it bounds how
    hard ("must not brake harder than 5 m/s2")."""
    ego = scene.cast.ego
    bounds = [told.span for told in scene.limits]
    own = [e for e in scene.clauses.events if e.agent is ego and
           not any(start <= scene.words[e.word].start < end for start, end in bounds)]  # fmt: skip
    denied = any(e.mode == "negated" and e.act in (*RESPONSES, "yield", "evade") for e in own)
    spoken = [e for e in own if NO_REACTION.search(e.whole)]
    after = [scene.plain[m.end : m.end + 60].split(".")[0] for m in ego.mentions]
    passive = any(re.match(r"[^,;]*?" + NO_REACTION.pattern, text) and "react" in text for text in after)
    return denied or bool(spoken) or passive
