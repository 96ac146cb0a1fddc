"""Ranking metrics over graded relevance."""

import math
from collections.abc import Sequence


def hit(grades: Sequence[int], k: int) -> float:
    """1 where one of the first k results is graded 2 or 3."""
    return float(any(g >= 2 for g in grades[:k]))


def recall(grades: Sequence[int], wanted: int, k: int) -> float:
    """The share of the relevant items that are among the first k results (never more than k of them can be)."""
    return sum(1 for g in grades[:k] if g > 0) / min(wanted, k) if wanted else 0.0


def reciprocal(grades: Sequence[int]) -> float:
    """1 / rank of the first result that is graded 2 or 3."""
    return next((1.0 / rank for rank, g in enumerate(grades, 1) if g >= 2), 0.0)


def ndcg(grades: Sequence[int], ideal: Sequence[int], k: int) -> float:
    """Discounted gain (2^grade - 1) of the first k results over the best possible."""

    def gain(values: Sequence[int]) -> float:
        return sum((2**g - 1) / math.log2(rank + 1) for rank, g in enumerate(values[:k], 1))

    best = gain(sorted(ideal, reverse=True))
    return gain(grades) / best if best else 0.0


def f1(true: int, predicted: int, actual: int) -> float:
    """The harmonic mean of precision and recall from counts."""
    return 2 * true / (predicted + actual) if predicted + actual else 0.0
