"""The phrases of a text, and the text without each: read anew, it says whether the phrase makes any difference."""

import re
from collections.abc import Iterable
from typing import Any

from c2s_engine.interpret.reading.syntax import parser

Span = tuple[int, int]
MODIFIES = frozenset(
    ("prep", "advmod", "npadvmod", "amod", "nummod", "acl", "advcl", "relcl", "appos", "conj", "agent")
)
"""Grammatical relations of what a sentence can do without."""


def without_each(text: str, clauses: Iterable[Span] = ()) -> list[tuple[Span, str]]:
    """Spans of the text, longer ones first, each with the text that is left without it; those of its `clauses`, too."""
    doc = parser()(text)
    found = {(s.start_char, s.end_char) for s in doc.sents}
    found |= {_span(token) for token in doc if token.dep_ in MODIFIES and _says_something(token.subtree)}
    found |= {(p.start_char, p.end_char) for s in doc.sents for p in _parts(s) if _says_something(p)}  # of notes, too
    found |= {(a, a + len(text[a:b].rstrip(" .,;"))) for a, b in clauses}
    longest = sorted(found, key=lambda span: (span[0] - span[1], span))
    return [(span, rest) for span in longest if (rest := _without(text, span)).strip(" .,;")]


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


def _without(text: str, span: Span) -> str:
    before, after = text[: span[0]].rstrip(" ,"), text[span[1] :].lstrip()
    return re.sub(r" (?=[.,;:!?])", "", f"{before} {after}").strip()
