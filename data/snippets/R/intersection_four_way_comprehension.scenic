# component: R
# description: A straight manoeuvre through any intersection of four roads; ego starts 30 to 50 metres before it.
# paraphrases:
#   - junction where four streets meet, ego does not turn
# places: [intersection]
# manoeuvres: [straight]
# ---
crossings4 = [m for i in network.intersections if i.is4Way for m in i.maneuvers if m.type is ManeuverType.STRAIGHT]
way = Uniform(*[m for m in crossings4 if m.startLane.centerline.length > 80])
egoLane = way.startLane
egoPath = [way.startLane, way.connectingLane, way.endLane]
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(egoLane.centerline.length - Range(30, 50)), facing roadDirection
