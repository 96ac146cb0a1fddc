def lurk(car, other, speed):
    """The speed (m/s) at which `car` stays close behind `other`, beside whose lane it is, until that comes over."""
    place = (other.position - car.position).rotatedBy(-car.heading)
    if abs(place.x) < 2.6:
        return max(speed, other.speed + 6)
    return max(0, min(1.3 * speed, other.speed + 0.5 * (place.y - car.length - 4)))
