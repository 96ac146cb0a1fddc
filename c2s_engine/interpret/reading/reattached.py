"""Verbs that the tree hangs on a relative clause and that go on with the clause before it: "ego follows a tractor that
crawls along and overtakes it" (who crawls along cannot overtake itself)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOVERS

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

OBJECTS = frozenset(("it", "him", "her", "them"))
TOWED = language.words("towed")


def reattach(words: list[Word]) -> None:
    """Hang each such verb on the verb of the clause before."""
    for word in words:
        above = _resumed(words, word)
        if above is not None:
            words[word.head].children.remove(word.i)
            above.children.append(word.i)
            above.children.sort()
            word.head = above.i


def _resumed(words: list[Word], word: Word) -> Word | None:
    """The verb with which a coordinated one goes on, where its object is the noun of the relative clause."""
    relative = words[word.head]
    if word.dep != "conj" or word.tag not in ("VBZ", "VBD") or relative.dep != "relcl" or relative.i > word.i:
        return None
    if any(words[c].dep.startswith("nsubj") for c in word.children) or not _takes_pronoun(words, word):
        return None
    if any(_road_user(w) for w in words[relative.i + 1 : word.i]):
        return None  # "a car that passes ego and hits it"
    above = _clause(words, words[relative.head])
    subjects = [words[c] for c in above.children if words[c].dep == "nsubj"] if above is not None else []
    return above if any(s.span is not None and s.i < relative.head for s in subjects) else None


def _road_user(word: Word) -> bool:
    """Whether a word names one who moves, and not a trailer."""
    span = word.span
    if span is None or span.kind != "actor":
        return span is not None and span.kind in ("ego", "label")
    return span.data["type"] in MOVERS and span.data.get("noun") not in TOWED


def _takes_pronoun(words: list[Word], verb: Word) -> bool:
    """Whether the object of a verb, or of its preposition, is a pronoun."""
    inner = [i for c in verb.children if words[c].dep == "prep" for i in words[c].children]
    return any(
        words[i].norm in OBJECTS and words[i].dep in ("dobj", "pobj") and i > verb.i for i in (*verb.children, *inner)
    )


def _clause(words: list[Word], noun: Word) -> Word | None:
    """The verb whose object a noun is, also behind a preposition."""
    if noun.dep not in ("dobj", "pobj"):
        return None
    above = words[noun.head]
    for _ in range(3):
        if above.verb or above.head == above.i:
            break
        above = words[above.head]
    return above if above.verb and above.i < noun.i else None
