# component: O
# description: A van placed by an offset of 25 metres along ego's heading drives on in its lane.
# paraphrases:
#   - delivery vehicle farther on in the same lane
#   - a van further up the road
#   - a delivery van drives ahead of me
# positions: [ahead]
# actions: [keep_lane]
# types: [van]
# ---
van = new Van at egoSpot offset by (0, 25), facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=7)
