# component: E
# description: Ego is placed without any behaviour, so that it simply stands.
# paraphrases:
#   - motionless subject vehicle
#   - my car is parked and does nothing
#   - the test car just stands there
# actions: [stationary]
# ---
ego = new Car at egoSpot, facing roadDirection, with blueprint 'vehicle.lincoln.mkz_2017'
