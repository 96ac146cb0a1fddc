# component: O
# description: A car approaches from behind without braking and runs into ego.
# paraphrases:
#   - rear-end crash into the host
#   - inattentive follower hits the back of the car
#   - the car behind crashes into my rear
#   - hit from behind by somebody who does not brake
# positions: [behind]
# actions: [collide]
# types: [car]
# ---
rammer = new Car behind ego by 15,
    with behavior FollowLaneBehavior(target_speed=16)
