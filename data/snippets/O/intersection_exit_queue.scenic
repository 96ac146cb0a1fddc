# component: O
# description: Two cars queue in ego's exit lane, so that the junction cannot be cleared.
# paraphrases:
#   - congestion behind the crossing
#   - a traffic jam behind the junction
#   - cars stand still right after the junction, no room for me
# positions: [intersection_exit]
# actions: [stationary]
# types: [car]
# hosts: [R/intersection_four_way]
# ---
queueHead = new OrientedPoint at egoManeuver.endLane.centerline.pointAlongBy(20), facing roadDirection
headCar = new Car at queueHead, facing roadDirection
tailCar = new Car behind headCar by 2
