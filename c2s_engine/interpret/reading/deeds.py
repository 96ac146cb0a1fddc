"""What road users do, hung on who does it where the tree has it otherwise: participles behind them and their place
("a van behind ego overtaking ego"), and what they are let or made to do."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word


def hang(words: list[Word], doing: list[tuple[int, int]], made: list[tuple[int, int]]) -> None:
    """Hang what road users do (as a participle, or after "let") on who does it, where a tree remains."""
    for change, pairs in ((_participle, doing), (_subject, made)):
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
    if actor.head == verb.i and actor.dep.startswith("nsubj") or verb.head == actor.i:
        return
    noun = words[actor.head] if actor.dep in ("compound", "nmod", "amod") and actor.head > actor.i else None
    if noun is not None:  # "a [van overtaking] ego": the one further on was taken for the noun that both qualify
        actor.head, actor.dep = (actor.i if noun.head == noun.i else noun.head), noun.dep
        for child in [c for c in noun.children if c < actor.i]:
            words[child].head = actor.i
        noun.head, noun.dep = (verb.i, "dobj") if noun is not verb else (noun.head, noun.dep)
    verb.head, verb.dep = actor.i, "acl"
    for subject in [words[c] for c in verb.children if words[c].dep.startswith("nsubj")]:
        subject.dep = "dep"


def _subject(words: list[Word], who: int, doing: int) -> None:
    """Make a road user the subject of what it is let or made to do: "have a van brake"."""
    actor, verb = words[who], words[doing]
    verb.tag = "VB"
    if actor.head == verb.i and actor.dep.startswith("nsubj"):
        return
    above = words[actor.head]
    if verb.head != verb.i and above.i < actor.i and above.verb:
        verb.head, verb.dep = above.i, "ccomp"
    actor.head, actor.dep = verb.i, "nsubj"


def hold_children(words: list[Word], sentence: list[Word]) -> None:
    """Note with each word of a sentence which others hang on it."""
    for word in sentence:
        word.children.clear()
    for word in sentence:
        if word.head != word.i:
            words[word.head].children.append(word.i)
