def nearest(car, points):
    """The index of the point nearest to `car`."""
    return min(range(len(points)), key=lambda k: math.hypot(points[k].x - car.position.x, points[k].y - car.position.y))

def bend_speed(points, i):
    """The speed (m/s) that the bends of the next 60 m allow at 4 m/s2 sideways, braking at 2 m/s2."""
    fastest = 100
    for k in range(i, min(i + 30, len(points) - 4), 2):
        a, b, c = points[k], points[k + 2], points[k + 4]
        turn = math.atan2(c.y - b.y, c.x - b.x) - math.atan2(b.y - a.y, b.x - a.x)
        bend = abs((turn + math.pi) % (2 * math.pi) - math.pi) / 4
        fastest = min(fastest, math.sqrt(4 / max(bend, 0.001) + 8 * max(k - i - 1, 0)))
    return fastest

behavior Drive(points, speed, rate=3, offset=0, shift=1.5):
    """Follow points at `speed` (m/s, or a function that gives it), changing it by at most `rate` (m/s2, likewise);
    `offset` m to their left, moving there at `shift` m/s. Pure pursuit, slower in bends."""
    i, last = nearest(self, points), len(points) - 1
    left = (points[min(i + 1, last)] - points[min(i, last - 1)]).normalized().rotatedBy(90 deg)
    beside = max(-abs(offset), min(abs(offset), (self.position - points[i]).dot(left)))
    while True:
        while i < last - 1 and (distance from self to points[i + 2]) <= (distance from self to points[i]):
            i += 1
        goal = min(speed() if callable(speed) else speed, bend_speed(points, i), math.sqrt(12 * max(last - i - 4, 0)))
        beside += max(-shift, min(shift, 10 * (offset - beside))) * simulation().timestep
        ahead = min(i + 2 + int(0.35 * self.speed), last)
        along = (points[ahead] - points[max(ahead - 1, 0)]).normalized()
        target = (points[ahead] + along.rotatedBy(90 deg) * beside - self.position).rotatedBy(-self.heading)
        steer = math.atan(1.2 * self.length * target.x / max(target.x ** 2 + target.y ** 2, 1)) / 0.8
        step = (rate() if callable(rate) else rate) * simulation().timestep
        take (SetSpeedAction(max(0, self.speed + max(-step, min(step, goal - self.speed)))),
              SetSteerAction(max(-1, min(1, steer))))
