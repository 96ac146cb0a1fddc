# component: T
# description: 'The run ends when ego has lost over 4 m/s within half a second: a hard brake.'
# paraphrases:
#   - over once an emergency stop was seen
#   - end when my car brakes hard
#   - over after a sudden strong brake
# conditions: [action]
# ---
monitor EndsAtHardBrake(drop):
    before = ego.speed
    while True:
        for i in range(5):
            wait
        if before - ego.speed > drop:
            terminate
        before = ego.speed

require monitor EndsAtHardBrake(4)
