# component: R
# description: 'Ego is to turn round near an intersection: a road with an opposite lane group, close before the junction.'
# paraphrases:
#   - make a U-turn and go back the way it came
#   - reversing direction at the crossing
# places: [intersection]
# manoeuvres: [u_turn]
# ---
uTurnLanes = [m.startLane for i in network.intersections for m in i.maneuvers if m.startLane.group._opposite and m.startLane.centerline.length > 80]
egoLane = Uniform(*uTurnLanes)
returnLane = Uniform(*egoLane.group.opposite.lanes)
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -40
