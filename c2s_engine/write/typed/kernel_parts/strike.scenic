def to_go(points, car, spot):
    """How far (m) `car` still has to go to the spot along points 2 m apart; negative: it is past it."""
    there = min(range(len(points)), key=lambda k: (points[k].x - spot.x) ** 2 + (points[k].y - spot.y) ** 2)
    steps = there - nearest(car, points)
    return (distance from car to spot) if 0 < steps < 6 else 2 * steps

def strike(car, points, other, others, spot, speed, sooner=0, front=0):
    """The speed (m/s), about `speed`, at which `car` on its points reaches the spot with `other` on those of it, or
    `sooner` s before it (a bend slows it), or so that its front, `front` m ahead of it, does; while that stands before
    the spot, `car` hangs back so far as it then needs."""
    own, far = to_go(points, car, spot), to_go(others, other, spot) + front * other.speed / speed
    if own < 4 or far < 3:
        return speed
    if other.speed < 1:
        return speed * max(0, min(1, (own - speed * math.sqrt(far)) / 30))
    time = min(far / other.speed, math.sqrt(far + other.speed ** 2 / 4) - other.speed / 2 if other.speed < 4 else 100)
    return max(0.4 * speed, min(1.5 * speed, own / max(time - sooner, 0.5)))
