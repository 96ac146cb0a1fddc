# component: O
# description: Rubbish lies in the lane, thrown there at a random place.
# paraphrases:
#   - garbage on the driving lane
#   - litter on the road
#   - garbage lies on the road in front of me
# positions: [ahead]
# actions: [stationary]
# types: [trash]
# ---
trash = new Trash on egoLane.centerline
require 25 < (distance from trash to ego) < 60
require (distance past ego of trash) > 20 or (distance from trash to ego) > 25
