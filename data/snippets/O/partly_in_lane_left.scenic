# component: O
# description: A broken-down car stands askew at the left edge of ego's lane, partly in it.
# paraphrases:
#   - disabled vehicle at an angle across the marking
#   - a car that broke down stands crooked, half in my way
# positions: [partly_in_lane]
# actions: [stationary]
# types: [car]
# ---
askewSpot = new OrientedPoint following roadDirection from egoSpot for 38
askew = new Car at askewSpot offset by (-1.6, 0), facing Range(-15, 15) deg relative to roadDirection
