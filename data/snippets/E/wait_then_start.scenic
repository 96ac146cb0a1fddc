# component: E
# description: Ego stands for three seconds and then moves off.
# paraphrases:
#   - delayed departure from standstill
#   - starts after a pause
#   - stand for a while, then get going
# actions: [wait, start]
# ---
behavior EgoMovesOff(delay, speed):
    do EgoHeldByBrake() for delay seconds
    do FollowLaneBehavior(target_speed=speed)

behavior EgoHeldByBrake():
    while True:
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoMovesOff(3, 8)
