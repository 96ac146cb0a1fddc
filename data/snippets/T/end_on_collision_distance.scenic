# component: T
# description: The run ends when the distance between the two centres is less than a car's length.
# paraphrases:
#   - impact judged by the gap
#   - over when there is a crash
# conditions: [collision]
# hosts: [O/lead_ahead_of_specifier]
# ---
terminate when (distance from ego to lead) < 4.6
