def along(lane, spot):
    """How far along a lane (m) the point nearest to a spot lies."""
    return min(range(int(lane.centerline.length)), key=lambda s: distance from spot to lane.centerline.pointAlongBy(s))
