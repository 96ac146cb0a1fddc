# component: O
# description: The car ahead loses control for a moment and slips sideways before it recovers.
# paraphrases:
#   - skidding leader
#   - vehicle in front breaks away on ice
#   - the car in front slides on a slippery road
#   - aquaplaning, a skid
# positions: [ahead]
# actions: [lose_control]
# types: [car]
# ---
behavior LosesControl(speed):
    do FollowLaneBehavior(target_speed=speed) for Range(1, 3) seconds
    do Skids() for 1 seconds
    do FollowLaneBehavior(target_speed=speed)

behavior Skids():
    while True:
        take SetSteerAction(Uniform(-0.3, 0.3)), SetThrottleAction(0.5)

skidder = new Car ahead of ego by 18, with behavior LosesControl(9)
