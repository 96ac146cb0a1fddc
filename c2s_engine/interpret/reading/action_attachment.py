"""What road users do, hung on who does it where the tree has it otherwise: participles behind them and their place
("a van behind ego overtaking ego"), and what they are let or made to do."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret.reading.tree_edits import under

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word


def attach_actions(
    words: list[Word], doing: list[tuple[int, int]], made: list[tuple[int, int]], named: list[tuple[int, int]]
) -> None:
    """Hang what road users do (a participle, after "let", behind a colon) on who does it, if a tree remains."""
    for change, pairs in ((_participle, doing), (_made, made), (_subject, named)):
        for who, what in pairs:
            sentence = [w for w in words if w.sentence == words[what].sentence]
            before = [(w.head, w.dep) for w in sentence]
            change(words, who, what)
            if any(_circles(words, w) for w in sentence):
                for word, (head, dep) in zip(sentence, before, strict=True):
                    word.head, word.dep = head, dep
            elif before != [(w.head, w.dep) for w in sentence]:
                hold_children(words, sentence)


def _circles(words: list[Word], word: Word) -> bool:
    """Whether the way up from a word comes to no root."""
    for _ in words:
        if word.head == word.i:
            return False
        word = words[word.head]
    return True


def _participle(words: list[Word], who: int, doing: int) -> None:
    """Hang a participle on the road user that it tells of, unless the tree has that one for its subject."""
    actor, verb = words[who], words[doing]
    verb.tag = "VBG"
    if verb.head == actor.i:
        verb.dep = "acl" if verb.dep in ("conj", "advcl") else verb.dep
        return
    if actor.head == verb.i and actor.dep.startswith("nsubj"):
        return
    _unroot(words, actor, verb)
    noun = words[actor.head] if actor.dep in ("compound", "nmod", "amod") and actor.head > actor.i else None
    if noun is not None:  # "a [van overtaking] ego": the one further on was taken for the noun that both qualify
        actor.head, actor.dep = (actor.i if noun.head == noun.i else noun.head), noun.dep
        for child in [c for c in noun.children if c < actor.i]:
            words[child].head = actor.i
        noun.head, noun.dep = (verb.i, "dobj") if noun is not verb else (noun.head, noun.dep)
    verb.head, verb.dep = actor.i, "acl"
    for subject in [words[c] for c in verb.children if words[c].dep.startswith("nsubj")]:
        subject.dep = "dep"


def _unroot(words: list[Word], actor: Word, verb: Word) -> None:
    """Hang who stands before a comma and what is told there where its verb hung, that is none of the clause before."""
    if not any(w.norm == "," for w in words[actor.i : verb.i]) or not under(words, actor, verb):
        return
    actor.head, actor.dep = (actor.i, "ROOT") if verb.head == verb.i else (verb.head, verb.dep)
    for child in [words[c] for c in verb.children if c < verb.i and c != actor.i]:
        child.head = actor.i


def _made(words: list[Word], who: int, doing: int) -> None:
    """Make a road user the subject of what it is let or made to do: "have a van brake"."""
    words[doing].tag = "VB"
    _subject(words, who, doing)


def _subject(words: list[Word], who: int, doing: int) -> None:
    """Make a road user the subject of a verb."""
    actor, verb = words[who], words[doing]
    if actor.head == verb.i and actor.dep.startswith("nsubj"):
        return
    actor.head, actor.dep = verb.i, "nsubj"


def hold_children(words: list[Word], sentence: list[Word]) -> None:
    """Note with each word of a sentence which others hang on it."""
    for word in sentence:
        word.children.clear()
    for word in sentence:
        if word.head != word.i:
            words[word.head].children.append(word.i)
