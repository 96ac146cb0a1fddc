# component: E
# description: 'Ego loses control for a moment: random steering for a second, then it recovers its lane.'
# paraphrases:
#   - skid on a slippery patch
#   - the car breaks away and is caught again
#   - slide and catch the car
# actions: [lose_control]
# ---
behavior EgoSkids(speed):
    do FollowLaneBehavior(target_speed=speed) for 3 seconds
    for i in range(5):
        take SetSteerAction(-0.3)
    for i in range(5):
        take SetSteerAction(0.3)
    do FollowLaneBehavior(target_speed=speed)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoSkids(10)
