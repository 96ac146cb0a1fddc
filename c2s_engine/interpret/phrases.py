"""The phrases of a text: what a sentence could do without."""

from collections.abc import Iterable
from typing import Any

from c2s_engine.interpret.parser import parser

Span = tuple[int, int]
MODIFIES = frozenset(
    ("prep", "advmod", "npadvmod", "amod", "nummod", "acl", "advcl", "relcl", "appos", "conj", "agent")
)
"""Grammatical relations of what a sentence can do without."""


def phrases_of(text: str) -> list[Span]:
    """Their spans, longer ones first; what stands between commas and the like is one, too."""
    doc = parser()(text)
    found = {_span(token) for token in doc if token.dep_ in MODIFIES and _says_something(token.subtree)}
    found |= {(p.start_char, p.end_char) for s in doc.sents for p in _parts(s) if _says_something(p)}  # of notes, too
    return sorted(found, key=lambda span: (span[0] - span[1], span))


def _span(token: Any) -> Span:
    words = list(token.subtree)
    first = words[0].idx
    if token.dep_ == "conj":  # with the "and" before it
        first = min([first, *(c.idx for c in token.head.children if c.dep_ == "cc" and c.i < token.i)])
    return first, words[-1].idx + len(words[-1].text)


def _parts(sentence: Any) -> list[Any]:
    """What stands between the commas and the like of a sentence."""
    marks = [t.i - sentence.start for t in sentence if t.is_punct and t.text not in "'’\"-/"]
    edges = zip([-1, *marks], [*marks, len(sentence)], strict=True)
    return [sentence[a + 1 : b] for a, b in edges if b > a + 1]


def _says_something(tokens: Iterable[Any]) -> bool:
    words = [w for w in tokens if w.is_alpha or w.like_num]
    return any((not w.is_stop or w.like_num) and w.lower_ != "ego" for w in words)
