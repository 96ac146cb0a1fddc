# component: O
# description: A lorry stands in the lane with its handbrake on.
# paraphrases:
#   - stopped heavy vehicle ahead
#   - an immobile truck in my way
#   - a truck stands still in front of me
# positions: [ahead]
# actions: [stationary]
# types: [truck]
# ---
behavior StandsBraked():
    while True:
        take SetHandBrakeAction(True), SetBrakeAction(1)

lorry = new Truck ahead of ego by 35, with behavior StandsBraked()
