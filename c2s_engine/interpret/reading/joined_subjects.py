"""Subjects that the tree gives to another word: two who met ("a Ford and a Mazda collided"), and who does something
while doing another thing ("when a cyclist riding on the right swerved")."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

HIT = frozenset(("hit", "struck", "clipped", "rammed", "rear-ended", "killed", "injured", "overtaken"))


def restore_joined_subject(words: list[Word], verb: Word) -> None:
    """Give a verb the subject that is its own."""
    mark_passive_participle(words, verb)


def mark_passive_participle(words: list[Word], verb: Word) -> None:
    """Make a form before "by" a participle in notes without articles: "pedestrian hit by front left corner"."""
    bare = not any(words[c].dep in ("aux", "auxpass", "dobj") for c in verb.children)
    by = words[verb.i + 1] if verb.i + 1 < len(words) else verb
    if verb.norm in HIT and verb.tag in ("VBD", "VBN") and by.norm == "by" and by.head == verb.i and bare:
        verb.tag, by.dep = "VBN", "agent"
        for child in verb.children:
            words[child].dep = "nsubjpass" if words[child].dep == "nsubj" else words[child].dep
