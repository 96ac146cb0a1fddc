# component: T
# description: A monitor ends the run as soon as ego is no longer on the road.
# paraphrases:
#   - abort when the car departs from the carriageway
#   - end when my car goes off the road
#   - over when it runs off the roadway
# conditions: [action]
# ---
monitor EndsOffRoad():
    while ego in roadOrShoulder:
        wait
    terminate

require monitor EndsOffRoad()
