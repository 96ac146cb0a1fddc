# component: E
# description: 'Ego creeps along in a traffic jam: it stops when the car ahead is near and moves off when it is gone.'
# paraphrases:
#   - congestion, stop-and-go traffic assist
#   - crawl in a queue
#   - traffic jam assistant
# reactions: [follow]
# ---
behavior EgoStopAndGo(crawl):
    while True:
        if withinDistanceToObjsInLane(self, 9):
            take SetThrottleAction(0), SetBrakeAction(0.7)
        else:
            do FollowLaneBehavior(target_speed=crawl) for 0.5 seconds

ego = new Car at egoSpot, facing roadDirection, with behavior EgoStopAndGo(4)
