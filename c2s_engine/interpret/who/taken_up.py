"""Whom "it" takes up as an object: what the same one saw before, or the doer of the sentence before who is followed."""

from c2s_engine.interpret.entities import VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word

BEHIND = frozenset(("follow", "tail", "shadow"))
SUBJECTS = ("nsubj", "nsubjpass")


def taken_up(words: list[Word], of: dict[int, Entity], subjects: list[tuple[int, Entity]], it: Word) -> Entity | None:
    """ "Ego sees the tyre too late and hits it", "the van changes lanes to pass a tractor. Ego follows it"."""
    verb = words[it.head]
    if it.norm != "it" or it.dep != "dobj":
        return None
    own = any(words[c].dep in SUBJECTS for c in verb.children)
    if verb.dep == "conj" and not own and verb.head < verb.i:
        seen = [of[c] for c in words[verb.head].children if words[c].dep == "dobj" and c in of and c < verb.i]
        if len(seen) == 1 and not seen[0].ego and not seen[0].person:
            return seen[0]
    if verb.lemma not in BEHIND:
        return None
    told = [e for i, e in subjects if words[i].sentence == it.sentence - 1]
    return told[0] if len({*told}) == 1 and not told[0].ego and told[0].type in VEHICLES else None
