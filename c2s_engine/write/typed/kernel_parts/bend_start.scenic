def bend_start(lane):
    """How far along a lane (m) its bend begins."""
    points = lane.centerline.pointsSeparatedBy(5)
    first = points[1] - points[0]
    turned = [k for k in range(1, len(points)) if abs(first.angleWith(points[k] - points[k - 1])) > 0.06]
    return 5 * turned[0] if turned else 0
