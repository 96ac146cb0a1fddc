behavior Walk(heading, speed):
    """Walk on in a direction (rad) at a speed (m/s)."""
    while True:
        take SetWalkingDirectionAction(heading), SetWalkingSpeedAction(speed)
