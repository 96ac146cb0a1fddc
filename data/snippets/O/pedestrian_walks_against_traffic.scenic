# component: O
# description: A pedestrian walks along the edge of the road towards ego.
# paraphrases:
#   - person faces the traffic at the verge
#   - somebody on foot comes towards me at the edge of the road
# positions: [roadside]
# actions: [move_along]
# types: [pedestrian]
# ---
againstSpot = new OrientedPoint following roadDirection from egoSpot for 45

behavior WalksTowards(speed):
    while True:
        take SetWalkingDirectionAction(egoSpot.heading + 180 deg), SetWalkingSpeedAction(speed)

towards = new Pedestrian right of againstSpot by 2.2,
    with regionContainedIn None,
    with behavior WalksTowards(Range(1, 1.5))
