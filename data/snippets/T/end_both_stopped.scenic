# component: T
# description: The run ends when both ego and the lead vehicle stand.
# paraphrases:
#   - nobody moves any more
#   - end when both cars stand still
#   - over when everybody has stopped
# conditions: [stopped]
# hosts: [O/lead_ahead_of_specifier]
# ---
monitor BothStand():
    while ego.speed > 0.1 or lead.speed > 0.1 or simulation().currentTime < 20:
        wait
    terminate

require monitor BothStand()
