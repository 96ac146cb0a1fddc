"""When there is no answer: the best hit is neither near in meaning nor does it hold nearly all the query's rare words.

The cosines were fitted on the development half of benchmark/retrieval (`make bench-retrieval` prints both halves).
"""

from c2s_engine.retrieve.rows import Kind

COSINE: dict[Kind, float] = {"doc": 0.40, "snippet": 0.32}
COVERAGE = 0.9


def answerable(kind: Kind, cosine: float, coverage: float) -> bool:
    """Whether the best hits of a query are good enough to be shown as its answer.

    `cosine`: of the nearest row; `coverage`: the share of the query's idf that the best lexical hit holds."""
    return cosine >= COSINE[kind] or coverage >= COVERAGE
