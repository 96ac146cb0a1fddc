# component: O
# description: A pedestrian walks over the crosswalk as ego approaches it.
# paraphrases:
#   - somebody uses the zebra crossing
#   - walker on the marked crossing
#   - somebody on foot uses the zebra crossing
# positions: [sidewalk]
# actions: [cross_road]
# types: [pedestrian]
# hosts: [R/crosswalk_before_junction]
# ---
zebraStart = new OrientedPoint right of crosswalkSpot by 5

behavior UsesCrosswalk(delay, speed):
    for i in range(delay):
        take SetWalkingSpeedAction(0)
    while True:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)

zebraWalker = new Pedestrian at zebraStart, facing 90 deg relative to crosswalkSpot.heading,
    with regionContainedIn None,
    with behavior UsesCrosswalk(15, 1.5)
