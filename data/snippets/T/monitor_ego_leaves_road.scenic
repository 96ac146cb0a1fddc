# component: T
# description: A monitor ends the run as soon as ego is no longer on the road.
# paraphrases:
#   - abort when the car departs from the carriageway
# conditions: [action]
# ---
monitor EndsOffRoad():
    while ego in roadOrShoulder:
        wait
    terminate

require monitor EndsOffRoad()
