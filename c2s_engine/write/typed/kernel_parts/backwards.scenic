behavior Backwards(speed):
    """Reverse straight back at a speed (m/s)."""
    while True:
        take SetReverseAction(True), SetSteerAction(0), SetSpeedAction(-speed)
