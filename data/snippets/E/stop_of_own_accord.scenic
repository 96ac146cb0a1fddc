# component: E
# description: Ego brakes to a standstill after four seconds and stays there.
# paraphrases:
#   - come to a halt without a cause
#   - 'minimum risk manoeuvre: stop in lane'
#   - my car comes to a stop for no reason
# actions: [stop]
# ---
behavior EgoComesToStand(speed):
    do FollowLaneBehavior(target_speed=speed) for 4 seconds
    while True:
        take SetThrottleAction(0), SetBrakeAction(0.5)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoComesToStand(9)
