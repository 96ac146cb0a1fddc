# component: O
# description: An oncoming car passes a vehicle that stands on its side by using ego's lane for a moment.
# paraphrases:
#   - opposite driver swings out around a parked van
#   - invading the host's lane to get round a blockage
#   - a car from the other direction swings onto my side to pass something
# positions: [oncoming_lane]
# actions: [oncoming, overtake]
# types: [car]
# hosts: [R/road_oncoming_lane_adjacent]
# ---
blockSpot = new OrientedPoint following roadDirection from egoSpot for 50
blockedVan = new Van at oncomingLane.centerline.project(blockSpot.position), facing roadDirection
comeSpot = new OrientedPoint following roadDirection from egoSpot for 75

behavior GoesRound(speed):
    do FollowLaneBehavior(target_speed=speed) until (distance from self to blockedVan) < 18
    do LaneChangeBehavior(egoSection, is_oppositeTraffic=True, target_speed=speed)
    do FollowLaneBehavior(target_speed=speed, is_oppositeTraffic=True) for 2 seconds
    do LaneChangeBehavior(network.laneSectionAt(blockedVan), target_speed=speed)

rounder = new Car at oncomingLane.centerline.project(comeSpot.position), facing roadDirection,
    with behavior GoesRound(6)
