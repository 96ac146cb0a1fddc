def amid(points, others, turn):
    """Where a car on `points` runs into one that is halfway through its `turn` on `others`, or, if that is later or too
    far off, where they first meet, and a little further there."""
    spot, bend = meeting(points, others), turn.connectingLane.centerline
    half = bend.pointAlongBy(bend.length / 2)
    first, then = (min(range(len(others)), key=lambda k: (distance from others[k] to one)) for one in (spot, half))
    if first >= then - 1:
        return others[first + 1]
    return half if min((distance from p to half) for p in points) < 5 else spot
