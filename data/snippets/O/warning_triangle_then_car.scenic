# component: O
# description: A warning sign stands in the lane before a broken-down car.
# paraphrases:
#   - hazard triangle behind a disabled vehicle
# positions: [ahead]
# actions: [stationary]
# types: [warning_sign, car]
# ---
brokenSpot = new OrientedPoint following roadDirection from egoSpot for 60
broken = new Car at brokenSpot, facing roadDirection
triangle = new TrafficWarning behind broken by 12, with regionContainedIn None
