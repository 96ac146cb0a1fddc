"""The dual retriever over one shelf: embedding alone, BM25 alone, or both fused."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from c2s_engine.retrieve.abstain import COSINE, answerable
from c2s_engine.retrieve.fusion import fuse
from c2s_engine.retrieve.rows import Kind
from c2s_engine.retrieve.store import Shelf
from c2s_engine.retrieve.terms import agreement
from c2s_engine.retrieve.tokens import tokenise

Method = Literal["embedding", "bm25", "fused"]
DEPTH = 50  # items of each list that are fused
WEIGHTS = {"clause": 2.0}
AGREEMENT = 0.5  # what full agreement in the vocabulary's words adds to a cosine
UNKNOWN = 0.5  # the agreement of a near snippet of which no words are known (a user's own)
CLAUSE = re.compile(r"(?<![\w.])\d{1,2}(?:\.\d{1,3}){1,6}(?![\w])")


@dataclass
class Hit:
    """An item that was found: the row that stands for it, its cosine, and its rank in each list."""

    row: int
    item: str
    score: float
    cosine: float
    ranks: dict[str, int] = field(default_factory=dict)


@dataclass
class Found:
    """The hits, best first, and whether they are good enough to be an answer."""

    hits: list[Hit]
    answerable: bool
    cosine: float
    coverage: float


def retrieve(
    shelf: Shelf, kind: Kind, query: str, vector: np.ndarray, method: Method, limit: int, component: str | None = None,
    terms: Sequence[str] = (),
) -> Found:  # fmt: skip
    """The best items of a shelf for a query with its vector (filtered by component, where one is named).

    `terms`: the words of the vocabulary that the items are to be about; what is about others is left out."""
    if not len(shelf):
        return Found([], False, 0.0, 0.0)
    allowed = shelf.components == component if component else None
    cosines = shelf.vectors @ vector
    agreed = _agreed(shelf, component, terms, cosines) if component and terms else None
    value = cosines
    if agreed is not None:  # rows of other components have none
        allowed, value = agreed > 0, cosines + AGREEMENT * agreed
    near = np.where(allowed, value, -2.0) if allowed is not None else value
    by_meaning = _best(shelf, near, np.arange(len(shelf)), near, DEPTH)
    tokens = tokenise(query)
    documents, scores = shelf.postings.scores(tokens)
    documents = shelf.lexical_rows[documents]
    if allowed is not None:
        kept = allowed[documents]
        documents, scores = documents[kept], scores[kept]
    by_words = _best(shelf, scores, documents, None, DEPTH)
    rankings = {"embedding": [r for r, _ in by_meaning], "bm25": [r for r, _ in by_words]}
    ranks: dict[str, dict[str, int]] = {}
    standing: dict[str, int] = {}
    for name, rows in rankings.items():
        for rank, row in enumerate(rows, 1):
            ranks.setdefault(shelf.items[row], {})[name] = rank
            standing.setdefault(shelf.items[row], row)
    for rank, row in enumerate(_by_clause(shelf, query), 1):
        ranks.setdefault(shelf.items[row], {})["clause"] = rank
        standing.setdefault(shelf.items[row], row)
    number = {item: i for i, item in enumerate(standing)}
    lists = {name: [number[shelf.items[r]] for r in rows] for name, rows in rankings.items()}
    named = sorted((i for i in ranks if "clause" in ranks[i]), key=lambda i: ranks[i]["clause"])
    fused: dict[str, list[int]] = {**lists, "clause": [number[i] for i in named]}
    used = fused if method == "fused" else {str(method): lists[method]}
    items = list(standing)
    hits = []
    for index, score in fuse(used, WEIGHTS)[:limit]:
        row = standing[items[index]]
        hits.append(Hit(row, items[index], score, float(cosines[row]), ranks[items[index]]))
    cosine = float(cosines[by_meaning[0][0]]) if by_meaning else 0.0
    covered = _coverage(shelf, tokens, [row for row, _ in by_words[:5]])
    fits = agreed is not None or answerable(kind, cosine, covered)
    return Found(hits, bool(hits) and fits, cosine, covered)


def _agreed(shelf: Shelf, component: str, terms: Sequence[str], cosines: np.ndarray) -> np.ndarray | None:
    """How far each row is about these words, 0 to 1; None where no row of the component is."""
    found = np.zeros(len(shelf))
    for row in np.flatnonzero(shelf.components == component):
        agreed = agreement(component, terms, shelf.terms[row])
        found[row] = UNKNOWN * (cosines[row] >= COSINE["snippet"]) if agreed is None else agreed
    return found if found.any() else None


def _by_clause(shelf: Shelf, query: str) -> list[int]:
    """The rows of the very clause that a query names: nobody who writes 5.2.5.2 means its neighbours."""
    wanted = set(CLAUSE.findall(query))
    if not wanted:
        return []
    rows = [row for row in shelf.lexical_rows if wanted & set(CLAUSE.findall(shelf.clauses[row]))]
    return [int(row) for row in rows[:10]]


def _best(
    shelf: Shelf, scores: np.ndarray, rows: np.ndarray, mask: np.ndarray | None, depth: int
) -> list[tuple[int, float]]:
    """The best rows, one an item: its best row stands for it. Ties go to the earlier row."""
    wanted = min(len(rows), depth * 6)
    if wanted == 0:
        return []
    part = np.argpartition(-scores, wanted - 1)[:wanted] if wanted < len(rows) else np.arange(len(rows))
    part = part[np.lexsort((rows[part], -scores[part]))]
    found: list[tuple[int, float]] = []
    seen: set[str] = set()
    for i in part:
        if mask is not None and mask[i] <= -2.0:
            break
        row = int(rows[i])
        if shelf.items[row] not in seen:
            seen.add(shelf.items[row])
            found.append((row, float(scores[i])))
            if len(found) == depth:
                break
    return found


def _coverage(shelf: Shelf, terms: list[str], rows: list[int]) -> float:
    """The largest share of the query's idf that one of these rows holds."""
    rarity = {t: max(shelf.postings.rarity(t), 0.0) for t in set(terms)}
    total = sum(rarity.values())
    if not total or not rows:
        return 0.0
    best = 0.0
    for row in rows:
        record = shelf.table.slice(row, 1)
        held = set(tokenise(record.column("lexical")[0].as_py()))
        best = max(best, sum(r for t, r in rarity.items() if t in held) / total)
    return best
