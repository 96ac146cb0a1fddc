# component: E
# description: Ego stops before the intersection, waits while any vehicle is near, and then crosses.
# paraphrases:
#   - give way to cross traffic
#   - let the others go first
#   - let the others go first at the junction
# actions: [yield]
# reactions: [yield]
# hosts: [R/intersection_four_way]
# ---
behavior EgoYields(path):
    do FollowLaneBehavior(target_speed=7) until (distance from self to egoLane.centerline[-1]) < 12
    while self.speed > 0.2:
        take SetThrottleAction(0), SetBrakeAction(0.7)
    while withinDistanceToAnyCars(self, 25):
        take SetThrottleAction(0), SetBrakeAction(1)
    do FollowTrajectoryBehavior(target_speed=7, trajectory=path)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoYields(egoPath)
