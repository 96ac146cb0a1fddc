"""When there is no answer: the best hit is neither near in meaning nor does it hold the query's rare words.

The thresholds were fitted on the development half of benchmark/retrieval (`make bench-retrieval` prints both halves).
"""

from dataclasses import dataclass

from c2s_engine.retrieve.rows import Kind


@dataclass(frozen=True)
class Threshold:
    """An answer needs `cosine` of the nearest plus `weight` times the covered share of the query to reach `least`."""

    least: float
    weight: float


THRESHOLDS: dict[Kind, Threshold] = {"doc": Threshold(0.38, 0.1), "snippet": Threshold(0.38, 0.0)}


def answerable(kind: Kind, cosine: float, coverage: float) -> bool:
    """Whether the best hits of a query are good enough to be shown as its answer.

    `cosine`: of the nearest row; `coverage`: the share of the query's idf that the best lexical hit holds."""
    threshold = THRESHOLDS[kind]
    return cosine + threshold.weight * coverage >= threshold.least
