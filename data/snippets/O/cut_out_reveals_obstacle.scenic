# component: O
# description: The lead car cuts out late and reveals a stationary car that it had hidden from ego.
# paraphrases:
#   - swerving leader uncovers a standing target
#   - obstacle appears behind the vehicle that changes lanes
#   - the one in front dodges at the last moment and a parked car becomes visible
#   - a swerving car uncovers a standing car
# positions: [ahead]
# actions: [cut_out, stationary]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
standSpot = new OrientedPoint following roadDirection from egoSpot for 60
standing = new Car at standSpot, facing roadDirection
escapeSection = network.laneSectionAt(egoSpot).laneToLeft

behavior CutsOutLate(speed, gap):
    do FollowLaneBehavior(target_speed=speed) until (distance from self to standing) < gap
    do LaneChangeBehavior(escapeSection, target_speed=speed)
    do FollowLaneBehavior(target_speed=speed)

lead = new Car ahead of ego by 12, with behavior CutsOutLate(7, 22)
