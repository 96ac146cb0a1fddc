"""BM25 with the scores of rank-bm25's BM25Okapi, but only documents that hold a term of the query are scored."""

import math
from array import array
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

K1, B, EPSILON = 1.5, 0.75, 0.25
Counts = dict[str, int]


class Postings:
    """An inverted index: for each term the documents that hold it, with the term's finished weight in each."""

    def __init__(
        self, terms: list[str], starts: np.ndarray, documents: np.ndarray, counts: np.ndarray, lengths: np.ndarray
    ):
        self.terms, self.starts, self.documents, self.counts, self.lengths = terms, starts, documents, counts, lengths
        self.number = {term: i for i, term in enumerate(terms)}
        self.size = len(lengths)
        self.idf = _idf(self.size, np.diff(starts))
        mean = float(lengths.mean()) if self.size else 1.0
        damped = counts + K1 * (1 - B + B * lengths[documents] / (mean or 1.0))
        self._weights = (counts * (K1 + 1) / damped).astype(np.float32)

    @classmethod
    def build(cls, documents: Iterable[Sequence[str]]) -> "Postings":
        """The index of token lists."""
        return cls.from_counts(Counter(tokens) for tokens in documents)

    @classmethod
    def from_counts(cls, documents: Iterable[Counts]) -> "Postings":
        """The index of documents given as their terms' counts."""
        number: dict[str, int] = {}
        term_ids, doc_ids, counts, lengths = array("i"), array("i"), array("i"), array("i")
        for i, document in enumerate(documents):
            for term, count in document.items():
                term_ids.append(number.setdefault(term, len(number)))
                doc_ids.append(i)
                counts.append(count)
            lengths.append(sum(document.values()))
        terms, docs, times = (np.asarray(a, np.int32) for a in (term_ids, doc_ids, counts))
        order = np.argsort(terms, kind="stable")
        starts = np.zeros(len(number) + 1, np.int64)
        np.cumsum(np.bincount(terms, minlength=len(number)), out=starts[1:])
        return cls(list(number), starts, docs[order], times[order], np.asarray(lengths, np.int32))

    def scores(self, query: Iterable[str]) -> tuple[np.ndarray, np.ndarray]:
        """The documents that hold a term of the query, and their scores (a repeated term counts as often)."""
        total = np.zeros(self.size, np.float32)
        touched = np.zeros(self.size, bool)
        for term, times in Counter(query).items():
            i = self.number.get(term)
            if i is None:
                continue
            part = slice(self.starts[i], self.starts[i + 1])
            documents = self.documents[part]
            total[documents] += np.float32(times * self.idf[i]) * self._weights[part]
            touched[documents] = True
        found = np.flatnonzero(touched)
        return found, total[found]

    def rarity(self, term: str) -> float:
        """How much a term tells apart (its idf); a term that no document holds: as if one did."""
        i = self.number.get(term)
        if i is not None:
            return float(self.idf[i])
        return math.log(max(self.size, 1) + 0.5) - math.log(0.5)

    def save(self, path: Path) -> None:
        """Write the index to one file."""
        vocabulary = np.frombuffer("\n".join(self.terms).encode(), np.uint8)
        with path.open("wb") as file:
            np.savez(file, terms=vocabulary, starts=self.starts, documents=self.documents, counts=self.counts,
                     lengths=self.lengths)  # fmt: skip

    @classmethod
    def load(cls, path: Path) -> "Postings":
        """Read what `save` wrote; raises OSError or ValueError where the file is not whole."""
        with np.load(path, allow_pickle=False) as data:
            text = data["terms"].tobytes().decode()
            return cls(
                text.split("\n") if text else [], data["starts"], data["documents"], data["counts"], data["lengths"]
            )


def _idf(size: int, frequencies: np.ndarray) -> np.ndarray:
    """rank-bm25's idf: terms in over half of the documents get a quarter of the mean instead of a negative value."""
    if not len(frequencies):
        return np.zeros(0)
    idf = np.log(size - frequencies + 0.5) - np.log(frequencies + 0.5)
    return np.where(idf < 0, EPSILON * idf.mean(), idf)
