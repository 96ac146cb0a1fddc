# component: T
# description: The run ends when the lead vehicle has stopped.
# paraphrases:
#   - stop once the vehicle in front is at a standstill
#   - end when the car in front has stopped
#   - over once the leader stands still
# conditions: [stopped]
# hosts: [O/lead_ahead_of_specifier]
# ---
terminate when lead.speed < 0.1 and simulation().currentTime > 20
