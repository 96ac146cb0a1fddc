# component: O
# description: A car ahead of ego backs up towards it.
# paraphrases:
#   - vehicle in front rolls backwards
#   - reversing leader
#   - the car in front backs up towards me
# positions: [ahead]
# actions: [reverse]
# types: [car]
# ---
behavior BacksUp(throttle):
    while True:
        take SetReverseAction(True), SetThrottleAction(throttle), SetBrakeAction(0)

backing = new Car ahead of ego by 25, with behavior BacksUp(0.3)
