def ttc(car, other):
    """The time (s) until `car` and `other` would touch if the distance went on shrinking as it does."""
    apart = other.position - car.position
    gap = max((distance from car to other) - (car.length + other.length) / 2, 0)
    closing = (car.velocity - other.velocity).dot(apart.normalized())
    return gap / closing if closing > 0.1 else 1000
