# component: T
# description: Ego's speed must stay under 20 m/s during the whole run.
# paraphrases:
#   - never faster than a limit
#   - my car must not go faster than that
#   - stay under a speed the whole time
# conditions: [distance]
# ---
require always ego.speed < 20
