def level(car, other, speed):
    """The speed (m/s), about `speed`, at which `car` comes level with `other`, which drives the same way."""
    ahead = lead_on(car, other)
    if abs(ahead) < 3:
        return other.speed
    return max(0, other.speed - 4) if ahead > 0 else max(speed, other.speed + 4)
