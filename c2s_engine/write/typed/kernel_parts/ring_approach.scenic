def ring_approach(ego_way, angle):
    """A lane into the roundabout of `ego_way` whose arm is turned by `angle` (degrees, anticlockwise) to ego's."""
    def heading(lane):
        last = lane.centerline[-1] - lane.centerline[-2]
        return math.degrees(math.atan2(-last.x, last.y))
    ring = ego_way.endLane
    for i in range(8):
        others = [lane for lane in ring.maneuvers[0].intersection.incomingLanes if lane.group is not ring.group]
        for lane in others:
            if abs((heading(lane) - heading(ego_way.startLane) - angle + 180) % 360 - 180) < 50:
                return lane
        ring = min((m.endLane for m in ring.maneuvers), key=lambda lane: lane.centerline.length)
