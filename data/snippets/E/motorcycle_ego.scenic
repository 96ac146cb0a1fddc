# component: E
# description: Ego is a motorcycle that follows its lane and brakes for what is ahead.
# paraphrases:
#   - powered two-wheeler as the host
#   - my vehicle is a motorbike
#   - I ride a motorbike and brake for whoever is in front
# actions: [keep_lane]
# types: [motorcycle]
# ---
behavior RiderBrakes(speed):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when self.distanceToClosest(Vehicle) < 12:
        take SetBrakeAction(1), SetThrottleAction(0)

ego = new Motorcycle at egoSpot, facing roadDirection, with behavior RiderBrakes(9)
