def strike(car, other, spot, speed):
    """The speed (m/s), about `speed`, at which `car` reaches the spot with `other`; while that stands before the spot,
    `car` hangs back so far as it then needs."""
    own = (spot - car.position).rotatedBy(-car.heading).y
    far = (spot - other.position).rotatedBy(-other.heading).y
    if own < 8 or far < 3:
        return speed
    if other.speed < 1:
        return speed * max(0, min(1, (own - speed * math.sqrt(far)) / 30))
    time = min(far / other.speed, math.sqrt(far + other.speed ** 2 / 4) - other.speed / 2 if other.speed < 4 else 100)
    return max(0.6 * speed, min(1.5 * speed, own / max(time, 0.5)))
