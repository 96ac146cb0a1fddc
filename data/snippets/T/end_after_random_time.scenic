# component: T
# description: The run ends after a drawn time between 10 and 20 seconds.
# paraphrases:
#   - varying run length
#   - stop after some seconds, not always the same
#   - end at a random time
# conditions: [time]
# ---
RUN_SECONDS = Range(10, 20)
terminate when simulation().currentTime * 0.1 > RUN_SECONDS
