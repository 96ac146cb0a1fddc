behavior Drive(points, speed, rate=3, offset=0, shift=1.5):
    """Follow points at `speed` (m/s, or a function that gives it), changing it by at most `rate` (m/s2);
    `offset` m to their left, moving there at `shift` m/s. Pure pursuit, slower in bends."""
    last = len(points) - 1
    i = min(range(last + 1), key=lambda k: distance from self to points[k])
    beside = 0
    while True:
        while i < last and (distance from self to points[i + 1]) < (distance from self to points[i]):
            i += 1
        goal = speed() if callable(speed) else speed
        for k in range(i + 2, min(i + 30, last - 1), 2):
            before, after = points[k] - points[k - 2], points[k + 2] - points[k]
            bend = abs(math.atan2(before.x * after.y - before.y * after.x, before.x * after.x + before.y * after.y)) / 4
            goal = min(goal, math.sqrt(4 / max(bend, 0.001) + 8 * (k - i)))
        if i > last - 3:
            goal = 0
        beside += max(-shift, min(shift, 10 * (offset - beside))) * simulation().timestep
        ahead = min(i + 2 + int(0.45 * self.speed), last)
        along = (points[ahead] - points[max(ahead - 1, 0)]).normalized()
        target = points[ahead] + along.rotatedBy(90 deg) * beside - self.position
        target = target.rotatedBy(-self.heading)
        steer = math.atan(2 * self.length * 0.6 * target.x / max(target.x ** 2 + target.y ** 2, 1)) / 1.2
        step = rate * simulation().timestep
        take (SetSpeedAction(max(0, self.speed + max(-step, min(step, goal - self.speed)))),
              SetSteerAction(max(-1, min(1, steer))))
