def near(car, other):
    """Whether `car` and `other` would touch within about a second if one turned to the other."""
    return (distance from car to other) < 8 + (car.velocity - other.velocity).norm()

def touch(car, other):
    """Whether `car` and `other` are in contact, seen as boxes along the road of `car`."""
    place = (other.position - car.position).rotatedBy(-car.heading)
    across = abs(math.sin(other.heading - car.heading))
    long, wide = (other.length * (1 - across) + other.width * across, other.width * (1 - across) + other.length * across)
    return abs(place.y) < (car.length + long) / 2 + 0.2 and abs(place.x) < (car.width + wide) / 2 + 0.2

behavior Ram(other, speed, rate=5):
    """Drive at where `other` will be when it is reached, at `speed` (m/s), changing it by at most `rate` (m/s2): beside
    it as fast as that one, and slower where it comes from behind."""
    while True:
        place = (other.position - self.position).rotatedBy(-self.heading)
        motion = other.velocity.rotatedBy(-self.heading)
        time = max(0, min(1.5, place.y / max(self.speed - motion.y, 3)))
        aim = place + motion * time
        steer = math.atan(1.2 * self.length * aim.x / max(aim.x ** 2 + aim.y ** 2, 1)) / 0.8
        goal = max(speed, motion.y + 3)
        if abs(place.y) < self.length and motion.y > 1:
            goal = motion.y
        elif place.y < 0:
            goal = max(0, motion.y - 3)
        step = rate * simulation().timestep
        take (SetSpeedAction(max(0, self.speed + max(-step, min(step, goal - self.speed)))),
              SetSteerAction(max(-1, min(1, steer))))
