def straight_on(car, metres=200):
    """Points 2 m apart straight ahead of `car`."""
    return [car.position.offsetRotated(car.heading, Vector(0, 2 * k)) for k in range(metres // 2)]
