def need(car, other):
    """The deceleration (m/s2) that keeps `car` from reaching `other`, if both go on as they do; 0: no conflict."""
    place = (other.position - car.position).rotatedBy(-car.heading)
    motion = other.velocity.rotatedBy(-car.heading)
    across = abs(math.sin(other.heading - car.heading))
    gap = place.y - (car.length + other.width * across + other.length * (1 - across)) / 2
    reach = (car.width + other.length * across + other.width * (1 - across)) / 2 + 0.8
    closing = car.speed - motion.y
    if place.y <= 0:
        return 0
    if gap < 8 and car.speed < 2 and motion.y < 1 and abs(place.x) < reach:
        return 9
    if closing <= 0.1:
        return 0
    there = place.x + motion.x * max(gap, 0) / closing
    gone = place.x + motion.x * (max(gap, 0) + car.length + other.width) / closing
    if min(there, gone) > reach or max(there, gone) < -reach:
        return 0
    if gap < 2 + 0.7 * motion.y:
        return 9
    return closing ** 2 / (2 * max(gap - 2 - 0.5 * max(motion.y, 0), 0.3))
