# component: O
# description: A warning sign stands in the lane before a broken-down car.
# paraphrases:
#   - hazard triangle behind a disabled vehicle
#   - a warning triangle and behind it a car that broke down
#   - a breakdown with a warning sign in front of it
# positions: [ahead]
# actions: [stationary]
# types: [warning_sign, car]
# ---
brokenSpot = new OrientedPoint following roadDirection from egoSpot for 60
broken = new Car at brokenSpot, facing roadDirection
triangle = new TrafficWarning behind broken by 12, with regionContainedIn None
