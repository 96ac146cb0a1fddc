def lead_on(car, other):
    """How far (m) `car` is ahead of `other` along the road; negative: behind."""
    return (car.position - other.position).rotatedBy(-other.heading).y
