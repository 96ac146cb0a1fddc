# component: O
# description: A van ahead drifts to the right edge of the road and off it.
# paraphrases:
#   - drowsy driver runs off the carriageway
#   - road departure of the vehicle in front
#   - the driver in front falls asleep and runs off the road
# positions: [ahead]
# actions: [drift, leave_road]
# types: [van]
# ---
behavior DriftsOff(speed, after):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when simulation().currentTime * 0.1 > after:
        take SetSteerAction(0.04), SetThrottleAction(0.3)

sleepy = new Van ahead of ego by 18, with behavior DriftsOff(8, 2)
