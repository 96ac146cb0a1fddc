# component: E
# description: Ego halts at the end of its lane, as at a stop sign, for two seconds and then goes on.
# paraphrases:
#   - full stop at the line before crossing
#   - obey a stop sign
#   - halt, then go on
# actions: [stop]
# reactions: [yield]
# hosts: [R/intersection_unsignalised]
# ---
behavior EgoStopsAtSign(path, pause):
    try:
        do FollowTrajectoryBehavior(target_speed=7, trajectory=path)
    interrupt when (distance from self to egoLane.centerline[-1]) < 10 and not self.halted:
        while self.speed > 0.1:
            take SetThrottleAction(0), SetBrakeAction(1)
        do EgoHolds() for pause seconds
        self.halted = True

behavior EgoHolds():
    while True:
        take SetBrakeAction(1)

ego = new Car at egoSpot, facing roadDirection,
    with halted False,
    with behavior EgoStopsAtSign(egoPath, 2)
