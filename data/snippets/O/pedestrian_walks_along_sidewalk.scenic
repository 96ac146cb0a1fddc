# component: O
# description: A pedestrian walks along the sidewalk in the direction of traffic.
# paraphrases:
#   - person strolls on the pavement
#   - walker stays off the carriageway
#   - somebody walks on the pavement
# positions: [sidewalk]
# actions: [move_along]
# types: [pedestrian]
# hosts: [R/road_with_sidewalk]
# ---
strollSpot = new OrientedPoint following roadDirection from egoSpot for 20

behavior WalksAlong(speed):
    while True:
        take SetWalkingDirectionAction(egoSpot.heading), SetWalkingSpeedAction(speed)

stroller = new Pedestrian at nearSidewalk.centerline.project(strollSpot.position),
    with regionContainedIn None,
    with behavior WalksAlong(1.3)
