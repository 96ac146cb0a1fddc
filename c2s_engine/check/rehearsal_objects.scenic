# The second part of rehearsal.scenic: what makes objects and requires things of them.
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
