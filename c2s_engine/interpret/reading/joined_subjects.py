"""Subjects that the tree gives to another word: two who met ("a Ford and a Mazda collided"), and who does something
while doing another thing ("when a cyclist riding on the right swerved")."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

HIT = frozenset(("hit", "struck", "clipped", "rammed", "rear-ended", "killed", "injured", "overtaken"))
SUBJECTS = ("nsubj", "nsubjpass", "aux", "auxpass", "expl")


def own_subject(words: list[Word], verb: Word) -> None:
    """Give a verb the subject that is its own."""
    share_participle(words, verb)
    suffer(words, verb)
    before_its_clause(words, verb)


def share_participle(words: list[Word], verb: Word) -> None:
    """Give a past form the noun that the tree has as the subject of the participle between them."""
    if verb.tag not in ("VBD", "VBN") or any(words[c].dep in SUBJECTS for c in verb.children):
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
