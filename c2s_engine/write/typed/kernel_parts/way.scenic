def way(lane, turn=ManeuverType.STRAIGHT):
    """Points 2 m apart along a lane and on over the next junctions: by `turn` (a manoeuvre or its type) at the
    first, then straight on."""
    points = []
    for _ in range(3):
        points += lane.centerline.pointsSeparatedBy(2)
        onward = [m for m in lane.maneuvers if turn in (m, m.type)]
        onward = onward or [m for l in lane.group.lanes for m in l.maneuvers if m.type is turn] or list(lane.maneuvers)
        if not onward:
            break
        if onward[0].connectingLane:
            points += onward[0].connectingLane.centerline.pointsSeparatedBy(2)
        lane, turn = onward[0].endLane, ManeuverType.STRAIGHT
    return points
