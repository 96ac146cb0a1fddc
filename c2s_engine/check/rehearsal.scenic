# What a check does after `model`, in short: run once in each snapshot to learn which memory a check writes on.
speed = 7
gap = Range(5, 8)
lanes = filter(lambda l: l.centerline.length > 10, network.lanes)
sections = filter(lambda s: s.centerline.length > 10 and not s.road is None, network.laneSections)
crossings = filter(lambda i: i.is4Way or i.is3Way or i.isSignalized, network.intersections)
turns = [m for i in crossings for m in i.maneuvers if m.type and m.startLane and m.connectingLane and m.endLane]
start = new OrientedPoint on Uniform(*lanes).centerline
behavior Rehearsal(speed, near):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyObjs(self, near):
        take SetThrottleAction(0), SetBrakeAction(1.0)

ego = new Car at start,
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior Rehearsal(speed, gap)

lead = new Car following roadDirection from ego for Range(15, 30),
    with behavior Rehearsal(speed, Range(3, 5))

walker = new Pedestrian right of ego by 6,
    with regionContainedIn None

cone = new Cone ahead of lead by Range(8, 12),
    with regionContainedIn None

require (distance from ego to lead) < 60
terminate when (distance from ego to lead) > 100
terminate after 20 seconds
