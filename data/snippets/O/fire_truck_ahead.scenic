# component: O
# description: A fire engine drives ahead of ego.
# paraphrases:
#   - fire brigade vehicle in front
#   - the fire brigade drives in front of me
# positions: [ahead]
# actions: [keep_lane]
# types: [fire_truck]
# ---
fireEngine = new Truck ahead of ego by 20,
    with blueprint 'vehicle.carlamotors.firetruck',
    with behavior FollowLaneBehavior(target_speed=7)
