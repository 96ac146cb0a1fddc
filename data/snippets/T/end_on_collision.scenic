# component: T
# description: The run ends when ego touches the lead vehicle.
# paraphrases:
#   - finish at the crash
#   - stop on contact
#   - over when there is a crash
# conditions: [collision]
# hosts: [O/lead_ahead_of_specifier]
# ---
terminate when ego intersects lead
