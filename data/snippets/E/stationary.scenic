# component: E
# description: Ego stands still for the whole run.
# paraphrases:
#   - the vehicle under test does not move
#   - parked test car with the brake on
#   - my car stands still all the time
# actions: [stationary]
# ---
behavior EgoStands():
    while True:
        take SetBrakeAction(1), SetHandBrakeAction(True)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoStands()
