# component: T
# description: Ego must get moving at some time of the run.
# paraphrases:
#   - at last it drives
# conditions: [action]
# ---
require eventually ego.speed > 1
