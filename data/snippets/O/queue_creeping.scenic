# component: O
# description: Two cars ahead creep along at walking pace and stop again and again.
# paraphrases:
#   - stop-and-go jam in front of the host
#   - bumper-to-bumper congestion
#   - cars in front of me crawl and stop and crawl
# positions: [ahead]
# actions: [keep_lane, stop]
# types: [car]
# ---
behavior CreepsInJam():
    while True:
        do FollowLaneBehavior(target_speed=2) for 3 seconds
        do JamHold() for 2 seconds

behavior JamHold():
    while True:
        take SetBrakeAction(1), SetThrottleAction(0)

jamA = new Car ahead of ego by 12, with behavior CreepsInJam()
jamB = new Car ahead of jamA by 5, with behavior CreepsInJam()
