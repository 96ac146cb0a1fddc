# component: O
# description: A car stands ahead of ego for three seconds and then moves off.
# paraphrases:
#   - a vehicle waiting in front sets off
#   - departing leader
#   - the waiting car in front gets going
# positions: [ahead]
# actions: [wait, start]
# types: [car]
# ---
behavior LeadWaitsAndGoes(pause, speed):
    do LeadHeld() for pause seconds
    do FollowLaneBehavior(target_speed=speed)

behavior LeadHeld():
    while True:
        take SetBrakeAction(1), SetThrottleAction(0)

lead = new Car ahead of ego by 20, with behavior LeadWaitsAndGoes(3, 7)
