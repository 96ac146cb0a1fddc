# component: T
# description: Ego's speed must stay under 20 m/s during the whole run.
# paraphrases:
#   - never faster than a limit
# conditions: [distance]
# ---
require always ego.speed < 20
