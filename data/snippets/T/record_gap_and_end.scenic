# component: T
# description: The gap to the lead vehicle is recorded in each step, and its smallest value counts; the run ends after 12 seconds.
# paraphrases:
#   - log the separation over time
#   - measure how close the cars get
#   - record the distance to the car in front
# conditions: [distance, time]
# hosts: [O/lead_ahead_of_specifier]
# ---
record (distance from ego to lead) as gap
record final ego.speed as finalSpeed
terminate after 12 seconds
