def meet(car, other, spot, speed, sooner=0):
    """The speed (m/s), about `speed`, at which `car` comes to the spot `sooner` s before `other` does."""
    own = (spot - car.position).rotatedBy(-car.heading).y
    far = (spot - other.position).rotatedBy(-other.heading).y
    if own < 8 or other.speed < 2:
        return speed
    if far < 12:
        return max(car.speed, 0.6 * speed)
    return max(0.45 * speed, min(1.5 * speed, own / max(far / other.speed - sooner, 0.5)))
