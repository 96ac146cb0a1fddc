# component: E
# description: Ego backs up along its lane.
# paraphrases:
#   - the test vehicle goes backwards
#   - reversing manoeuvre
#   - drive backwards
# actions: [reverse]
# ---
behavior EgoBacksUp():
    while True:
        take SetReverseAction(True), SetThrottleAction(0.3)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoBacksUp()
