# component: E
# description: Ego goes straight over the intersection, ready to brake for vehicles that cross within 20 metres.
# paraphrases:
#   - defensive crossing of the junction
#   - my car crosses the junction and brakes if somebody comes from the side
#   - careful when driving straight over the crossroads
# actions: [go_straight]
# reactions: [brake]
# hosts: [R/intersection_four_way]
# ---
SAFETY_DISTANCE = 20

behavior EgoCrossesDefensively(path, speed):
    try:
        do FollowTrajectoryBehavior(target_speed=speed, trajectory=path)
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyCars(self, SAFETY_DISTANCE) and (self in network.intersectionRegion):
        take SetBrakeAction(1.0), SetThrottleAction(0)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoCrossesDefensively(egoPath, 8)
