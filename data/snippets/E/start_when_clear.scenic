# component: E
# description: Ego waits until no vehicle is within 15 metres and then sets off.
# paraphrases:
#   - pull away when the coast is clear
#   - my car waits for traffic to pass and then moves off
#   - pull out once nobody is near
# actions: [wait, start]
# ---
behavior EgoStartsWhenClear(speed):
    while withinDistanceToAnyCars(self, 15):
        take SetBrakeAction(1)
    take SetBrakeAction(0)
    do FollowLaneBehavior(target_speed=speed)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoStartsWhenClear(9)
