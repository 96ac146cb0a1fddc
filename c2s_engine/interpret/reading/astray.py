"""Phrases that the tree hangs on something else than what they tell of."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret.reading.hanging import hang, road_user

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word
USES = frozenset(("use", "borrow", "cross", "enter"))


def bring_home(words: list[Word], word: Word) -> None:
    """Hang such a phrase on what it tells of."""
    before = words[word.i - 1]
    if word.norm in ("at", "with") and word.dep == "prep" and before.dep == "nsubjpass" and road_user(before):
        hang(words, word, before)  # "V1 at 60 km/h is overtaken by a van"
    if (user := _what_for(words, word)) is not None:
        hang(words, word, user, "advcl")  # "uses ego's lane to pass a queue"
    if word.dep == "appos" and _listed(words, word):
        word.dep = "conj"  # "ego, a van and a truck are driving": no other name of ego
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
