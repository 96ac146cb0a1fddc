# component: O
# description: The car ahead of ego turns left at the junction and slows down for it.
# paraphrases:
#   - leader turns off to the left
#   - the car in front turns left
# positions: [ahead]
# actions: [turn_left]
# types: [car]
# hosts: [R/intersection_left_turn]
# ---
behavior LeadTurnsOff(path, speed):
    do FollowTrajectoryBehavior(target_speed=speed, turn_speed=speed / 2, trajectory=path)
    do FollowLaneBehavior(target_speed=speed)

leftLead = new Car ahead of ego by 7, with behavior LeadTurnsOff(egoPath, 7)
