"""Subjects that the tree gives to another word: two who met ("a Ford and a Mazda collided"), and who does something
while doing another thing ("when a cyclist riding on the right swerved")."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret.reading.hanging import hang, road_user

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

MEETS = frozenset(("collide", "crash", "meet", "touch"))
HIT = frozenset(("hit", "struck", "clipped", "rammed", "rear-ended", "killed", "injured", "overtaken"))
SUBJECTS = ("nsubj", "nsubjpass", "aux", "auxpass", "expl")


def own_subject(words: list[Word], verb: Word) -> None:
    """Give a verb the subject that is its own."""
    if verb.dep == "acl":
        tell_of_two(words, verb)
    share_participle(words, verb)
    suffer(words, verb)
    before_its_clause(words, verb)


def tell_of_two(words: list[Word], verb: Word) -> None:
    """Make a past form behind two that are joined the verb of both."""
    noun = words[verb.head]
    first = words[noun.head]
    two = noun.dep == "conj" and first.dep == "ROOT" and road_user(noun) and road_user(first)
    if two and verb.lemma in MEETS and verb.tag in ("VBN", "VBD"):
        verb.tag = "VBD"
        hang(words, first, verb, "nsubj")


def share_participle(words: list[Word], verb: Word) -> None:
    """Give a past form the noun that the tree has as the subject of the participle between them."""
    if verb.tag not in ("VBD", "VBN") or any(words[c].dep in SUBJECTS for c in verb.children):
        return
    for child in (words[c] for c in verb.children if c < verb.i):
        nouns = [words[c] for c in child.children if words[c].dep == "nsubj" and c + 1 == child.i]
        helped = any(words[c].dep == "aux" for c in child.children)
        if child.tag == "VBG" and child.dep == "advcl" and nouns and road_user(nouns[0]) and not helped:
            for mark in [
                words[c] for c in child.children if words[c].norm in ("when", "while", "as") and c < nouns[0].i
            ]:
                hang(words, mark, verb)
            hang(words, nouns[0], verb)
            hang(words, child, nouns[0], "acl")
            verb.tag = "VBD"
            return


def suffer(words: list[Word], verb: Word) -> None:
    """Make a form before "by" a participle in notes without articles: "pedestrian hit by front left corner"."""
    bare = not any(words[c].dep in ("aux", "auxpass", "dobj") for c in verb.children)
    by = words[verb.i + 1] if verb.i + 1 < len(words) else verb
    if verb.norm in HIT and verb.tag in ("VBD", "VBN") and by.norm == "by" and by.head == verb.i and bare:
        verb.tag, by.dep = "VBN", "agent"
        for child in verb.children:
            words[child].dep = "nsubjpass" if words[child].dep == "nsubj" else words[child].dep


def before_its_clause(words: list[Word], verb: Word) -> None:
    """Hang a participle that stands before the "when" of the clause to which the tree takes it on the main verb: "stood
    there, letting a man cross, when a van hit it"."""
    clause = words[verb.head]
    if verb.tag != "VBG" or verb.dep != "advcl" or clause.dep != "advcl" or not verb.i < clause.i:
        return
    main = words[clause.head]
    marks = [c for c in clause.children if words[c].norm == "when" and verb.i < c < clause.i]
    if marks and main.i < verb.i and words[verb.i - 1].norm == ",":
        hang(words, verb, main)
