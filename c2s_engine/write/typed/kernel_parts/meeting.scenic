def meeting(points, others):
    """The spot of `points` that lies nearest to `others`: where both ways meet."""
    return min(points[::3], key=lambda p: min((p.x - q.x) ** 2 + (p.y - q.y) ** 2 for q in others[::3]))
