def approach(ego_way, angle, turn):
    """A lane that reaches the junction of `ego_way` turned by `angle` (degrees, anticlockwise) to ego's, for `turn`."""
    def heading(lane):
        last = lane.centerline[-1] - lane.centerline[-2]
        return math.degrees(math.atan2(-last.x, last.y))
    for lane in ego_way.intersection.incomingLanes:
        off = (heading(lane) - heading(ego_way.startLane) - angle + 180) % 360 - 180
        if abs(off) < 50 and any(m.type is turn for m in lane.maneuvers):
            return lane
