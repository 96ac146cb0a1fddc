# What a check does after `model`, in short: run once in each snapshot to learn which memory a check writes on.
# Here what chooses places, in rehearsal_objects.scenic what comes after that.
speed = 7
gap = Range(5, 8)
lanes = filter(lambda l: l.centerline.length > 10, network.lanes)
sections = filter(lambda s: s.centerline.length > 10 and not s.road is None, network.laneSections)
crossings = filter(lambda i: i.is4Way or i.is3Way or i.isSignalized, network.intersections)
turns = [m for i in crossings for m in i.maneuvers if m.type and m.startLane and m.connectingLane and m.endLane]
start = new OrientedPoint on Uniform(*lanes).centerline
