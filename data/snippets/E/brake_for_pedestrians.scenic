# component: E
# description: Ego stops for pedestrians that come within 15 metres in its view.
# paraphrases:
#   - yield to people on foot by braking
#   - pedestrian emergency braking
#   - my car makes an emergency stop for people on foot
# reactions: [brake]
# ---
behavior EgoStopsForPedestrians(speed, gap):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyPedestrians(self, gap):
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at egoSpot, facing roadDirection,
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoStopsForPedestrians(8, 15)
