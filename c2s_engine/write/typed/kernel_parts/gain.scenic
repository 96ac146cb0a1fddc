def gain(car, other, speed):
    """The speed (m/s), at most `speed`, at which `car` goes out and by `other`: slower as long as it is still behind it
    and would reach it."""
    place = (car.position - other.position).rotatedBy(-other.heading)
    gap = -place.y - (car.length + other.length) / 2
    if gap < -car.length or abs(place.x) > (car.width + other.width) / 2 + 0.5:
        return speed
    return min(speed, max(1.5, other.speed + math.sqrt(8 * max(gap - 1.5, 0))))
