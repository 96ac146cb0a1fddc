def strike(car, other, spot, speed, sooner=0):
    """The speed (m/s), about `speed`, at which `car` reaches the spot with `other`, or `sooner` s before it (a bend
    slows it); while that stands before the spot, `car` hangs back so far as it then needs."""
    own, far = (distance from car to spot), (distance from other to spot)
    over = min((spot - one.position).rotatedBy(-one.heading).y for one in (car, other))
    if over < 0 or own < 4 or far < 3:
        return speed
    if other.speed < 1:
        return speed * max(0, min(1, (own - speed * math.sqrt(far)) / 30))
    time = min(far / other.speed, math.sqrt(far + other.speed ** 2 / 4) - other.speed / 2 if other.speed < 4 else 100)
    return max(0.4 * speed, min(1.5 * speed, own / max(time - sooner, 0.5)))
