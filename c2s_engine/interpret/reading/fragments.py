"""What somebody does who is only named, where no verb that tells more stands before it: a participle behind a comma
("van ahead, braking hard", "got a cyclist on the left, swerving"), a verb behind a colon ("van ahead: brakes")."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOVERS
from c2s_engine.interpret.reading.motions import participles
from c2s_engine.interpret.spans import names_one

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

SHOWN = language.words("notices") | language.words("has_before_one")
FINITE = ("VBZ", "VBD", "VBP", "MD")


def participles_of_named(words: list[Word], sentence: list[Word]) -> list[tuple[int, int]]:
    """(road user, participle) for each participle behind a comma in a sentence that only names who does it."""
    found: list[tuple[int, int]] = []
    for verb in sentence:
        if verb.norm not in participles() or not _after_comma(words, sentence, verb):
            continue
        before = [w for w in sentence if w.i < verb.i]
        who = _named(before)
        own = who is not None and who.dep.startswith("nsubj") and who.head != verb.i and words[who.head].verb
        if who is not None and not own and not any(_tells(words, w, who) for w in before):
            found.append((who.i, verb.i))
    return found


def verbs_of_named(words: list[Word], sentence: list[Word]) -> list[tuple[int, int]]:
    """(road user, verb) where a finite verb without a subject stands right behind a colon or dash."""
    found: list[tuple[int, int]] = []
    for verb in sentence:
        before = [w for w in sentence if w.i < verb.i and w.tag != "RB"]
        if verb.tag != "VBZ" or not before or before[-1].norm not in (":", "-", "–"):
            continue
        who = _named(before)
        if who is not None:
            found.append((who.i, verb.i))
    return found


def _after_comma(words: list[Word], sentence: list[Word], verb: Word) -> bool:
    """Whether a word stands behind a comma, or behind "and" or an adverb behind it."""
    before = (w for w in reversed(sentence) if w.i < verb.i and w.tag not in ("RB", "CC"))
    comma = next(before, None)
    return comma is not None and comma.norm in (",", ";", "-", "–", ":")


def _named(before: list[Word]) -> Word | None:
    """The road user that the words name, where ego is not named before it."""
    named = [w for w in before if names_one(w.span, MOVERS)]
    own = [w for w in named if w.span is not None and w.span.kind == "ego" and not _place(w)]
    others = [w for w in named if w.span is not None and w.span.kind != "ego"]
    if not others or own and own[0].i < others[0].i and not any(w.lemma in SHOWN for w in before):
        return None
    return next((w for w in others if w.dep != "pobj"), others[0])


def _place(word: Word) -> bool:
    return word.dep in ("pobj", "poss")


def _tells(words: list[Word], word: Word, who: Word) -> bool:
    """Whether a word before is a verb that tells more than that somebody is there or is seen."""
    if word.tag not in (*FINITE, "VB", "VBG", "VBN") or word.span is not None:
        return False
    if word.tag in ("VBG", "VBN"):
        return word.norm in participles() and word.i < who.i or word.dep == "ROOT" and word.i > who.i
    there = any(words[c].dep == "expl" for c in word.children)
    seen = word.lemma in SHOWN and word.i < who.i
    return not (there or seen or word.dep in ("aux", "auxpass") and words[word.head].lemma in SHOWN)
