# component: T
# description: Ego must get moving at some time of the run.
# paraphrases:
#   - at last it drives
#   - my car must drive off at some time
#   - it may not stand still for ever
# conditions: [action]
# ---
require eventually ego.speed > 1
