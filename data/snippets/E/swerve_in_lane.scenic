# component: E
# description: Ego weaves once to the left and back while it drives.
# paraphrases:
#   - short lateral excursion of the test car
#   - my car wobbles to one side and straightens up
#   - a short sway to the left and back
# actions: [swerve]
# ---
behavior EgoWeaves(speed, steer):
    do FollowLaneBehavior(target_speed=speed) for 2 seconds
    do EgoSteersFor(-steer) for 0.5 seconds
    do EgoSteersFor(steer) for 0.5 seconds
    do FollowLaneBehavior(target_speed=speed)

behavior EgoSteersFor(steer):
    while True:
        take SetSteerAction(steer), SetThrottleAction(0.3)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoWeaves(8, 0.2)
