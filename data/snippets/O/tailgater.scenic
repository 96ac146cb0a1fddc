# component: O
# description: 'A van tailgates ego: it stays as close as six metres behind, matching ego''s speed.'
# paraphrases:
#   - pushy driver right on the rear bumper
#   - dangerously short following distance
#   - the driver behind is far too close to my bumper
# positions: [behind]
# actions: [follow]
# types: [van]
# ---
behavior Tailgates(gap):
    while True:
        wanted = ego.speed + 0.3 * ((distance from self to ego) - gap)
        do FollowLaneBehavior(target_speed=max(0, wanted)) for 0.5 seconds

pusherSpot = new OrientedPoint following roadDirection from egoSpot for -12
pusher = new Van at pusherSpot, facing roadDirection, with behavior Tailgates(10)
