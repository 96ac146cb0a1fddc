# component: T
# description: A monitor ends the run after 15 seconds or 100 metres, whichever comes first.
# paraphrases:
#   - combined limit of time and way
#   - end after so many seconds or metres
#   - stop by time or by distance driven
# conditions: [time, travelled]
# ---
monitor LimitsRun(steps, metres):
    for step in range(steps):
        if (distance from ego to egoSpot) > metres:
            terminate
        wait
    terminate

require monitor LimitsRun(150, 100)
