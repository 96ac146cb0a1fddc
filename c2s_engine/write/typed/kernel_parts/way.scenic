def begin(lane):
    """The direction in which a lane begins."""
    return lane.centerline[1] - lane.centerline[0]

def way(lane, turn=ManeuverType.STRAIGHT, bearing=0):
    """Points 2 m apart along a lane and on over the next junctions: by `turn` (a manoeuvre or its type) at the first,
    then straight on, or where that is not possible nearest to `bearing` (rad, to the left) from the first lane."""
    points, goal = lane.centerline.pointsSeparatedBy(2), (lane.centerline[-1] - lane.centerline[-2]).rotatedBy(bearing)
    enough = len(points) + 400
    while len(points) < enough:
        onward = [m for m in lane.maneuvers if turn in (m, m.type)]
        onward = onward or [m for l in lane.group.lanes for m in l.maneuvers if m.type is turn]
        onward = onward or sorted(lane.maneuvers, key=lambda m: abs(goal.angleWith(begin(m.endLane))))
        if not onward:
            break
        if onward[0].connectingLane:
            points += onward[0].connectingLane.centerline.pointsSeparatedBy(2)
        lane, turn = onward[0].endLane, ManeuverType.STRAIGHT
        points += lane.centerline.pointsSeparatedBy(2)
    return points
