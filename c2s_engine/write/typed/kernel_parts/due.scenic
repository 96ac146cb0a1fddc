def due(car, points, other, others, spot, speed):
    """Whether `car`, which stands, has to set out now for `speed` (m/s) to be at the spot when `other` is: driven at
    2 m/s2, it gains 1.4 m/s2 against the air and its wheels."""
    own, far = max(to_go(points, car, spot), 0), to_go(others, other, spot)
    gained = speed ** 2 / 2.8  # m
    time = math.sqrt(own / 0.7) if own < gained else speed / 1.4 + (own - gained) / speed
    return far < max(time, 0.5) * other.speed
