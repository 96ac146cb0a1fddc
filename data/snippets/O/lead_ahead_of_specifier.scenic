# component: O
# description: A car starts 15 metres in front of ego's bumper and keeps its lane.
# paraphrases:
#   - somebody directly before the test vehicle
#   - another car a few metres in front of mine
# positions: [ahead]
# actions: [keep_lane]
# types: [car]
# ---
lead = new Car ahead of ego by 15,
    with behavior FollowLaneBehavior(target_speed=Range(5, 9))
