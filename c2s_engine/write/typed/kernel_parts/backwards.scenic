behavior Backwards(speed, steer=0):
    """Reverse at a speed (m/s); `steer` over 0 takes the tail to the right."""
    while True:
        take SetReverseAction(True), SetSteerAction(steer), SetSpeedAction(-speed)
