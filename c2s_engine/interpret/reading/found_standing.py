"""Who is found standing: participles that the tree takes for what one does ("struck V2, legally parked at the kerb",
"did not see V2 stopped ahead", "noticed a van stopped ahead and braked")."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.hanging import hang, road_user
from c2s_engine.interpret.reading.motions import irregular

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

SEES = language.words("notices")
CONTACT = language.words("contact") | language.words("strikes")
FINDS = frozenset(("find", "meet", "encounter", "have"))
LOOSE = frozenset(("conj", "dep", "ccomp", "advcl"))
STOOD = frozenset(("stopped", "parked", "slowed", "standing", "waiting"))
PLACED = frozenset(("ahead", "there", "here", "in", "on", "already", "still"))
STANDING_AT = PLACED | {"at", "for", "behind", "before", "near", "along", "across"}


def found_standing(words: list[Word], word: Word) -> None:
    """Make such a verb the participle of who stands there."""
    if word.dep in LOOSE and (struck := _stood(words, word)) is not None:
        hang(words, word, struck)
        word.dep, word.tag = "acl", "VBN"
    if word.dep in ("ccomp", "xcomp") and (struck := _found_standing(words, word)) is not None:
        _make_participle(words, word, struck)


def _stood(words: list[Word], word: Word) -> Word | None:
    """Who was hit standing, in notes: "struck rear of V2, stopped in traffic", "came upon V2 stopped in the lane"."""
    if _right_behind(words, word):
        return words[word.i - 1]
    struck = _before_comma(words, word)
    where = [words[c].norm for c in word.children if words[c].dep in ("prep", "cc", "conj") and c == word.i + 1]
    if struck is None or word.norm not in STOOD or not where or "after" in where:
        return None
    verb = struck
    while not verb.verb and verb.head != verb.i:
        verb = words[verb.head]
    hits = {verb.lemma, irregular().get(verb.norm)} & (CONTACT | {"push"}) and struck.dep in ("dobj", "pobj")
    return struck if hits else None


def _before_comma(words: list[Word], word: Word) -> Word | None:
    """Who is named before the comma of a participle: "V2, legally parked", "V2 (a Kia), parked"."""
    at = word.i - 2 if words[word.i - 1].norm.endswith("ly") or words[word.i - 1].norm in PLACED else word.i - 1
    if at < 1 or words[at].norm != ",":
        return None
    if words[at - 1].norm == ")":
        at = next((n for n in range(at - 1, max(0, at - 12), -1) if words[n].norm == "("), at)
    return words[at - 1] if at else None


def _found_standing(words: list[Word], word: Word) -> Word | None:
    """Who was hit or seen standing, where the tree has it stop: "struck a Ford stopped at a red light"."""
    verb, noun = words[word.head], words[word.i - 1]
    if word.norm not in STOOD or noun.i not in word.children or noun.dep != "nsubj" or not road_user(noun):
        return None
    if any(words[c].dep in ("mark", "aux", "advmod") and words[c].norm not in PLACED for c in word.children):
        return None
    hits = {verb.lemma, irregular().get(verb.norm)} & (CONTACT | SEES | FINDS)
    return noun if hits and verb.i < noun.i else None


def _right_behind(words: list[Word], word: Word) -> bool:
    """Whether a participle of standing without a subject stands right behind the object of another verb."""
    noun, after = words[word.i - 1], words[word.i + 1].norm if word.i + 1 < len(words) else ""
    bare = not any(words[c].dep in ("nsubj", "nsubjpass", "aux", "auxpass", "mark", "cc") for c in word.children)
    alone = word.dep in ("advcl", "ccomp", "dep") and bare and word.norm in STOOD
    return alone and noun.dep in ("dobj", "pobj") and road_user(noun) and after in STANDING_AT


def _make_participle(words: list[Word], word: Word, noun: Word) -> None:
    """Make a clause the participle of the noun it was taken to have as its subject."""
    above = words[word.head]
    hang(words, noun, above)
    hang(words, word, noun)
    noun.dep, word.dep, word.tag = "dobj", "acl", "VBN"
