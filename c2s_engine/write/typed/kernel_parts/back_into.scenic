behavior BackInto(other, speed):
    """Reverse at `speed` (m/s) with the tail towards `other`."""
    while True:
        place = (other.position - self.position).rotatedBy(-self.heading)
        steer = place.x / max(abs(place.y), 3)
        take SetReverseAction(True), SetSteerAction(max(-0.8, min(0.8, steer))), SetSpeedAction(-speed)
