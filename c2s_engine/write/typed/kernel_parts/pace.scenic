def pace(car, lead, speed, headway=1.5):
    """The speed (m/s) at which `car` follows `lead` with a time headway (s), at most `speed`."""
    gap = (distance from car to lead) - (car.length + lead.length) / 2
    wanted = min(speed, lead.speed + 0.4 * (gap - 4 - headway * lead.speed))
    return wanted if wanted > 0.6 or lead.speed > 0.3 and wanted > 0 else 0
