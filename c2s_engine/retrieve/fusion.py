"""Reciprocal rank fusion of several rankings."""

from collections.abc import Mapping, Sequence

K = 60


def fuse(rankings: Mapping[str, Sequence[int]], weights: Mapping[str, float] | None = None) -> list[tuple[int, float]]:
    """Items by their sum of weight / (60 + rank) over the rankings (best first; ties in the order of appearance)."""
    scores: dict[int, float] = {}
    for name, ranking in rankings.items():
        weight = (weights or {}).get(name, 1.0)
        for rank, item in enumerate(ranking, 1):
            scores[item] = scores.get(item, 0.0) + weight / (K + rank)
    return sorted(scores.items(), key=lambda pair: -pair[1])
