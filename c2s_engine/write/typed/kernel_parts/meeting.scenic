def meeting(points, others):
    """The spot of `points` where they first come to `others` (further on, over other junctions, they may meet again)."""
    away = [min((p.x - q.x) ** 2 + (p.y - q.y) ** 2 for q in others) for p in points[::2]]
    first = next((k for k, d in enumerate(away) if d < 6), away.index(min(away)))
    return points[2 * min(range(first, min(first + 4, len(away))), key=lambda k: away[k])]
