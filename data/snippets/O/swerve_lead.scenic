# component: O
# description: The car ahead swerves once within its lane and settles again.
# paraphrases:
#   - leader weaves sideways
#   - unsteady vehicle in front
#   - a drunk driver in front wobbles from side to side
# positions: [ahead]
# actions: [swerve]
# types: [car]
# ---
behavior SwervesOnce(speed):
    do FollowLaneBehavior(target_speed=speed) for 2 seconds
    for i in range(5):
        take SetSteerAction(0.2)
    for i in range(5):
        take SetSteerAction(-0.2)
    do FollowLaneBehavior(target_speed=speed)

lead = new Car ahead of ego by 15, with behavior SwervesOnce(9)
