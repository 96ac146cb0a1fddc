"""Names of crash types: what they mean in plain words, as far as the text itself leaves it open."""

import re

from c2s_engine.interpret import language, understanding
from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.scene import Scene

SAYS_MORE = re.compile(
    r"night|rain|fog|snow|wet|icy|rural|urban|highway|motorway|limit|\d|dusk|dawn|day|turning|approach|while"
    r"|from (the )?(left|right)|: \w"
)
ADJECTIVES = "(?:oncoming|slower|stopped|stationary|lead|parked|slow) "


def named(text: str) -> tuple[str, str, tuple[int, int]] | None:
    """(what the crash type means that a text names, the rest of the text, where the name stands)."""
    table = language.table("typologies")
    whole = scan.normalised(text)
    plain = " ".join(whole.split()).strip(" .")
    if len(plain.split()) > table["words_at_most"]:
        return None
    for entry in table["types"]:
        if re.search(entry["find"], plain) and not ("not" in entry and re.search(entry["not"], plain)):
            rest = re.sub(entry["find"], " ", plain)
            detail = [s for s in scan.names(rest) if s.kind in ("ego", "actor", "label")]
            at = re.search(entry["find"], whole)
            headed = (
                at is not None and re.match(r"[^:.;]{0,40}:", whole[at.end() :]) and not whole[: at.start()].strip()
            )
            if len(detail) >= (3 if headed else 2):
                return None
            return entry["means"], rest, at.span() if at else (0, 0)
    return None


def understand(text: str) -> Scene:
    """The scene of a text; a named crash type only fills what the text leaves open."""
    found = named(text)
    if found is None:
        return understanding.understand(text)
    meant, rest, (start, end) = found
    own = understanding.understand(text)
    if _tells(own, meant):
        return own
    if not SAYS_MORE.search(scan.normalised(rest)):
        return understanding.understand(meant)
    usual = understanding.understand(meant)
    outside = {e.key for e in own.cast.entities for m in e.mentions if not start <= m.start < end and e.mover}
    inside = {e.key for e in own.cast.entities for m in e.mentions if start <= m.start < end} - outside
    if inside and outside:
        text = text[:start] + " " * (end - start) + text[end:]
    own = understanding.understand(f"{text}. Ego drives on.")
    return understanding.understand(f"{text} {_fitted(meant, rest, own, usual)}")


def _tells(found: Scene, meant: str) -> bool:
    """Whether a text says by itself what ego and others do, so that the name of a crash type in it adds nothing."""
    own = [e for e in found.clauses.events if e.agent.ego and e.done and e.start < e.end]
    whole = bool(found.actors) or not re.search(r"\b(car|truck|vehicle|pedestrian|cyclist|animal|deer)\b", meant)
    return bool(found.cast.ego.mentions) and bool(own) and whole


def _fitted(meant: str, rest: str, own: Scene, usual: Scene) -> str:
    """The type's meaning with the side and the road user that the text names in place of the usual ones."""
    told = [e for e in own.cast.entities if e.mover and e.noun]
    replaced = usual.actors[0] if len(usual.actors) == 1 else None
    if replaced is not None and len(told) == 1 and told[0].count == 1:
        meant = re.sub(rf"\b(?:an?|the) (?:{ADJECTIVES})*{replaced.noun}\b", f"the {told[0].noun}", meant, flags=re.I)
    return meant
