# component: E
# description: Ego is a city bus that keeps its lane slowly.
# paraphrases:
#   - public transport vehicle under test
#   - my vehicle is a bus
#   - I drive a city bus
# actions: [keep_lane]
# types: [bus]
# ---
ego = new Bus at egoSpot, facing roadDirection,
    with width 2.6, with length 10,
    with behavior FollowLaneBehavior(target_speed=Range(6, 8))
