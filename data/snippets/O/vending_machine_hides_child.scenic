# component: O
# description: A child steps out from behind a vending machine on the sidewalk.
# paraphrases:
#   - street furniture conceals a kid
#   - occluded youngster enters the road
#   - a child runs out from behind a vending machine
# positions: [sidewalk]
# actions: [cross_road]
# types: [vending_machine, child]
# hosts: [R/road_with_sidewalk]
# ---
vendSpot = new OrientedPoint following roadDirection from egoSpot for 34
machine = new VendingMachine right of vendSpot by 3.4, with regionContainedIn None
concealed = new OrientedPoint ahead of machine by 1

behavior StepsOut(near):
    while (distance from self to ego) > near:
        take SetWalkingSpeedAction(0)
    while True:
        take SetWalkingDirectionAction(egoSpot.heading + 90 deg), SetWalkingSpeedAction(2)

vendChild = new Pedestrian right of (vendSpot offset by (0, 2)) by 3.4,
    with blueprint 'walker.pedestrian.0010',
    with regionContainedIn None,
    with behavior StepsOut(26)
