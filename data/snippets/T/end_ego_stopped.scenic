# component: T
# description: The run ends when ego has come to a stand after three seconds at the earliest.
# paraphrases:
#   - finish as soon as the host no longer moves
#   - the test is over when the car stands
#   - over when my car stands still
# conditions: [stopped]
# ---
terminate when ego.speed < 0.1 and simulation().currentTime > 30
