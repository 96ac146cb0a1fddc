"""Who goes on with what was begun: "After a motorcycle had passed, it completed its turn"."""

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

RESUMES = re.compile(
    r"(?:complete|finish|make|begin|start|continue|resume|execute|carry out|go on with|proceed with) "
    r"(?:with )?(?:@\w+ 's|its|his|her|their|the) (?:\w+ )?(?:turn|man(?:oeuvre|euver))\b"
)


def own_turns(cast: Cast, clauses: Clauses) -> None:
    """A turn that "it" completes is that of the one who was said to want to turn."""
    for event in clauses.events:
        if event.act != "turn" or event.mode != "fact" or not RESUMES.search(event.text):
            continue
        subjects = [c for c in cast.words[event.word].children if cast.words[c].dep == "nsubj"]
        if not subjects or cast.words[subjects[0]].norm not in ("it", "he", "she", "they"):
            continue
        earlier = [e for e in clauses.events if e.act == "turn" and e.word < event.word]
        if any(e.agent is event.agent for e in earlier):
            continue
        meant = [e for e in earlier if e.mode in ("intended", "purpose")]
        if meant:
            event.agent, event.side = meant[-1].agent, event.side or meant[-1].side
