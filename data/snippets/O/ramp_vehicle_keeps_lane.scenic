# component: O
# description: A truck drives on the ramp beside the motorway at a drawn distance before the merge point.
# paraphrases:
#   - heavy vehicle on the acceleration lane
#   - a truck about to enter the highway
#   - a truck drives along on the slip road next to the highway
# positions: [on_ramp]
# actions: [keep_lane]
# types: [truck]
# hosts: [R/motorway_right_lane]
# ---
rampLanes = [l for l in network.lanes if l.road.is1Way and len(l.road.lanes) == 1 and l.centerline.length > 200 and l.maneuvers and len(l.maneuvers[0].endLane.road.lanes) >= 3]
rampLane = Uniform(*rampLanes)
rampTruck = new Truck at rampLane.centerline.pointAlongBy(rampLane.centerline.length - Range(50, 90)), facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=10)
