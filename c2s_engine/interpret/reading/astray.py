"""Phrases that the tree hangs on something else than what they tell of."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.hanging import hang, road_user

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

ON_ITS_WAY = frozenset(language.words("on_its_way"))
OPENS = frozenset(("while", "whilst", "when", "as"))
SIDES = frozenset(("road", "street", "side", "lane", "left", "right", "kerb", "curb", "pavement", "sidewalk", "verge"))
USES = frozenset(("use", "borrow", "cross", "enter"))


def bring_home(words: list[Word], word: Word) -> None:
    """Hang such a phrase on what it tells of."""
    doer = words[word.i - 2] if word.i > 1 and words[word.i - 1].norm == "," else word
    if word.dep == "advcl" and word.norm in ON_ITS_WAY and road_user(doer) and words[doer.head].dep == "agent":
        hang(words, word, doer, "acl")  # "was struck by V2, turning out of a lot"
    if (begun := _begun_before(words, word)) is not None:
        hang(words, word, begun, "advcl")  # "while I was at the lights waiting to turn, a rider came"
    before = words[word.i - 1]
    by = before.dep == "pobj" and words[before.head].dep == "agent" and road_user(before)
    if word.dep == "advcl" and word.tag == "VBN" and by:
        hang(words, word, before, "acl")  # "occluded by a van parked on the right"
    if word.norm == "at" and word.dep == "prep" and by and word.head != before.i and _has_its_speed(words, word):
        hang(words, word, before)  # "V1 at 60 mph is followed by V2 at 65 mph"
    if word.norm in ("at", "with") and word.dep == "prep" and before.dep == "nsubjpass" and road_user(before):
        hang(words, word, before)  # "V1 at 60 km/h is overtaken by a van"
    if (place := _clause_of_place(words, word)) is not None:
        hang(words, word, words[place.head], "advcl")
        hang(words, place, word)
    if (user := _what_for(words, word)) is not None:
        hang(words, word, user, "advcl")  # "uses ego's lane to pass a queue"
    if word.dep == "appos" and _listed(words, word):
        word.dep = "conj"  # "ego, a van and a truck are driving": no other name of ego
    if (verb := _clause_of_bracket(words, word)) is not None:
        hang(words, word, verb, "advcl")  # "enters ego's lane (overtaking a tractor)"
    if (verb := _verb_of_between(words, word)) is not None:
        hang(words, word, verb)  # "cuts in between ego and the lorry from the left"
    if (lane := _lane_before(words, word)) is not None:
        hang(words, word, lane)  # "approaches a queue in the lane to its right"


def _listed(words: list[Word], word: Word) -> bool:
    """Whether what is set off behind a road user is the next of a list: "ego, a van and a truck"."""
    further = [words[c] for c in word.children if words[c].dep == "conj"]
    new = all(any(words[c].norm in ("a", "an", "another") for c in w.children) for w in (word, *further))
    head = words[word.head]
    both = road_user(word) and road_user(head) and words[head.i + 1].norm == ","
    listed = both and bool(further) and all(map(road_user, further))
    return listed and new and any(words[c].norm == "and" for c in word.children)


def _clause_of_bracket(words: list[Word], word: Word) -> Word | None:
    """The verb of the clause that a participle in brackets tells more of, where it stands behind a place."""
    noun = words[word.head]
    bracketed = word.i > 0 and words[word.i - 1].norm == "("
    if word.dep != "acl" or word.tag != "VBG" or not bracketed or road_user(noun):
        return None
    above = noun
    while above.head != above.i and not above.verb:
        above = words[above.head]
    return above if above.verb and above.i < word.i else None


def _verb_of_between(words: list[Word], word: Word) -> Word | None:
    """The verb that tells who comes from a side between two, where the tree has the side with the second of them."""
    if word.norm != "from" or word.dep != "prep" or not any(words[c].norm in ("left", "right") for c in word.children):
        return None
    above = words[word.head]
    while above.dep == "conj" and words[above.head].noun:
        above = words[above.head]
    between = words[above.head]
    if above.dep != "pobj" or between.norm != "between":
        return None
    return words[between.head] if words[between.head].verb else None


def _begun_before(words: list[Word], word: Word) -> Word | None:
    """The verb of the clause before the comma that a participle belongs to, which the tree has with the main clause."""
    main = words[word.head]
    later = word.dep == "advcl" and main.verb and any(w.norm == "," for w in words[word.i : main.i])
    place = word.dep == "acl" and word.norm == "waiting" and main.span is None  # "at the junction waiting to turn"
    if word.tag != "VBG" or not later and not place:
        return None
    for other in reversed(words[max(0, word.i - 12) : word.i]):
        if other.sentence != word.sentence or other.norm == ",":
            return None
        if other.tag in ("VBD", "VBZ", "VBP"):
            marks = {words[c].norm for c in other.children}
            own = any(words[c].dep.startswith("nsubj") for c in other.children)
            return other if own and marks & OPENS else None
    return None


def _has_its_speed(words: list[Word], at: Word) -> bool:
    """Whether a speed is told before the verb, so that another behind "by" is of who is named there."""
    verb = words[at.head]
    spans = [w.span for w in words if w.sentence == at.sentence and w.i < verb.i and w.span is not None]
    return any(s.kind == "quantity" and s.data["dimension"] == "speed" for s in spans)


def _clause_of_place(words: list[Word], verb: Word) -> Word | None:
    """The fronted place of a clause that the tree takes for a relative one: "on the left side of the road two children
    play, while on the right side ..."."""
    noun = words[verb.head]
    subject = next((words[c] for c in verb.children if words[c].dep == "nsubj" and c < verb.i), None)
    if verb.dep != "relcl" or verb.tag not in ("VBP", "VBZ", "VBD") or subject is None or noun.norm not in SIDES:
        return None
    first = min([subject.i, *(c for c in subject.children if c < subject.i)])
    place = noun
    while place.dep in ("prep", "pobj") and words[place.head].i < place.i:
        place = words[place.head]
    alone = place.dep == "prep" and words[place.head].i > verb.i
    return place if first == noun.i + 1 and road_user(subject) and alone else None


def _what_for(words: list[Word], word: Word) -> Word | None:
    """The verb that tells what somebody uses to do this, where the tree has this with what is used."""
    if word.tag != "VB" or word.dep not in ("relcl", "acl") or words[word.i - 1].norm != "to":
        return None
    used = words[word.head]
    verb = words[used.head]
    own = any(words[c].dep.startswith("nsubj") for c in word.children)
    return verb if used.dep == "dobj" and verb.lemma in USES and not own else None


def _lane_before(words: list[Word], word: Word) -> Word | None:
    """The lane right before "to its right", in which somebody is and which the tree has not with it."""
    if word.norm != "to" or word.dep != "prep" or word.i < 3 or words[word.i - 1].norm != "lane":
        return None
    lane = words[word.i - 1]
    sideways = any(words[c].dep == "pobj" and words[c].norm in ("left", "right") for c in word.children)
    placed = lane.dep == "pobj" and words[lane.head].norm in ("in", "along")
    return lane if sideways and placed and word.head != lane.i else None
