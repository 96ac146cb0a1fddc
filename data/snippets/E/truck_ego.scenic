# component: E
# description: Ego is a heavy truck that keeps its lane at 10 m/s.
# paraphrases:
#   - lorry under test
#   - the subject vehicle is an HGV
#   - my vehicle is a truck
# actions: [keep_lane]
# types: [truck]
# ---
ego = new Truck at egoSpot, facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=10)
