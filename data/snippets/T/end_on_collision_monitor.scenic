# component: T
# description: A monitor ends the run half a second after the collision.
# paraphrases:
#   - keep recording for a moment after the impact
#   - over shortly after a crash
# conditions: [collision]
# hosts: [O/lead_ahead_of_specifier]
# ---
monitor EndsAfterImpact():
    while not (ego intersects lead):
        wait
    for i in range(5):
        wait
    terminate

require monitor EndsAfterImpact()
