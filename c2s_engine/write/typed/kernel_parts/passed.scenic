def passed(other, car, further=10):
    """Whether `other` has gone by the spot `further` m ahead of `car`, seen along its own way."""
    spot = car.position.offsetRotated(car.heading, Vector(0, further))
    return (spot - other.position).rotatedBy(-other.heading).y < -other.length / 2 - 1
