def meet(car, points, other, others, speed):
    """The speed (m/s) at which `car` comes where its way meets that of `other` when the other does; about `speed`."""
    near = lambda p: min(distance from p to q for q in others[::3])
    spot = min(points[::3], key=near)
    if (distance from other to spot) < 12 or other.speed < 2:
        return speed
    wanted = (distance from car to spot) * other.speed / (distance from other to spot)
    return max(0.6 * speed, min(1.5 * speed, wanted))
