def approach(ego_way, angle, turn, outer=False):
    """A lane that reaches the junction of `ego_way` turned by `angle` (degrees, anticlockwise) to ego's, for `turn`: of
    several one from where that leads over ego's way or onto its lane, with another to its left where `outer`."""
    def heading(lane):
        last = lane.centerline[-1] - lane.centerline[-2]
        return math.degrees(math.atan2(-last.x, last.y))
    def meets(lane):
        m = next(m for m in lane.maneuvers if m.type is turn)
        across = m.connectingLane.centerline.lineString.crosses(ego_way.connectingLane.centerline.lineString)
        return across or m.endLane is ego_way.endLane, outer and bool(lane.sections[-1]._fasterLane)
    fitting = []
    for lane in ego_way.intersection.incomingLanes:
        off = (heading(lane) - heading(ego_way.startLane) - angle + 180) % 360 - 180
        if abs(off) < 50 and any(m.type is turn for m in lane.maneuvers):
            fitting.append(lane)
    return max(fitting, key=meets, default=None)
