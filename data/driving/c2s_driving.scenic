"""Driving for Scenic programs: ways through a road network, behaviours that follow them, and how road users stand to
one another. For `scenic.domains.driving` and every model built on it (`scenic.simulators.carla.model` among them):

    model scenic.simulators.carla.model
    from c2s_driving import *

Lengths are in m, times in s, speeds in m/s, accelerations in m/s2, angles in rad, anticlockwise. Nothing random is
decided here: what is passed in behaviours and `interrupt when` conditions has its value by then.
"""

import functools
import itertools
import math
import typing
from xml.etree import ElementTree

import numpy
import shapely.geometry

from scenic.core.distributions import RejectionException, distributionFunction
from scenic.core.vectors import Vector
from scenic.domains.driving.actions import SetReverseAction, SetSpeedAction, SetSteerAction, SetVelocityAction
from scenic.domains.driving.actions import SetWalkingDirectionAction, SetWalkingSpeedAction
from scenic.domains.driving.model import network
from scenic.domains.driving.roads import Lane, Maneuver, ManeuverType

LIBRARY_VERSION = 2


# Blueprints of CARLA by what they show, each in 0.9.15 and in 0.9.16: `with blueprint Uniform(*CARS)`

CARS = ['vehicle.audi.a2', 'vehicle.audi.etron', 'vehicle.bmw.grandtourer', 'vehicle.chevrolet.impala',
        'vehicle.lincoln.mkz_2017', 'vehicle.toyota.prius', 'vehicle.tesla.model3']
TRUCKS = ['vehicle.carlamotors.european_hgv', 'vehicle.carlamotors.carlacola']
PICKUPS = ['vehicle.tesla.cybertruck']
MOTORCYCLES = ['vehicle.kawasaki.ninja', 'vehicle.yamaha.yzf']
BICYCLES = ['vehicle.bh.crossbike', 'vehicle.gazelle.omafiets', 'vehicle.diamondback.century']
PEDESTRIANS = ['walker.pedestrian.0001', 'walker.pedestrian.0002', 'walker.pedestrian.0003',
               'walker.pedestrian.0005', 'walker.pedestrian.0006']
CHILDREN = ['walker.pedestrian.0009', 'walker.pedestrian.0010', 'walker.pedestrian.0011',
            'walker.pedestrian.0012']
CONES = ['static.prop.constructioncone', 'static.prop.trafficcone01']
DEBRIS = ['static.prop.dirtdebris01', 'static.prop.dirtdebris02']
CONTAINERS = ['static.prop.container', 'static.prop.clothcontainer', 'static.prop.glasscontainer']
TRASH = ['static.prop.bin', 'static.prop.trashcan01', 'static.prop.trashcan02']
BOXES = ['static.prop.box01', 'static.prop.box02', 'static.prop.box03']
BENCHES = ['static.prop.bench01', 'static.prop.bench02']
PLANT_POTS = ['static.prop.plantpot01', 'static.prop.plantpot02']


# Ways: points 2 m apart along lanes, for Drive

def begin(lane):
    """The direction in which a lane begins."""
    return lane.centerline[1] - lane.centerline[0]

def _route(lane, turn=ManeuverType.STRAIGHT, bearing=0):
    """Points 2 m apart along a lane and on over the next junctions: by `turn` (a manoeuvre or its type) at the first,
    then straight on, or where that is not possible nearest to `bearing` (rad, to the left) from the first lane."""
    points, goal = lane.centerline.pointsSeparatedBy(2), (lane.centerline[-1] - lane.centerline[-2]).rotatedBy(bearing)
    enough = len(points) + 400
    while len(points) < enough:
        onward = _onward(lane, turn, goal)
        if not onward:
            break
        if onward[0].connectingLane:
            points += onward[0].connectingLane.centerline.pointsSeparatedBy(2)
        lane, turn = onward[0].endLane, ManeuverType.STRAIGHT
        points += lane.centerline.pointsSeparatedBy(2)
    return points

def _onward(lane, turn, goal):
    """The manoeuvres by which a way goes on from a lane, the first of them first."""
    onward = [m for m in lane.maneuvers if turn in (m, m.type)]
    onward = onward or [m for l in lane.group.lanes for m in l.maneuvers if m.type is turn]
    return onward or sorted(lane.maneuvers, key=lambda m: abs(goal.angleWith(begin(m.endLane))))

route = distributionFunction(functools.lru_cache(maxsize=64)(_route))

def straight_on(car, metres=200):
    """Points 2 m apart straight ahead of `car`."""
    return [car.position.offsetRotated(car.heading, Vector(0, 2 * k)) for k in range(int(metres / 2) + 1)]


# Meetings: where somebody starts so as to meet another, both driving on as they do; nothing is steered in the run

def stations(points):
    """How far along a way (m) each of its points lies."""
    steps = [math.hypot(b.x - a.x, b.y - a.y) for a, b in zip(points, points[1:])]
    return [0, *itertools.accumulate(steps)]

def conflict(lane, points, others, near=2.2):
    """Where two ways come within `near` m of one another for the first time from shortly before the end of `lane` on: for
    each of them how far along it (m) that begins, where they cross or have met, and where it ends. If they never do: where
    `lane` ends, and beside that."""
    one = numpy.array([(p.x, p.y) for p in points])
    two = numpy.array([(p.x, p.y) for p in others])
    apart = numpy.hypot(one[:, None, 0] - two[None, :, 0], one[:, None, 1] - two[None, :, 1])
    def stretch(away, k):
        first, last = k, k
        while first > 0 and away[first - 1] < near:
            first -= 1
        while last < len(away) - 1 and away[last + 1] < near:
            last += 1
        return first, last
    away = apart.min(axis=1)
    there = numpy.array(stations(points)) > lane.centerline.length - 20  # who goes round may have been on it before
    inside = numpy.flatnonzero((away < near) & there)
    first, last = stretch(away, inside[0] if len(inside) else nearest_to(lane.centerline[-1], points))
    spot = first + int(away[first:last + 1].argmin() if last - first < 15 else (away[first:last + 1] < 1.2).argmax())
    there = int(apart[spot].argmin())
    begin, end = stretch(apart.min(axis=0), there)
    own, far = stations(points), stations(others)
    return (own[first], own[spot], own[last]), (far[begin], far[there], far[end])

DRAG = 0.075  # m/s by which the air and the wheels keep who drives below the speed that is set

def driving_times(points, speed, stop=None, held=1, slow=None):
    """How far along a way (m) its points lie, and when (s) somebody is there who drives it at `speed`, slower in bends;
    stop: m along it to where it stands `held` s before it sets out again; slow: (m along it, m/s) from where it is
    slower."""
    way = numpy.array(stations(points), float)
    pace = numpy.array([max(0.5, min(speed, bend_speed(points, k)) - DRAG) for k in range(len(points))])
    if slow is not None:
        behind = numpy.maximum(way - slow[0], 0)
        squared = numpy.maximum(slow[1] ** 2, speed ** 2 - 6 * behind)
        pace = numpy.minimum(pace, numpy.sqrt(squared))
    if stop is not None:
        k = int(numpy.searchsorted(way, stop, side='right'))
        way, pace = numpy.insert(way, k, stop), numpy.insert(pace, k, 0)
        rest = numpy.where(way < stop, 6 * (stop - way), 2.5 * (way - stop))
        pace = numpy.minimum(pace, numpy.sqrt(rest))
    mean = numpy.maximum(pace[1:] + pace[:-1], 0.02) / 2
    times = numpy.insert(numpy.cumsum(numpy.diff(way) / mean), 0, 0)
    return way, times if stop is None else times + held * (way > stop)

def setting_out(metres, speed, rate=2):
    """The time (s) in which a car that stands drives so far (m), up to `speed`."""
    gained = speed ** 2 / (2 * rate)
    if metres < gained:
        return math.sqrt(2 * max(metres, 0) / rate)
    return speed / rate + (metres - gained) / speed

def along_way(points, metres):
    """Where on a way (x, y) and in which direction (x, y; 1 m) so far along it (m, an array)."""
    way, xs, ys = stations(points), [p.x for p in points], [p.y for p in points]
    def point(s):
        return numpy.stack([numpy.interp(s, way, xs), numpy.interp(s, way, ys)], axis=-1)
    along = point(metres + 1) - point(metres - 1)
    norm = numpy.linalg.norm(along, axis=-1, keepdims=True)
    return point(metres), along / numpy.maximum(norm, 0.001)

class Part(object):
    """A part of a body of `length` and `width` (m): 'front', 'rear', 'left', 'right', a corner such as 'rear_left', or
    'side': the middle of whichever side is struck."""
    def __init__(self, name, length, width):
        self.name, self.size = name, (length, width)

    def spot(self, left):
        """How far (m) it is ahead of and to the left of the middle; `left`: whether the left side is struck."""
        length, width = self.size
        if self.name == 'side':
            return 0, width / 2 if left else -width / 2
        aside = self.name.endswith('left') - self.name.endswith('right')
        if self.name.startswith('front'):
            return length / 2, 0.3 * aside * width
        behind = {'rear': 0.5, 'rear_left': 0.22, 'rear_right': 0.22}.get(self.name, 0)
        return -behind * length, aside * width / 2

def overlapping(one, size, two, other_size):
    """Whether bodies of (length, width) overlap: arrays of (where they are, in which direction they head)."""
    (here, heading), (there, other_heading) = one, two
    apart, gap = numpy.zeros(here.shape[:-1], bool), there - here
    cos = numpy.abs((heading * other_heading).sum(axis=-1))
    sin = numpy.sqrt(numpy.maximum(1 - cos ** 2, 0))
    for along, mine, its in ((heading, size, other_size), (other_heading, other_size, size)):
        left = numpy.stack([-along[..., 1], along[..., 0]], axis=-1)
        apart |= numpy.abs((gap * along).sum(axis=-1)) > (mine[0] + its[0] * cos + its[1] * sin) / 2
        apart |= numpy.abs((gap * left).sum(axis=-1)) > (mine[1] + its[0] * sin + its[1] * cos) / 2
    return ~apart

def spot_of(part, pose, left):
    """Where the spot of a part is on bodies (where they are, in which direction they head)."""
    x, y = part.spot(left)
    here, along = pose
    return here + x * along + y * numpy.stack([-along[..., 1], along[..., 0]], axis=-1)

def comes_over(points, metres, size, others):
    """From how far along its points (m, about `metres`) a body of (length, width) is in another's way (`in_way`)."""
    line = shapely.geometry.LineString([(p.x, p.y) for p in others])
    stretch = numpy.arange(metres - 20, metres + 5, 0.5)
    here, along = along_way(points, stretch)
    left = numpy.stack([-along[:, 1], along[:, 0]], axis=-1)
    def over(k):
        ends = [here[k] + x * size[0] / 2 * along[k] + y * size[1] / 2 * left[k] for x, y in CORNERS]
        return line.distance(shapely.geometry.Polygon(ends)) < 1
    return next((stretch[k] for k in range(len(stretch)) if over(k)), metres)

FORESEEN = 0.45  # s before one is in its way at which another brakes for it, too late

CORNERS = [(1, 1), (-1, 1), (-1, -1), (1, -1)]

def lead_to_touch(points, own, spot, strikes, others, far, other_spot, struck, late=0):
    """How long (s) before another is at its spot one has to be at its own, so that the parts of both that come first into
    touch are these. own, far: the stations and times of both (as of `driving_times`); late: m/s2 at which the other
    brakes from when one comes into its way."""
    begin, other_begin = numpy.interp(spot, *own), numpy.interp(other_spot, *far)
    leads, time = numpy.arange(-3, 3, 0.05)[:, None], numpy.arange(-3, 3, 0.05)[None, :]
    def driven(way, known, seconds):
        return along_way(way, numpy.interp(seconds, known[1], known[0]))
    one = driven(points, own, begin + leads + time)
    braked = time + begin + leads - numpy.interp(comes_over(points, spot, strikes.size, others), *own) + FORESEEN if late else 0
    slowed = numpy.interp(other_begin + time, far[1], far[0]) - late / 2 * numpy.maximum(braked, 0) ** 2
    two = along_way(others, slowed + 0 * leads)
    hit = overlapping(one, strikes.size, two, struck.size)
    met = numpy.flatnonzero(hit.any(axis=1))
    if not len(met):  # they pass each other there, whenever they come
        return 0
    when = hit.argmax(axis=1)[met]
    one, two = [(here[met, when], along[met, when]) for here, along in (one, two)]
    turned = one[1][:, 0] * two[1][:, 1] - one[1][:, 1] * two[1][:, 0]
    left = turned[len(met) // 2] > 0
    apart = numpy.linalg.norm(spot_of(strikes, one, not left) - spot_of(struck, two, left), axis=-1)
    return leads[met[int(apart.argmin())], 0]

def _start_to_meet(lane, points, speed, others, from_, other_speed, ahead=0, clear=None, strikes=None, struck=None,
                   stop=None, held=1, slow=None, late=0, slows=None, moved=0):
    """How far (m) before the end of its lane a car starts on its points at `speed`, so that it comes to where they cross
    `others` `ahead` s before another that starts `from_` m along those at `other_speed`, if neither reacts.

    strikes, struck: the `Part` of it and that of the other that then touch, instead of both being there with their middles
    (`ahead` s before that). clear: s between one leaving the conflict area and the other's coming: over 0 where it goes
    first, under 0 where the other does (instead of `ahead`). stop, held, slow: how the other drives (as of
    `driving_times`); late: m/s2 at which it brakes once it is too late. slows: as
    `slow`, of its own. moved: m to the left of `points` that it drives.
    """
    points, near = (shifted(points, moved), min(2.2, abs(moved) - 0.4)) if moved else (points, 2.2)
    (begin, spot, end), (other_begin, other_spot, other_end) = conflict(lane, points, others, near)
    far, times = driving_times(others, other_speed, stop, held, slow)
    own, own_times = driving_times(points, speed, slow=slows)
    def due(station):
        return float(numpy.interp(station, far, times) - numpy.interp(from_, far, times))
    if clear is None:
        known = (own, own_times), (far, times)
        lead = strikes and lead_to_touch(points, known[0], spot, strikes, others, known[1], other_spot, struck, late) or 0
        station, time = spot, due(other_spot) - lead - ahead
    elif clear > 0:
        station, time = min(end, begin + 12) + 2.5, due(other_begin - 2.5) - clear
    else:
        station, time = begin - 2.5, due(min(other_end, other_begin + 12) + 2.5) - clear
    start = numpy.interp(numpy.interp(station, own, own_times) - time, own_times, own)
    return float(max(3, lane.centerline.length - start))

start_to_meet = distributionFunction(_start_to_meet)

def _setting_out_to_meet(lane, points, before, speed, other_lane, others, other_speed, strikes=None, struck=None,
                         late=0):
    """How far (m) another is from the end of `other_lane` when a car that stands with its middle `before` m before the
    stop line of its `lane` has to set out for `speed` to meet it; `strikes`, `struck` and `late` as of `start_to_meet`."""
    (_, spot, _), (_, other_spot, _) = conflict(lane, points, others)
    far, times = driving_times(others, other_speed)
    begin = stop_line(lane) - before
    time = setting_out(spot - begin, speed)
    if strikes:
        own = numpy.arange(begin, begin + 60, 1.0)
        known = own, [setting_out(metres - begin, speed) for metres in own]
        time += lead_to_touch(points, known, spot, strikes, others, (far, times), other_spot, struck, late)
    there = numpy.interp(numpy.interp(other_spot, far, times) - time, times, far)
    return float(max(1, other_lane.centerline.length - there))

setting_out_to_meet = distributionFunction(_setting_out_to_meet)

def shifted(points, metres):
    """A way so far (m) to the left of another."""
    ahead = [b - a for a, b in zip(points, points[1:] + [points[-1] * 2 - points[-2]])]
    return [p + d.normalized().rotatedBy(90 deg) * metres for p, d in zip(points, ahead)]


def _start_to_merge(place, speed, other_speed, from_, ahead, before_end=None):
    """How far (m) before the end of the ramp of `place` a car starts that drives at `speed`, so that its middle is
    `ahead` m ahead of that of another, which starts `from_` m along the lane of `place` and drives at `other_speed`, as it
    comes onto the acceleration lane, or `before_end` m before the end of that."""
    points, others = route(place.ramp), route(place.lane, place.turn)
    begins = place.ramp.centerline.length + place.merging.connectingLane.centerline.length
    spot = begins + 5
    if before_end is not None:
        spot = max(spot, begins + place.acceleration_lane.centerline.length - before_end)
    beside = place.lane.centerline.length + place.turn.connectingLane.centerline.length + spot - begins
    far, times = driving_times(others, other_speed)
    own, own_times = driving_times(points, speed)
    due = float(numpy.interp(beside - ahead, far, times) - numpy.interp(from_, far, times))
    start = numpy.interp(numpy.interp(spot, own, own_times) - due, own_times, own)
    return float(max(3, place.ramp.centerline.length - start))

start_to_merge = distributionFunction(_start_to_merge)


# Places: lanes by how they lie to ego's

def approach(ego_way, angle, turn, outer=False):
    """A lane that reaches the junction of `ego_way` turned by `angle` (degrees, anticlockwise) to ego's, for `turn`: of
    several one from where that leads over ego's way or onto its lane, with another to its left where `outer`."""
    def heading(lane):
        last = lane.centerline[-1] - lane.centerline[-2]
        return math.degrees(math.atan2(-last.x, last.y))
    def meets(lane):
        m = next(m for m in lane.maneuvers if m.type is turn)
        across = m.connectingLane.centerline.lineString.crosses(ego_way.connectingLane.centerline.lineString)
        return across or m.endLane is ego_way.endLane, outer and bool(lane.sections[-1]._fasterLane)
    fitting = []
    for lane in ego_way.intersection.incomingLanes:
        off = (heading(lane) - heading(ego_way.startLane) - angle + 180) % 360 - 180
        if abs(off) < 50 and any(m.type is turn for m in lane.maneuvers):
            fitting.append(lane)
    return max(fitting, key=meets, default=None)

def pocket(lane):
    """Where one waits whom others pass on an approach: the lane to the left of theirs, or the left side of their own;
    how far (m) it stands to the left of its middle there, clear of who comes the other way."""
    faster = lane and lane.sections[-1]._fasterLane
    return faster and (faster.lane, 0) or lane and (lane, 0.85)

def ring_approach(ego_way, angle):
    """A lane into the roundabout of `ego_way` whose arm is turned by `angle` (degrees, anticlockwise) to ego's."""
    def heading(lane):
        last = lane.centerline[-1] - lane.centerline[-2]
        return math.degrees(math.atan2(-last.x, last.y))
    ring = ego_way.endLane
    for i in range(8):
        others = [lane for lane in ring.maneuvers[0].intersection.incomingLanes if lane.group is not ring.group]
        for lane in others:
            if abs((heading(lane) - heading(ego_way.startLane) - angle + 180) % 360 - 180) < 50:
                return lane
        ring = min((m.endLane for m in ring.maneuvers), key=lambda lane: lane.centerline.length)

def _ring_lanes(net):
    """The manoeuvres in the roundabouts of a network, and the lanes between them."""
    ways = [m for i in net.intersections if i.id in map_facts().roundabouts for m in i.maneuvers]
    between = {m.startLane for m in ways} & {m.endLane for m in ways}
    return ways, {lane for lane in between if not (lane.road.forwardLanes and lane.road.backwardLanes)}

ring_lanes = functools.lru_cache(maxsize=4)(_ring_lanes)

def left_ring(car, beside=3):
    """Whether `car` has been in a roundabout and is out of it: more than so far (m) beside the ways round it."""
    ways, ring = ring_lanes(network)
    round = [m.connectingLane for m in ways if m.startLane in ring and m.endLane in ring]
    inside = any(lane.centerline.distanceTo(car.position) < beside for lane in (*ring, *round))
    car.in_ring = inside or simulation().currentTime > 0 and getattr(car, 'in_ring', False)
    return car.in_ring and not inside

def ring_exit(ego_way, bearing):
    """The lane by which one leaves the roundabout of `ego_way` nearest to `bearing` (rad, to the left), as `route` does."""
    line, lane = ego_way.startLane.centerline, ego_way.endLane
    goal = (line[-1] - line[-2]).rotatedBy(bearing)
    for _ in range(12):
        onward = _onward(lane, ManeuverType.STRAIGHT, goal)
        if lane not in ring_lanes(network)[1] or not onward:
            break
        lane = onward[0].endLane
    return lane

def ring_lane(ego_way):
    """The ring of the roundabout of `ego_way` up to where ego comes in: a lane over its junctions, nearly once round."""
    ways, ring = ring_lanes(network)
    into = {m.endLane: m for m in ways if m.startLane in ring and m.endLane in ring}
    lane = into[ego_way.endLane].startLane
    chain = [lane]
    while chain[0] in into and into[chain[0]].startLane not in (*chain, ego_way.endLane):
        chain = [into[chain[0]].startLane, into[chain[0]].connectingLane, *chain]
    return long_lane(lane, chain, joined([each.centerline for each in chain]))

def _beside(edge, lane, along, right):
    """The point `right` m to the right (below 0: to the left) of a line along the road, such as the edge of its lanes,
    next to where one is that is `along` m along a lane, or beyond its end: a crosswalk may lie there."""
    beyond = max(0, along - lane.centerline.length)
    spot = lane.centerline.pointAlongBy(along - beyond)
    return edge.project(spot).offsetRotated(network.roadDirection[spot], Vector(right, beyond))

def _heading_at(lane, along):
    """The direction of the road `along` m along a lane."""
    return network.roadDirection[lane.centerline.pointAlongBy(along)]

beside = distributionFunction(_beside)
heading_at = distributionFunction(_heading_at)

def along(lane, spot):
    """How far along a lane (m) the point nearest to a spot lies."""
    return min(range(int(lane.centerline.length)), key=lambda s: distance from spot to lane.centerline.pointAlongBy(s))

def bend_start(lane):
    """How far along a lane (m) its bend begins."""
    points = lane.centerline.pointsSeparatedBy(5)
    first = points[1] - points[0]
    turned = [k for k in range(1, len(points)) if abs(first.angleWith(points[k] - points[k - 1])) > 0.06]
    return 5 * turned[0] if turned else 0


# Long lanes: where roads are short, a lane goes on over several of them

ROADS, JUNCTIONS = 'roads', 'junctions'  # what a lane may go on over

class LongLane(object):
    """A lane with those before and behind it: what programs ask of a Lane, with edges that go as far as it does."""

class LongGroup(object):
    """The edges of the lanes beside a LongLane; `opposite`: of those in the other direction."""
    opposite = _opposite = None

def joined(lines):
    """One line of several, each going on where the last one ended."""
    points = [p for line in lines for p in line.lineString.coords]
    points = [p for k, p in enumerate(points) if k == 0 or math.dist(p[:2], points[k - 1][:2]) > 0.05]
    return PolylineRegion(points) if len(points) > 1 else lines[0]

def cut(line, low, high):
    """The part of a line between two distances (m) from its start."""
    low, high, gone, kept = max(low, 0), min(high, line.length), 0, []
    points = line.lineString.coords
    for k in range(1, len(points)):
        gone += math.dist(points[k - 1][:2], points[k][:2])
        kept += [points[k]] if low + 0.1 < gone < high - 0.1 else []
    return PolylineRegion([line.pointAlongBy(low), *kept, line.pointAlongBy(high)])

def onward(lane, junctions):
    """The manoeuvre from a lane's end onto the lane that goes on most nearly straight; over junctions if so wished."""
    fitting = [m for m in lane.maneuvers if not m.intersection or junctions and m.type is ManeuverType.STRAIGHT]
    last = lane.centerline[-1] - lane.centerline[-2]
    return min(fitting, key=lambda m: abs(last.angleWith(begin(m.endLane))), default=None)

INTO = {}
def leading_to(lane, junctions):
    """The manoeuvre by which the lane before a lane goes on onto it."""
    key = lane.network.lanes[0], junctions
    if key not in INTO:
        steps = [onward(other, junctions) for road in lane.network.roads for other in road.lanes]
        INTO[key] = {step.endLane: step for step in steps if step}
    return INTO[key].get(lane)

def chained(lane, metres, ahead, junctions):
    """A lane with those before it (`ahead`: behind it) until they are `metres` long, and how long they are."""
    chain, length = [lane], lane.centerline.length
    while length < metres and len(chain) < 40:
        if ahead:
            step = onward(chain[-1], junctions)
            added = step and [step.connectingLane, step.endLane]
        else:
            step = leading_to(chain[0], junctions)
            added = step and [step.startLane, step.connectingLane]
        added = [each for each in added or [] if each]
        if not added or any(each in chain for each in added):
            break
        chain = chain + added if ahead else added + chain
        length += sum(each.centerline.length for each in added)
    return chain, length

def reach(lane, metres, ahead=False, junctions=False):
    """How long (m) a lane could be made."""
    return chained(lane, metres, ahead, junctions)[1]

def lengthened(lane, metres, ahead=False, junctions=False):
    """The lane, made `metres` long by those that lead into it (`ahead`: that it leads into), or as long as those go;
    straight over junctions too where `junctions`. A lane that is so long already is given as it is."""
    chain, _ = chained(lane, metres, ahead, junctions)
    if len(chain) == 1:
        return lane
    line = joined([each.centerline for each in chain])
    return long_lane(lane, chain, cut(line, 0, metres) if ahead else cut(line, line.length - metres, line.length))

def long_lane(lane, chain, line):
    """A lane that goes along a line, over the lanes of a chain."""
    longer, group = LongLane(), LongGroup()
    longer.centerline = line
    longer.leftEdge, longer.rightEdge = (joined([e for each in chain for e in [side(each)]])
                                         for side in (lambda each: each.leftEdge, lambda each: each.rightEdge))
    longer.sections, longer.road, longer.maneuvers = lane.sections, lane.road, chain[-1].maneuvers
    longer.group, longer.network = group, lane.network
    group.lanes = lane.group.lanes
    group._shoulder, group._sidewalk = lane.group._shoulder, lane.group._sidewalk
    group.leftEdge = joined([each.group.leftEdge for each in chain])
    group.rightEdge = joined([each.group.rightEdge for each in chain])
    others = [each.group._opposite for each in reversed(chain) if each.group._opposite]
    if lane.group._opposite:
        group.opposite = group._opposite = LongGroup()
        group.opposite.lanes = lane.group._opposite.lanes
        group.opposite.leftEdge = joined([each.leftEdge for each in others])
        group.opposite.rightEdge = joined([each.rightEdge for each in others])
    return longer


# Driving

def nearest(car, points):
    """The index of the point nearest to `car`."""
    return nearest_to(car.position, points)

def nearest_to(spot, points):
    """The index of the point nearest to a spot."""
    return min(range(len(points)), key=lambda k: math.hypot(points[k].x - spot.x, points[k].y - spot.y))

def bend_speed(points, i):
    """The speed (m/s) that the bends of the next 60 m allow at 4 m/s2 sideways, braking at 2 m/s2."""
    fastest = 100
    for k in range(i, min(i + 30, len(points) - 4), 2):
        a, b, c = points[k], points[k + 2], points[k + 4]
        turn = math.atan2(c.y - b.y, c.x - b.x) - math.atan2(b.y - a.y, b.x - a.x)
        bend = abs((turn + math.pi) % (2 * math.pi) - math.pi) / 4
        fastest = min(fastest, math.sqrt(4 / max(bend, 0.001) + 8 * max(k - i - 1, 0)))
    return fastest

SIDEWAYS = 3  # m/s2 at which drivers begin to move aside, who are in no hurry

behavior Drive(points, speed, rate=3, offset=0, shift=2.2):
    """Follow points at `speed` (m/s, or a function that gives it), changing it by `rate` (m/s2, likewise); `offset` m
    (likewise) to their left, moving there from where it is, as onto another lane, at `shift` m/s, gained at `SIDEWAYS`.
    Pure pursuit, slower in bends."""
    i, last, held = nearest(self, points), len(points) - 1, self.speed
    self.points = points  # as others see where it goes
    self.cruise = math.inf if callable(speed) else speed
    left = (points[min(i + 1, last)] - points[min(i, last - 1)]).normalized().rotatedBy(90 deg)
    beside = max(-8, min(8, (self.position - points[i]).dot(left)))
    aside = max(-shift, min(shift, self.velocity.dot(left)))
    while True:
        while i < last - 1 and (distance from self to points[i + 2]) <= (distance from self to points[i]):
            i += 1
        goal = behind_those(self, points, speed() if callable(speed) else speed)
        goal = min(goal, bend_speed(points, i), math.sqrt(12 * max(last - i - 4, 0)))
        gained = max(SIDEWAYS, 2 * shift - 2) * simulation().timestep
        wanted = offset() if callable(offset) else offset
        aside += max(-gained, min(gained, max(-shift, min(shift, max(1.2, 0.6 * shift) * (wanted - beside))) - aside))
        beside += aside * simulation().timestep
        self.beside = beside
        ahead = min(i + 2 + int(0.35 * self.speed), last)
        along = (points[ahead] - points[max(ahead - 1, 0)]).normalized()
        there = beside + aside * (points[ahead] - self.position).dot(along) / max(self.speed, 4)  # by when it is there
        target = (points[ahead] + along.rotatedBy(90 deg) * there - self.position).rotatedBy(-self.heading)
        wheel = math.atan(1.2 * self.length * target.x / max(target.x ** 2 + target.y ** 2, 1))
        steer = wheel / (0.8 * max(0.48, 1 - 0.0125 * self.speed))  # wheels turn less far where it is fast
        held = held if abs(held - self.speed) < 0.3 else self.speed  # what it was told to be, but for air and wheels
        step = (rate() if callable(rate) else rate) * simulation().timestep
        held = max(0, held + max(-step, min(step, goal - held)))
        take SetSpeedAction(held), SetSteerAction(max(-1, min(1, steer)))

behavior Stop(points, rate=3, offset=0, shift=2.2):
    """Slow down by `rate` (m/s2) to a stand on the points, as `Drive` follows them, and stay there."""
    do Drive(points, 0, rate=rate, offset=offset, shift=shift)

behavior SlowTo(points, speed, rate=3, offset=0, shift=2.2):
    """`Drive` at a lower speed (m/s) until that is reached, to within 0.5 m/s."""
    do Drive(points, speed, rate=rate, offset=offset, shift=shift) until self.speed < speed + 0.5

behavior SpeedUpTo(points, speed, rate=3, offset=0, shift=2.2):
    """`Drive` at a higher speed (m/s) until that is reached, to within 0.5 m/s."""
    do Drive(points, speed, rate=rate, offset=offset, shift=shift) until self.speed > speed - 0.5

behavior Cruise(points, speed):
    """Follow points at `speed` (m/s) from the first."""
    take SetSpeedAction(speed)
    do Drive(points, speed)

behavior Skid(points, aside, rate=5, turn=0.6, target=None):
    """Slide as one does that has lost its grip, slowing down at `rate` (m/s2): askew, so as to come to a stand `aside` m
    to the left of the points, turned by `turn` rad to that side; or straight at a `target`, still at half of its speed
    there. Nothing is steered back."""
    metres, turned = self.speed ** 2 / (2 * rate), self.heading + math.copysign(turn, aside)
    k = min(nearest(self, points) + max(1, int(metres / 2)), len(points) - 2)
    end = target.position if target else points[k] + (points[k + 1] - points[k]).normalized().rotatedBy(90 deg) * aside
    rate = min(rate, 0.375 * self.speed ** 2 / max(distance from self to end, 1)) if target else rate
    course, speed = (end - self.position).normalized(), self.speed
    while speed > 0:
        speed = max(0, speed - rate * simulation().timestep)
        course = (end - self.position).normalized() if (distance from self to end) > 3 else course
        off = math.remainder(turned - self.heading, 2 * math.pi)
        take SetVelocityAction(course.x * speed, course.y * speed), SetSteerAction(max(-1, min(1, -2 * off)))
    while True:
        take SetSpeedAction(0), SetSteerAction(0)

def _those(threats):
    """Threats as a list: one, several, or a function that gives them as they are to be seen now."""
    found = threats() if callable(threats) else threats
    return found if isinstance(found, list) else [found]

def _gone_by(car, walkers):
    """Whether all of them have gone by, with room, where `car` waits."""
    return braking_needed(car, walkers) <= 0 and all(passed(one, car, margin=2.5) for one in walkers)

behavior BrakeFor(points, threats, least=2, release=0, stands=None):
    """Brake for one, several, or those that a function gives: a little harder than it takes, with `least` m/s2 or more at
    first, until it takes no more than `release`; with `stands` to a stand, and until it takes no more than that. From then
    on it keeps behind those that drive ahead of it."""
    enough, slow = (release, math.inf) if stands is None else (stands, 0.2)
    eased, least = (0.6 * self.speed, least) if stands is None else (0, max(least, 2.5))
    needed = lambda: max(1.1 * braking_needed(self, threats), needed_short_of_ways(self, points, _those(threats)))
    rate = lambda: max(least if self.speed > eased else min(least, 1), min(9 if self.speed > 2 else 4, needed()))
    do Drive(points, 0, rate=rate) until self.speed < slow and no_closer(self, points, threats, enough)
    self.braked_for = threats

behavior EmergencyStop(points, threats, rate=8):
    """Brake with all that the road holds (m/s2), from `REACTION_TIME` on, to a stand, and stay there while they are in
    the way; where they drive on ahead, until they are faster, and keep behind them."""
    do Drive(points, self.speed) for REACTION_TIME seconds
    do Drive(points, 0, rate=rate) until self.speed < 0.2 or draw_away(self, _those(threats))
    if self.speed < 0.2:
        do Drive(points, 0) for 1 seconds
        do Drive(points, 0) until braking_needed(self, threats) <= 0 and not blocked(self, _those(threats))
    self.braked_for = threats

behavior BrakeTooLate(points, lead, speed, left):
    """Drive on behind one that comes to a stand, brake when it is too late, and reach it, once it stands, at no more than
    `left` m/s."""
    needed = lambda: braking_to_hit_standing(self, lead, left)
    do Drive(points, speed) until needed() > TOO_LATE
    do Drive(points, ROLLS_INTO, rate=needed)

behavior YieldTo(points, walkers, speed, rate=3.5, stands=False, room=3):
    """Slow down from `speed` so as to stop `room` m short of those on foot, braking at `rate` m/s2, until they have gone
    by; come to a stand first where it `stands`."""
    slow = 0.2 if stands else math.inf
    pace = lambda: 0 if stands and _gone_by(self, walkers) else short_of(self, points, walkers, speed, rate, room)
    do Drive(points, self.speed) for REACTION_TIME seconds
    do Drive(points, pace, rate=9) until self.speed < slow and _gone_by(self, walkers)
    if stands:
        do Drive(points, 0) for 1 seconds

behavior StopBefore(points, others, room=3, rate=None):
    """Come to a stand `room` m short of others or, where they cross, of their ways: braking at `rate` m/s2 as late as
    that allows, or evenly, from `REACTION_TIME` on."""
    speed = self.speed
    do Drive(points, speed) for REACTION_TIME seconds
    left = lambda: rest_to(self, points, others, room + ROLLS)
    evenly = rate or max(1.5, min(9, speed ** 2 / (2 * max(left(), 0.1))))
    do Drive(points, lambda: up_to(left(), speed, evenly), rate=9) until self.speed < 0.2

behavior StopAtLine(points, lane, speed, rate=3):
    """Come to a stand at the stop line of a lane, braking at `rate` m/s2."""
    do Drive(points, lambda: up_to(to_line(self, lane), speed, rate), rate=rate + 2.5) until self.speed < 0.2

behavior TurnRound(speed=4, rate=5):
    """Turn left on the spot until the car faces the way that it came from; the wheels turn as far as its speed lets them
    while it changes that by `rate` (m/s2)."""
    begin, held, step = self.heading, self.speed, rate * simulation().timestep
    while math.cos(self.heading - begin) > -0.94:
        held += max(-step, min(step, speed - held))
        take SetSpeedAction(held), SetSteerAction(-0.55 * min(1, (speed / max(held, 1)) ** 2))

behavior Backwards(speed, steer=0):
    """Reverse at a speed (m/s), gained and lost at 3 m/s2; `steer` over 0 takes the tail to the right."""
    while True:
        step = 3 * simulation().timestep
        gained = self.speed + max(-step, min(step, speed - self.speed))
        take SetReverseAction(True), SetSteerAction(steer), SetSpeedAction(-gained)

behavior BackInto(other, speed):
    """Reverse at `speed` (m/s) with the tail towards `other`."""
    while True:
        place = (other.position - self.position).rotatedBy(-self.heading)
        steer = place.x / max(abs(place.y), 3)
        take SetReverseAction(True), SetSteerAction(max(-0.8, min(0.8, steer))), SetSpeedAction(-speed)

SWINGS = 4  # m/s2 at which one that leaves its way for what it hits turns at most

def leaves_for(car, points, other):
    """How far (m) before `other`, beside the way of points, `car` leaves it so as to hit it, turning no harder than
    `SWINGS` m/s2."""
    return max(15 + 1.5 * car.speed, car.speed * math.sqrt(2 * along_line(points, other.position)[1] / SWINGS))

def near(car, other):
    """Whether `car` and `other` would touch within about a second if one turned to the other."""
    return (distance from car to other) < 8 + (car.velocity - other.velocity).norm()

def touch(car, other):
    """Whether `car` and `other` are in contact, seen as boxes along the road of `car`."""
    place = (other.position - car.position).rotatedBy(-car.heading)
    across = abs(math.sin(other.heading - car.heading))
    long, wide = (other.length * (1 - across) + other.width * across, other.width * (1 - across) + other.length * across)
    return abs(place.y) < (car.length + long) / 2 and abs(place.x) < (car.width + wide) / 2 + 0.2

behavior Ram(other, speed, rate=5):
    """Drive at where `other` will be when it is reached, at `speed` (m/s), changing it by at most `rate` (m/s2): beside
    it as fast as that one, and slower where it comes from behind."""
    while True:
        place = (other.position - self.position).rotatedBy(-self.heading)
        motion = other.velocity.rotatedBy(-self.heading)
        time = max(0, min(1.5, place.y / max(self.speed - motion.y, 3)))
        aim = place + motion * time
        steer = math.atan(1.2 * self.length * aim.x / max(aim.x ** 2 + aim.y ** 2, 1)) / 0.8
        goal = max(speed, motion.y + 3)
        if abs(place.y) < self.length and motion.y > 1:
            goal = motion.y
        elif place.y < 0:
            goal = max(0, motion.y - 3)
        step = rate * simulation().timestep
        take (SetSpeedAction(max(0, self.speed + max(-step, min(step, goal - self.speed)))),
              SetSteerAction(max(-1, min(1, steer))))


# On foot, and across the road

behavior Walk(heading, speed, metres=math.inf):
    """Walk so far (m) in a direction (rad) at a speed (m/s), and stand there."""
    begin = self.position
    while (distance from self to begin) + speed * simulation().timestep / 2 < metres:
        take SetWalkingDirectionAction(heading), SetWalkingSpeedAction(speed)
    take SetWalkingSpeedAction(0)

behavior Stand():
    """Stand, on foot."""
    while True:
        take SetWalkingSpeedAction(0)

def along_line(points, spot):
    """How far (m) along points 2 m apart the one nearest to a spot is, and how far (m) that is from the spot."""
    k = min(range(len(points)), key=lambda k: (points[k].x - spot.x) ** 2 + (points[k].y - spot.y) ** 2)
    onward = (points[min(k + 1, len(points) - 1)] - points[max(k - 1, 0)]).normalized()
    return 2 * k + (spot - points[k]).dot(onward), abs((spot - points[k]).dot(onward.rotatedBy(90 deg)))

def lately(car, seconds):
    """The speeds (m/s) of `car` now and, as far as it was looked at, in the last seconds; not those of the first step."""
    now, step = simulation().currentTime, simulation().timestep
    known = getattr(car, 'speeds', {}) if now > 1 else {}
    car.speeds = {time: speed for time, speed in known.items() if now - 6 / step <= time < now} | {now: car.speed}
    return [speed for time, speed in car.speeds.items() if now - seconds / step <= time]

def sets_off(car):
    """Whether `car` has just set out and gains speed."""
    return car.speed < 3 and car.speed > min(lately(car, 0.2)) + 0.02

def slows_down(car, least=1):
    """Whether `car` is, or was in the last seconds, slower by so much (m/s) than shortly before, as can be seen."""
    return car.speed < max(lately(car, 6)) - least

def speeds_up(car, least=0.5):
    """Whether `car` is faster by so much (m/s) than in the last seconds, as can be seen."""
    return car.speed > min(lately(car, 6)) + least

def slowing(car, seconds=0.5):
    """The deceleration (m/s2) of `car` in the last so many seconds; 0 where it was not looked at then."""
    lately(car, seconds)
    then = simulation().currentTime - round(seconds / simulation().timestep)
    return max(0, (car.speeds[then] - car.speed) / seconds) if then in car.speeds else 0

def seconds_to(car, points, metres):
    """The time (s) until the front of `car` is so far (m) along its points, if it goes on as it does: slower in bends,
    and gaining 2 m/s2 where it has just set out, up to the speed that it drives at."""
    here, time, speed = along_line(points, car.position)[0] + car.length / 2, 0, max(car.speed, 0.3)
    rising, top = sets_off(car), max(car.speed, min(8, getattr(car, 'cruise', 8)))
    while here < metres:
        if rising:
            speed = min(math.sqrt(speed ** 2 + 8), top)
        step = min(2, metres - here)
        time += step / min(speed, bend_speed(points, int(here / 2)))
        here += step
    return time

def sets_out(self, car, points, speed, arrives, rate=math.inf, metres=None):
    """Whether one beside the road has to set out across it now, at `speed` (m/s, gained at `rate` m/s2), to be in the
    middle of the way of `car`, its points, `arrives` s after its front would be there, or so many metres on; or `car`
    stands for it already."""
    there, across = along_line(points, self.position)
    metres = across if metres is None else metres
    gained = speed ** 2 / (2 * rate)
    time = metres / speed + speed / (2 * rate) if metres > gained else math.sqrt(2 * metres / rate)
    if car.speed < 0.3:
        return clock() > 1.5 and (distance from self to car) < 25
    return seconds_to(car, points, there) < time - arrives + simulation().timestep / 2

def pulls_out(self, car, points, rate, arrives):
    """Whether one at the kerb has to drive off now, gaining `rate` m/s2, for its front to be in the way of `car`, its
    points, `arrives` s after the front of that would be there; or `car` stands for it already."""
    there, metres = along_line(points, self.position)
    time = math.sqrt(2 * 2.2 * max(metres - (self.width + car.width) / 2, 0.5) / rate)  # 2.2 m on for 1 m aside
    if car.speed < 0.3:
        return clock() > 1.5 and (distance from self to car) < 25
    there += self.length / 2 + rate * time ** 2 / 2
    return seconds_to(car, points, there) < time - arrives + simulation().timestep / 2

def way_round(car, points, others, side=0, room=0.8):
    """How far (m) to the left of its points `car` gets past those of the others that are in its way, with `room` m
    between: on the `side` (1 left, -1 right), or where that takes less; 0: nobody is."""
    here, ways = along_line(points, car.position)[0], []
    for other in others:
        there = along_line(points, other.position)[0]
        if not -other.length < there - here < 100:
            continue
        k = min(int(there / 2), len(points) - 2)
        left = (points[k + 1] - points[k]).normalized().rotatedBy(90 deg)
        aside, moves = (other.position - points[k]).dot(left), other.velocity.dot(left)
        across = abs(math.sin(other.heading - math.atan2(left.y, left.x)))
        half = (other.width * (1 - across) + other.length * across + car.width) / 2 + room
        ways.append((aside + min(moves, 0) - half, aside + max(moves, 0) + half))
    low, high = min([0, *[w[0] for w in ways]]), max([0, *[w[1] for w in ways]])
    if not any(w[0] < 0 < w[1] for w in ways):
        return 0
    return (high if side > 0 else low) if side else min(low, high, key=abs)

def passing_by(car, other, metres):
    """How far (m) to the left of its points `car` is that comes up to another from behind and passes it `metres` to the
    left: in the lane of that one until it is near."""
    behind = -ahead_by(car, other) - car.length - other.length
    return metres if behind < 4 + 2.5 * max(car.speed - other.speed, 1) else 0

def leaving_room(car, points, other, room):
    """How far (m) to the left of its points `car` goes by another so that exactly `room` m are between them, on the side
    of its points; 0 while that is over 60 m ahead, or has been passed."""
    here, there = along_line(points, car.position)[0], along_line(points, other.position)[0]
    if not -other.length - car.length < there - here < 60:
        return 0
    k = max(0, min(int(there / 2), len(points) - 2))
    left = (points[k + 1] - points[k]).normalized().rotatedBy(90 deg)
    aside = (other.position - points[k]).dot(left)
    across = abs(math.sin(other.heading - math.atan2(left.y, left.x)))
    half = (other.width * (1 - across) + other.length * across + car.width) / 2 + room
    return aside + half if aside < 0 else aside - half

def to_far_side(self, points, heading):
    """How far (m) it is in a direction (rad), over the way of a car, its points, until a little off the road."""
    metres = along_line(points, self.position)[1]
    def on_road(spot):
        return network.drivableRegion.containsPoint(spot) or network.shoulderRegion.containsPoint(spot)
    while metres < 60 and on_road(self.position.offsetRotated(heading, Vector(0, metres))):
        metres += 0.5
    return metres + 1.5


# Lights: where a simulator has them, as CARLA does

def to_kerb(self, heading, room):
    """How far (m) it is in a direction (rad) to `room` m before the edge of the driving lanes."""
    def on_lane(metres):
        return network.laneRegion.containsPoint(self.position.offsetRotated(heading, Vector(0, metres)))
    return max(0, next((k / 10 for k in range(200) if on_lane(k / 10)), 0) - room)

monitor Lights(turn=None, shown='green', turns_green=False):
    """Traffic lights that suit who is on the way: everybody who drives comes to green ones. Where ego's `turn`
    (a manoeuvre) leads over a junction, its approach and the one opposite show `shown` ('green', 'yellow', 'red',
    'off'), those across what goes with that, and who is given a `light` of its own (`with light 'red'`) has that. turns_green:
    once ego stands. Without a `turn` all lights are as `shown`."""
    heading_for = {}
    if hasattr(simulation(), 'world'):
        simulation().world.freeze_all_traffic_lights(True)
    while hasattr(simulation(), 'world'):
        if turns_green and ego.speed < 0.3 and simulation().currentTime > 0:
            heading_for, shown, turns_green = {}, 'green', False
        for car in [thing for thing in simulation().objects if getattr(thing, 'isVehicle', False)]:
            if heading_for.get(id(car)) is not car._lane:
                heading_for[id(car)] = car._lane
                set_light(car, light_for(car, turn, shown))
        wait

def junction_ahead(lane):
    """The junction that a lane leads to, over further roads, and the last lane before it; None, None: to none."""
    for _ in range(20):
        if not lane or not lane.maneuvers:
            break
        if lane.maneuvers[0].intersection:
            return lane.maneuvers[0].intersection, lane
        lane = lane.maneuvers[0].endLane
    return None, None

def light_for(car, turn, shown):
    """What the light that `car` comes to is to show; `turn` and `shown` as of `Lights`."""
    junction, lane = junction_ahead(car._lane)
    if turn is None:
        return getattr(car, 'light', shown)
    if junction is not turn.intersection:
        return 'green'
    own, egos = [line[-1] - line[-2] for line in (lane.centerline, turn.startLane.centerline)]
    if abs(math.sin(own.angleWith(egos))) > 0.7 and shown != 'off':
        shown = 'green' if shown == 'red' else 'red'
    return getattr(car, 'light', shown)

def set_light(car, colour, within=500):
    """Set the light that faces `car`, at most so far (m) ahead; where there is none, nothing."""
    from scenic.simulators.carla.utils.utils import scenicToCarlaTrafficLightStatus
    here = simulation().map.get_waypoint(car.carlaActor.get_transform().location)
    ahead = here.get_landmarks_of_type(within, '1000001') if here else []
    if ahead:
        light = simulation().world.get_traffic_light(min(ahead, key=lambda mark: mark.distance))
        if light:
            light.set_state(scenicToCarlaTrafficLightStatus(colour))


# How one stands to another

def clock():
    """The time (s) since the run began."""
    return simulation().currentTime * simulation().timestep

def draw_away(car, others):
    """Whether others drive on ahead of the car, faster than it."""
    return bool(others) and all(other.velocity.rotatedBy(-car.heading).y > max(car.speed, 3) + 1 for other in others)

SPARE = 0.6  # s by which one that crosses has to be gone, or not yet there

def _needed(car, other):
    """The deceleration (m/s2) that keeps `car` from reaching `other`, if both go on as they do (one close ahead that slows
    down, to a stand), and at least as much as that one slows down with; 0: no conflict, or one that crosses can still
    stop at its line, or the very beginning, when not all have their speed yet."""
    if clock() < 0.15:
        return 0
    place = (other.position - car.position).rotatedBy(-car.heading)
    motion = other.velocity.rotatedBy(-car.heading)
    across, vehicle = abs(math.sin(other.heading - car.heading)), getattr(other, 'isVehicle', False)
    in_lane = across < 0.5 and vehicle and not off_lane(other, 0.9)
    if in_lane:
        motion = Vector(0, motion.y)  # nobody can see yet that it is leaving its lane
    gap = place.y - (car.length + other.width * across + other.length * (1 - across)) / 2
    closing = car.speed - motion.y
    room = 0.4 if other.speed < 0.3 and vehicle else 0.8  # m, at least
    room = 0.25 if in_lane else room + SPARE * abs(motion.x) * across * bool(vehicle)  # it may come sooner or later
    reach = (car.width + other.length * across + other.width * (1 - across)) / 2 + room
    if place.y <= 0 or across > 0.5 and vehicle and could_stop(other):
        return 0
    if gap < 8 and car.speed < 2 and motion.y < 1 and abs(place.x) < reach:
        return 9
    braking = slowing(other) if across < 0.5 and motion.y > 0 and abs(place.x) < reach and gap < CLOSE * car.speed else 0
    least = 0
    if braking > 2:  # as much as it, or what stops behind it where it will stand
        left = max(gap - 2 + motion.y ** 2 / (2 * braking), 0.3)
        least = max(min(braking, 5.8) if gap < NEAR * car.speed else 0, min(9, car.speed ** 2 / (2 * left)))
    if closing <= 0.1:
        return least
    there = place.x + motion.x * max(gap, 0) / closing
    gone = place.x + motion.x * (max(gap, 0) + car.length + other.width) / closing
    if min(there, gone) > reach or max(there, gone) < -reach:
        return least
    keeps = min(KEEPS, closing ** 2 / (2 * max(gap - 2 - 0.5 * max(motion.y, 0), 0.3)))
    return max(least, keeps, closing ** 2 / (2 * max(gap - 2, 0.3)))

def braking_to_hit(car, other, speed):
    """The deceleration (m/s2, no more than tyres hold) at which `car` reaches `other`, ahead of it or about to be, at `speed`
    (m/s), if that goes on as it does."""
    across, own = abs(math.sin(other.heading - car.heading)), other.velocity.rotatedBy(-car.heading).y
    long = (car.length + other.width * across + other.length * (1 - across)) / 2
    rest = max((other.position - car.position).rotatedBy(-car.heading).y - long - 0.2, 0.5)
    return max(0.1, min(8, ((car.speed - own) ** 2 - max(speed - own, 0) ** 2) / (2 * rest)))

def braking_to_hit_standing(car, lead, speed):
    """The same for one ahead that comes to a stand: where it will stand, and not before it does."""
    own, rest, braking = lead.speed, gap(car, lead), slowing(lead)
    if own < 0.3 or braking < 1:
        return braking_to_hit(car, lead, speed)
    seconds, rest = own / braking + AFTER_IT, rest + own ** 2 / (2 * braking)
    at_all, no_sooner = (car.speed ** 2 - speed ** 2) / (2 * rest), 2 * (car.speed * seconds - rest) / seconds ** 2
    if no_sooner * seconds > car.speed:  # it all but stands before
        no_sooner = car.speed ** 2 / (2 * max(rest - 1, 0.2))
    return max(0.1, min(8, max(at_all, no_sooner)))

KEEPS = 4  # m/s2 at most with which one brakes only so as to keep half a second behind another
CLOSE = 2.5  # s behind another within which one brakes as soon as that does
NEAR = 1.2  # s behind another within which one brakes as hard as that does

def in_way(points, other, room=1, seconds=0):
    """Whether `other` is within `room` m of the middle of a way, its points, or comes there in so many seconds."""
    line, box = shapely.geometry.LineString([(p.x, p.y) for p in points]), _box(other)
    there = shapely.affinity.translate(box, other.velocity.x * seconds, other.velocity.y * seconds)
    return line.distance(box.union(there).convex_hull if seconds else box) < room

TOO_LATE = 5  # m/s2 that it takes when somebody who does not look notices that the one ahead stops
AFTER_IT = 0.6  # s after that one stands
ROLLS_INTO = 1.5  # m/s at which it still hits that one
REACTION_TIME = 0.3  # s from when somebody comes into view to a reaction
ROLLS = 0.1  # m that one still rolls below the speed at which it counts as standing

def noticed(car, others, overlooked):
    """Those of the others whom `car` has not `overlooked` (a function of one) for `REACTION_TIME`."""
    now = clock()
    car.unseen_at = getattr(car, 'unseen_at', {}) if now > 0 else {}
    for other in others:
        if overlooked(other):
            car.unseen_at[id(other)] = now
    return [other for other in others if now - car.unseen_at.get(id(other), -1) >= REACTION_TIME]

def in_view(car, others, hiders):
    """Those of the others whom none of the hiders has hidden from `car` for `REACTION_TIME`."""
    return noticed(car, others, lambda other: any(hides(it, car.position, other.position) for it in hiders))

def in_fog(car, others, sight):
    """Those of the others who have been within sight (m) of `car` for `REACTION_TIME`."""
    return noticed(car, others, lambda other: gap(car, other) > sight)

def could_stop(car, rate=7):
    """Whether a vehicle on its way to a junction can still come to a stand before its line, braking at `rate` (m/s2):
    nobody can see yet that it will not."""
    lane = car._lane
    if lane is None or car._intersection or not any(m.intersection for m in lane.maneuvers):
        return False
    if abs(math.sin(car.heading - network.roadDirection[car.position].yaw)) > 0.5:  # it goes across its lane
        return False
    return to_line(car, lane) > car.speed ** 2 / (2 * rate)

def hides(thing, eye, spot):
    """Whether the line of sight to a spot goes through a thing, seen from above."""
    start, way = (eye - thing.position).rotatedBy(-thing.heading), (spot - eye).rotatedBy(-thing.heading)
    enters, leaves = 0, 1
    for begin, step, half in ((start.x, way.x, thing.width / 2), (start.y, way.y, thing.length / 2)):
        if abs(step) < 0.001:
            step = 0.001
        first, last = sorted(((-half - begin) / step, (half - begin) / step))
        enters, leaves = max(enters, first), min(leaves, last)
    return enters < leaves

def blocked(car, others, within=40):
    """Whether one of the others stands in the way of `car`, at most so far (m) ahead."""
    places = [(other, (other.position - car.position).rotatedBy(-car.heading)) for other in others if other.speed < 1]
    return any(0 < place.y < within and abs(place.x) < (car.width + other.width) / 2 + 0.5 for other, place in places)

def braking_needed(car, others):
    """The deceleration (m/s2) that keeps `car` from reaching any of others: one, several, or a function that gives them;
    0: no conflict."""
    return max([0, *[_needed(car, other) for other in _those(others)]])

def backs(other, car):
    """Whether `other` moves backwards or, on foot, away from the way of `car`."""
    if getattr(other, 'isVehicle', False):
        return other.velocity.rotatedBy(-other.heading).y < -0.3
    place, motion = [v.rotatedBy(-car.heading) for v in (other.position - car.position, other.velocity)]
    return place.x * motion.x > 0 and abs(motion.x) > 0.3

def passed(other, car, further=10, margin=1):
    """Whether `other` has gone `margin` m past the spot `further` m ahead of `car`, seen along its own way."""
    spot = car.position.offsetRotated(car.heading, Vector(0, further))
    return (spot - other.position).rotatedBy(-other.heading).y < -other.length / 2 - margin

def has_crossed(car):
    """Whether `car` has been in a junction and has left it; asked all along, from before it comes there."""
    now = simulation().currentTime
    car.entered = car._intersection is not None or now > 0 and getattr(car, 'entered', False)
    return car.entered and car._intersection is None

def gap(car, other):
    """The distance (m) from bumper to bumper: between the boxes of `car` and `other`, 0 where they touch."""
    return _box(car).distance(_box(other))

def _box(thing):
    """The box of an object on the ground."""
    corners = [Vector(x * thing.width / 2, y * thing.length / 2).rotatedBy(thing.heading) for x, y in CORNERS]
    return shapely.geometry.Polygon([(thing.position.x + c.x, thing.position.y + c.y) for c in corners])

def ttc(car, other):
    """The time (s) until the fronts of `car` and `other` would meet, or until they would be nearest to one another where
    their ways cross, if both went on as they do."""
    apart, closing = other.position - car.position, car.velocity - other.velocity
    speed = closing.norm()
    rest = apart.dot(closing) / speed if speed > 0.1 else 0
    return max(rest - (car.length + other.length) / 2, 0) / speed if rest > 0 else 1000

def lead_on(car, other):
    """How far (m) `car` is ahead of `other` along the road; negative: behind."""
    return (car.position - other.position).rotatedBy(-other.heading).y

def ahead_by(car, other, seconds=0):
    """How far (m) the rear of `car` is ahead of the front of `other` along the road, whatever the lane, now or in some
    seconds if both go on as they do; below 0 where it is not wholly ahead."""
    return lead_on(car, other) - (car.length + other.length) / 2 + (car.speed - other.speed) * seconds

def off_lane(car, metres=0.3):
    """Whether `car` has begun to leave the middle of its lane: whether it is over so many metres beside it."""
    lane = network.laneAt(car.position)
    return lane is None or lane.centerline.distanceTo(car.position) > metres

def clear_of_lanes(car, room=0.3):
    """Whether `car` is beside all lanes with its whole body, and so many metres more to either side."""
    side = car.width / 2 + room
    corners = [Vector(x * side, y * car.length / 2).rotatedBy(car.heading) for x, y in CORNERS]
    return all(network.laneAt(car.position + corner) is None for corner in corners)

def turns_round(car, least=0.15):
    """Whether `car` drives, turned out of the direction of its road by `least` rad or more."""
    return car.speed > 0.5 and abs(math.sin(car.heading - network.roadDirection[car.position].yaw)) > math.sin(least)


# Speeds (m/s) for Drive that depend on another

FALLS_BACK = 1.5  # m/s by which one is slower than whom it follows too closely
CALM_BRAKING = 2.5  # m/s2 with which one brakes behind another that slows down

def following_speed(car, lead, speed, headway=1.5, standstill_gap=4, points=None):
    """The speed (m/s) at which `car` follows `lead` at `standstill_gap` m and a time headway (s) more, at most `speed`; not one
    that it has passed, nor, where its `points` are given, one that is not in that way. Where it is too near it falls back
    gently."""
    if lead_on(car, lead) > 0 or points and not in_way(points, lead):
        return speed
    room = (distance from car to lead) - (car.length + lead.length) / 2 - standstill_gap
    slack = CALM_BRAKING * headway
    safe = math.sqrt(max(slack ** 2 + lead.speed ** 2 + 2 * CALM_BRAKING * room, 0)) - slack  # so that it can stop behind it
    wanted = min(speed, max(safe, lead.speed - FALLS_BACK))
    return wanted if wanted > 0.6 or lead.speed > 0.3 and wanted > 0 else 0

def behind_those(car, points, speed):
    """The speed (m/s), at most `speed`, at which `car` goes on along its points behind those that it has braked for and
    that drive ahead of it there."""
    if clock() <= 0:
        car.braked_for = []
    for other in _those(getattr(car, 'braked_for', [])):
        if drives_there(car, points, other):
            speed = min(speed, following_speed(car, other, speed, headway=1))
    return speed

def drives_there(car, points, other):
    """Whether another is on the points of `car`, in its direction."""
    beside = along_line(points, other.position)[1] - (car.width + other.width) / 2
    return other is not car and beside < 0.8 and math.cos(other.heading - car.heading) > 0.7

def no_closer(car, points, others, enough):
    """Whether `car` has braked enough for others: those on its points it can follow from now on, and the rest take no
    more than so many m/s2."""
    ahead = [other for other in _those(others) if drives_there(car, points, other)]
    rest = [other for other in _those(others) if other is not car and other not in ahead]
    rest_needed = max(braking_needed(car, rest), needed_short_of_ways(car, points, rest))
    return rest_needed <= enough and braking_needed(car, ahead) <= max(enough, 1) and all(
        car.speed <= following_speed(car, other, math.inf, headway=1) + 0.3 for other in ahead)

def up_to(rest, speed, rate=2.5):
    """The speed (m/s), at most `speed`, at which one comes to a stand after the rest (m) of its way, braking at `rate`
    (m/s2)."""
    return min(speed, math.sqrt(2 * rate * max(rest, 0)))

def _stop_line(lane):
    """How far along a lane (m) its stop line lies: before the crosswalk at its end, if there is one."""
    return min(_crosswalk_of(lane) - 3, lane.centerline.length - 1)

stop_line = distributionFunction(_stop_line)

def _crosswalk_of(lane):
    """How far along a lane, or straight on beyond it, (m) the middle of the crosswalk at its end lies."""
    return map_facts().crosswalk_on(lane) or lane.centerline.length + 2

crosswalk_of = distributionFunction(_crosswalk_of)

def _far_edge(lane):
    """The edge of the road to the left of a lane: beyond the lanes of the other direction, where there are any."""
    return lane.group._opposite.rightEdge if lane.group._opposite else lane.group.leftEdge

far_edge = distributionFunction(_far_edge)

def to_line(car, lane):
    """How far (m) the front of `car` is from the spot before the stop line of a lane where one stands."""
    return stop_line(lane) - 1 - lane.centerline.lineString.project(shapely.geometry.Point(*car.position[:2])) - car.length / 2

def rest_to(car, points, others, room):
    """How far (m) the front of `car` is along its points from `room` m before the nearest of the others, or of the ways
    by which they cross; infinite where there are none."""
    def half(other):
        across = abs(math.sin(other.heading - car.heading))
        return (other.width * across + other.length * (1 - across)) / 2
    here = along_line(points, car.position)[0] + car.length / 2
    return min((along_line(points, other.position)[0] - half(other) - room - here for other in others), default=math.inf)

def short_of(car, points, others, speed, rate=3, room=3):
    """The speed (m/s), at most `speed` and gained gently, at which `car` comes to a stand `room` m before whoever of the
    others has not gone by, or is on its way."""
    ahead = [other for other in others if along_line(points, other.position)[1] < (car.width + other.width) / 2
             or not passed(other, car, margin=2.5)]
    gently = min(speed, car.speed + 2 * simulation().timestep)
    return up_to(rest_to(car, points, ahead, room), gently, rate)

def short_of_ways(car, points, others, speed, rate=2.5, room=1):
    """The speed (m/s), at most `speed` and gained gently, at which `car` comes to a stand `room` m before its points lead
    it into the ways of those of the others that have not gone by there."""
    rests = [rest for rest, to_go in [meets_way(car, points, other) for other in others] if to_go > 0]
    gently = min(speed, car.speed + 2 * simulation().timestep)
    return up_to(min(rests) - room, gently, rate) if rests else gently

def needed_short_of_ways(car, points, others):
    """The deceleration (m/s2) with which `car` stops before its points lead it into the ways of those of the others that
    drive across in front of it."""
    crossing = [o for o in others if getattr(o, 'isVehicle', False) and o.speed > 0.5 and not could_stop(o)
                and abs(math.sin(o.heading - car.heading)) > 0.3]
    rests = [rest for rest, to_go in [meets_way(car, points, other) for other in crossing] if rest > 0 < to_go]
    return car.speed ** 2 / (2 * max(min(rests) - 2, 0.3)) if rests else 0

def needed_before_turn(car, points, other):
    """The deceleration (m/s2) with which `car` stops before its points lead it across the way of one beside or behind
    it that would be there together with it; 0: that one would not."""
    rest, to_go = meets_way(car, points, other)
    there, gone = rest / max(car.speed, 0.5), to_go / max(other.speed, 0.5)
    comes = gone - (8 + other.length + car.width) / max(other.speed, 0.5)
    if not rest > 0 < to_go or gone < there - SPARE or comes > there + (car.length + 2) / max(car.speed, 0.5) + SPARE:
        return 0
    return car.speed ** 2 / (2 * max(rest - 1, 0.3))

def clear_of_ways(car, points, others):
    """Whether all of the others have gone by where the points of `car` lead it into their ways."""
    return all(meets_way(car, points, other)[1] <= 0 for other in others)

def meets_way(car, points, other):
    """How far (m) the front of `car` is from where it comes into the way of `other`, and the rear of that one from having
    gone by there; -1 where their ways do not meet."""
    way = getattr(other, 'points', None) or straight_on(other)
    known = car.met = getattr(car, 'met', {}) if clock() > 0 else {}
    if (id(points), id(way)) not in known:
        moved = shifted(way, getattr(other, 'beside', 0))
        own, far = [shapely.geometry.LineString([(p.x, p.y) for p in line]) for line in (points, moved)]
        aside = (car.width + other.width) / 2 + 0.3
        inside = [k for k in range(nearest(car, points), len(points))
                  if far.distance(shapely.geometry.Point(points[k].x, points[k].y)) < aside]
        known[id(points), id(way)] = inside and (2 * inside[0], far.project(shapely.geometry.Point(*points[inside[0]][:2])), moved)
    if not known[id(points), id(way)]:
        return math.inf, -1
    begin, there, moved = known[id(points), id(way)]
    rest = begin - along_line(points, car.position)[0] - car.length / 2
    return rest, there + 8 + other.length / 2 - along_line(moved, other.position)[0]


# Places: where on a map a scenario can take place, told by what is there. Each function lists all that fit:
#     place = Uniform(*junctions(STRAIGHT, control='signal', others=[From('left', STRAIGHT)]))
#     ego = new Car at place.lane.centerline.pointAlongBy(place.length - 40)

STRAIGHT, LEFT_TURN = ManeuverType.STRAIGHT, ManeuverType.LEFT_TURN
RIGHT_TURN, U_TURN = ManeuverType.RIGHT_TURN, ManeuverType.U_TURN

class Place(object):
    """A place as ego comes to it.

    lane: the `Lane` in which ego starts; turn: the `Maneuver` by which it leaves that lane (None on a stretch of road);
    mark: m along the lane to what is special there (a crosswalk, the beginning of a bend); others: the lanes by which
    others reach the junction, as they were asked for (`from_left`, `from_right`, `from_opposite`: the first of those).
    """
    leaving = 0  # rad to the left of where ego comes from: where it leaves a roundabout

    def __init__(self, lane, turn=None, mark=0, ramp=None, beside=None, others=(), longer=None, exit=0):
        self.lane, self.turn, self.mark, self.beside = lane, turn, mark, beside
        self.longer, self.exit = longer, exit
        self.merging = ramp
        self.others = [lane for _, lane in others]
        for other, found in reversed(others):
            setattr(self, 'from_' + other.side, found)
            if other.passed:
                waiting, aside = pocket(found)
                setattr(self, other.side + '_pocket', waiting)
                setattr(self, other.side + '_pocket_offset', aside)

    def lane_beside(self, steps) -> Lane:
        """The lane that many lanes to the left (negative: right) of ego's, where ego meets what the place is about."""
        section = self.lane.sections[-1 if self.turn else 0]
        for _ in range(abs(steps)):
            section = section._fasterLane if steps > 0 else section._slowerLane
            if section is None:
                raise RejectionException('there is no such lane beside that of the car')
        return self.as_long(section.lane)

    def as_long(self, lane, turned=False):
        """A lane beside ego's, lengthened as that was; `turned`: one of the other direction."""
        if not self.longer:
            return lane
        metres, ahead, across = self.longer
        return lengthened(lane, metres, ahead != turned, across)

    @property
    def left_lane(self) -> Lane:
        return self.as_long(self.beside) if self.beside else self.lane_beside(1)

    @property
    def right_lane(self) -> Lane:
        return self.lane_beside(-1)

    @property
    def far_left_lane(self) -> Lane:
        return self.as_long(self.beside.sections[-1]._fasterLane.lane) if self.beside else self.lane_beside(2)

    @property
    def far_right_lane(self) -> Lane:
        return self.lane_beside(-2)

    @property
    def oncoming_lane(self) -> Lane:
        """The innermost lane of the other direction."""
        if self.lane.group._opposite is None:
            raise RejectionException('there is no oncoming lane beside that of the car')
        innermost = next(o for o in self.lane.group.opposite.lanes if o.sections[0]._fasterLane is None)
        return self.as_long(innermost, turned=True)

    @property
    def exit_lane(self) -> Lane:
        """The lane into which ego leaves the junction, or the roundabout."""
        if self.turn.intersection.id in map_facts().roundabouts:
            return ring_exit(self.turn, self.leaving)
        return lengthened(self.turn.endLane, self.exit, ahead=True) if self.longer else self.turn.endLane

    @property
    def ramp(self) -> Lane:
        return self.merging.startLane

    @property
    def acceleration_lane(self) -> Lane:
        return self.merging.endLane

    @property
    def length(self) -> float:
        """The length of ego's lane, m: how far its beginning is from the junction."""
        return self.lane.centerline.length

# What Scenic may count on before a place is drawn.
Place.__annotations__ = {
    **dict.fromkeys(('lane', 'from_left', 'from_right', 'from_opposite', 'from_ring'), Lane),
    **dict.fromkeys(('left_pocket', 'right_pocket', 'opposite_pocket'), Lane),
    **dict.fromkeys(('mark', 'left_pocket_offset', 'right_pocket_offset', 'opposite_pocket_offset'), float),
    'turn': Maneuver, 'others': typing.List[Lane],
}

BEHIND, AHEAD = 60, 400  # m: how far there is a lane behind and ahead of a car whose place is asked for, if there is

def _place_of(car, turn=None, others=()) -> Place:
    """The place at which a car stands that a program put anywhere: its lane, on over the junctions ahead, straight; or,
    with a `turn`, up to the next junction over which there is such a way, with `others` (a list of `From`) to meet."""
    lane = network.laneAt(car.position) or min(network.lanes, key=lambda each: distance from car to each)
    before = _metres_along(lane, car)
    if turn:
        while not any(m.type is turn and m.intersection for m in lane.maneuvers):
            step = onward(lane, True)
            if not step or before > AHEAD:
                raise RejectionException('there is no junction with such a way ahead of the car')
            before, lane = before + lane.centerline.length, step.endLane
        way_over = next(m for m in lane.maneuvers if m.type is turn and m.intersection)
        reached = [(other, other.lane_to(way_over)) for other in others]
        if not all(found for _, found in reached):
            raise RejectionException('nobody can reach the junction ahead of the car by such a way')
        metres = before + lane.centerline.length + BEHIND
        return Place(lengthened(lane, metres, False, True), way_over, others=reached, longer=(metres, False, True))
    while before < BEHIND and leading_to(lane, True):
        lane = leading_to(lane, True).startLane
        before += lane.centerline.length
    return Place(lengthened(lane, before + AHEAD, True, True), longer=(before + AHEAD, True, True))

def _metres_along(lane, car) -> float:
    """How far (m) along a lane a car stands."""
    return lane.centerline.lineString.project(shapely.geometry.Point(car.position.x, car.position.y))

place_of = distributionFunction(_place_of)

metres_along = distributionFunction(_metres_along)

SHORT, LONG = 60, 140  # m: ways of others that are shorter go on over the roads before them, so far

class From(object):
    """A way by which others reach ego's junction: from ego's `side` ('left', 'right', 'opposite', or the 'ring' of a roundabout), going by `turn` over
    it; with a `sign` ('stop', 'yield') if one is said, with none where there is such a way for who has `priority`; over
    a lane of `length` m at least. `passed`: somebody waits
    there whom others pass: in the lane `place.left_pocket`, `left_pocket_offset` m to the left of its middle.
    """
    def __init__(self, side, turn=STRAIGHT, sign=None, length=0, passed=False, priority=False):
        self.side, self.turn, self.sign, self.length, self.passed = side, turn, sign, length, passed
        self.priority = priority

    def lane_to(self, way, roundabout=False):
        """The lane by which it comes to the junction of ego's way, or None."""
        if self.side == 'ring':
            return ring_lane(way) if roundabout else None
        angle = {'left': -90, 'right': 90, 'opposite': 180}[self.side]
        lane = ring_approach(way, angle) if roundabout else approach(way, angle, self.turn, self.passed)
        if lane and lane.centerline.length < max(self.length, SHORT):
            lane = lengthened(lane, max(self.length + 1, LONG))
        fits = lane and lane.centerline.length > self.length
        return lane if fits and self.sign in (None, map_facts().sign(lane, way.intersection)) else None

def stretches(straight=False, two_way=True, crosswalk=None, **wanted):
    """Stretches of road, ego anywhere on them: `straight` ones; `two_way`: with the other direction beside them (else
    one-way roads, too, ramps apart); with a `crosswalk` between their junctions, or without (False). `wanted`: `length`
    (m, or as much of it as there is), `min_length` (m), `speed` (m/s), and what `lane_fits` and `limit` mean. Those are taken
    whose bends allow the speed and that meet no stop sign, and of these the longest; others only where there are none
    (`share`: not at all, nor less than that share of the length up to the next junction or, `across`, straight over
    junctions). Carriageways of motorways only where there are no others."""
    facts = map_facts()
    def fits(lane):
        along = (lane.centerline[-1] - lane.centerline[0]).norm()
        return ((lane.group._opposite if two_way else lane.road.id not in facts.ramps)
                and (not straight or along > 0.998 * lane.centerline.length)
                and crosswalk in (None, lane.road.id in facts.crossed))
    return _along_roads(lambda lane: fits(lane) and lane.road.id not in facts.motorways, **wanted) or _along_roads(fits, **wanted)

def curves(side=None, two_way=True, **wanted):
    """Roads that bend by 20 degrees and more, to a `side` if one is said; `place.mark`: m to where the bend begins. The
    rest as of `stretches`."""
    def fits(lane):
        bend = begin(lane).angleWith(lane.centerline[-1] - lane.centerline[-2])
        sided = abs(bend) > 0.35 and side in (None, 'left' if bend > 0 else 'right')
        return sided and (lane.group._opposite if two_way else lane.road.id not in map_facts().ramps)
    places = _along_roads(fits, **wanted)
    for place in places:
        place.mark = bend_start(place.lane)
    return places

def motorways(**wanted):
    """Carriageways of motorways. `wanted` as of `stretches`."""
    facts = map_facts()
    return _along_roads(lambda lane: lane.road.id in facts.motorways, **wanted)

def crosswalks(before=40, limit=None, **lanes):
    """Crosswalks between junctions, 40 m and more from these, with `before` m of ego's lane before them; `place.mark`:
    m along it to the crosswalk. The rest as of `stretches`."""
    found = []
    for road, spot in map_facts().between_junctions:
        for lane in road.lanes:
            mark = lane.centerline.lineString.project(spot)
            if mark > max(before, 40) and lane.centerline.length - mark > 30 and lane_fits(lane, lane.sections[0], **lanes):
                found.append(Place(lane, mark=mark))
    return _posted(found, limit)

def junctions(turn=None, arms=None, control=None, crosswalk=None, approach=0, exit=0, others=(), also=(), limit=None,
              across=False, **lanes):
    """Ways of ego over intersections: by a `turn` (STRAIGHT, LEFT_TURN, RIGHT_TURN, U_TURN); with so many `arms`; where a
    `control` holds for ego ('signal', 'stop', 'yield', 'none'); with a `crosswalk` at ego's line, or without; with lanes
    of `approach` m before the junction and `exit` m behind it, over several roads (`across`: and straight over other
    junctions) where roads are short; with `others` to meet there, a list of `From`, and with other ways from
    ego's lane, `also`. Where no control is asked for, ego has no stop sign if there are such ways, and whom it meets
    by a crossing one comes to neither sign nor light, or at least to no light."""
    facts = map_facts()
    found = []
    for junction in network.intersections:
        if junction.id not in facts.intersections or not facts.controlled(junction, control):
            continue
        if {None: True, 3: junction.is3Way, 4: junction.is4Way}[arms]:
            found += [m for m in junction.maneuvers if turn in (None, m.type)
                      and (control not in ('stop', 'yield') or facts.sign(m.startLane, junction) == control)
                      and (crosswalk is None or crosswalk == (facts.crosswalk_on(m.startLane) is not None))]
    found = [m for m in found if all(any(o.type is way for o in m.startLane.maneuvers) for way in also)]
    minor = control is None and any(other.sign and other.side != 'opposite' for other in others)
    if minor:  # whom others have to give way to has no sign itself
        found = [m for m in found if facts.sign(m.startLane, m.intersection) != 'stop']
    crossing = control is None and any(other.side in ('left', 'right') and not other.sign for other in others)
    for unregulated in ('none', 'dark', None) if crossing else (None,):  # where neither has to wait for the other
        ways = [Place(m.startLane, m) for m in found if facts.controlled(m.intersection, unregulated)]
        places = _at_junctions(ways, approach, exit, limit, lanes, others, across=across)
        if places:
            places = [place for place in places if not any(
                other.priority and facts.sign(lane, place.turn.intersection)
                for other, lane in zip(others, place.others))] or places
            free = [p for p in places if control is None and facts.sign(p.turn.startLane, p.turn.intersection) != 'stop']
            return free or places
    return []

def roundabouts(approach=0, exit=0, others=(), arms_within=100, limit=None, across=False, leaving=0, **lanes):
    """Ways of ego into roundabouts; `others` (a list of `From`) come in at arms that are `arms_within` m of ego's;
    `leaving`: to which side ego leaves (rad, to the left). The rest as of `junctions`."""
    found = [m for i in network.intersections if i.id in map_facts().roundabouts for m in i.maneuvers
             if any(lane.road is m.startLane.road for lane in i.outgoingLanes)]
    def close(place):
        ends = place.lane.centerline[-1]
        return all((distance from lane.centerline[-1] to ends) < arms_within for lane in place.others)
    places = [Place(way.startLane, way) for way in found]
    places = [p for p in _at_junctions(places, approach, exit, limit, lanes, others, True, across) if close(p)]
    for place in places:
        place.leaving = leaving
    return places

def merges(ego_on='ramp', approach=0, exit=0, ramp_length=0, limit=None, across=False, two_beside=False, **lanes):
    """Where a ramp joins a road: with ego on the 'ramp', on the lane 'beside' which the ramp's goes on, or on any lane of
    the 'road'. `place.ramp`: the ramp's lane; `place.acceleration_lane`: in which it goes on; for ego on the ramp
    `place.left_lane` is the road's lane that goes on to its left, and `place.far_left_lane` the one beyond, which
    `two_beside` asks for."""
    facts, found = map_facts(), []
    for m in [m for i in network.intersections for m in i.maneuvers if m.startLane.road.id in facts.on_ramps]:
        faster = m.endLane.sections[0]._fasterLane
        for o in m.intersection.maneuvers:
            merging = faster and o.endLane is faster.lane
            if ego_on != 'road' and merging and m.startLane.centerline.length > ramp_length:
                way, beside = (m, o.startLane) if ego_on == 'ramp' else (o, None)
                if two_beside and not o.startLane.sections[-1]._fasterLane:
                    continue
                found.append(Place(way.startLane, way, ramp=m, beside=beside))
            elif ego_on == 'road' and o.startLane.road.id not in facts.on_ramps:
                found.append(Place(o.startLane, o, ramp=m))
    return _at_junctions(found, approach, exit, limit, lanes, across=across)

def exits(ego_on='exit', approach=0, exit=0, limit=None, across=False, **lanes):
    """Where a ramp leaves a road: with ego on the lane of the 'exit', in the lane 'beside' that, or going on along the
    'road'."""
    def leaves(m):
        return m.endLane.road.id in map_facts().off_ramps
    found = [m for i in network.intersections for m in i.maneuvers if leaves(m)]
    if ego_on == 'road':
        found = [m for leaving in found for m in leaving.intersection.maneuvers if not leaves(m)]
    if ego_on == 'beside':
        inner = [(m, m.startLane.sections[0]._fasterLane) for m in found]
        return _at_junctions([Place(s.lane, m) for m, s in inner if s], approach, exit, limit, lanes, across=across)
    return _at_junctions([Place(m.startLane, m) for m in found], approach, exit, limit, lanes, across=across)

def lane_fits(lane, section, lanes=None, ego_lane=None, oncoming=None, shoulder=None, sidewalk=None):
    """Whether ego's lane has so many `lanes` in its direction or more (1: it is the only one), is the 'leftmost',
    'middle' or 'rightmost' of them, with an `oncoming` lane that adjoins (no divider), a `shoulder` or parking lane, a
    `sidewalk` (False: without; along roads `shoulder` may be 'preferred': where the map has such a place)."""
    group, left, right = lane.group, section._fasterLane, section._slowerLane
    place = {None: True, 'leftmost': not left, 'rightmost': not right, 'middle': left and right}
    def adjoins():
        return any(other.group is group._opposite for one in group.lanes for other in one.adjacentLanes)
    fits = lanes is None or (len(group.lanes) == 1 if lanes == 1 else len(group.lanes) >= lanes)
    return (fits and place[ego_lane] and (oncoming is None or oncoming == adjoins())
            and shoulder in (None, bool(group._shoulder)) and sidewalk in (None, bool(group._sidewalk)))

def _along_roads(fits, length=0, min_length=0, limit=None, speed=0, share=0, across=False, least=0, **lanes):
    min_length = max(min_length, least)
    if lanes.get('shoulder') == 'preferred':
        return next((found for shoulder in (True, None)
                     for found in [_along_roads(fits, length, min_length, limit, speed, share, across, **{**lanes, 'shoulder': shoulder})]
                     if found), [])
    found = [Place(lane) for road in network.roads for lane in road.lanes
             if lane_fits(lane, lane.sections[0], **lanes) and fits(lane)]
    ways = [(part, over) for part, over in SHARES if part >= share and (across or not share or over != JUNCTIONS)]
    for free, part, over in [(True, *way) for way in ways] + [(False, *way) for way in ways if not share]:
        metres = max(part * length, min_length)
        starts = [place for place in found if not free or free_for(place.lane, speed, over == JUNCTIONS) >= metres]
        long = {_longer(place, metres, over, lanes, ahead=True): place for place in starts}
        long = {place: start for place, start in long.items() if place and (over is None or fits(place.lane))}
        fast = [place for place in long if speed and free_for(long[place].lane, speed, True, signs=False) >= metres]
        if long:
            best = _posted(_exactly(lanes.get('lanes'), fast or [*long]), limit)
            best = [place for place in best if reach(long[place].lane, min_length, ahead=True) >= min_length] or best  # none starts in a junction
            return [place for place in best if unstopped(long[place].lane, length)] or best
    if lanes.get('lanes') == 1 and not share:  # no road that long has only one
        return _along_roads(fits, length, min_length, limit, speed, **{**lanes, 'lanes': None})
    return []

KEPT = {}
def kept(lane, speed):
    """How far (m) along a lane `Drive` keeps its speed (m/s) in the bends."""
    if (lane, speed) not in KEPT:
        points = numpy.array(lane.centerline.lineString.coords)[:, :2]
        way = numpy.insert(numpy.cumsum(numpy.hypot(*numpy.diff(points, axis=0).T)), 0, 0)
        x, y = [numpy.interp(numpy.arange(0, way[-1], 4), way, points[:, k]) for k in (0, 1)]
        turns = numpy.diff(numpy.unwrap(numpy.arctan2(numpy.diff(y), numpy.diff(x))))
        tight = numpy.flatnonzero(numpy.abs(turns) / 4 * speed ** 2 > 4)
        KEPT[lane, speed] = 4 * tight[0] if len(tight) else math.inf
    return KEPT[lane, speed]

FREE = {}
def free_for(lane, speed, junctions, signs=True):
    """How far (m) along a lane, and those that it leads to, the bends allow a speed (m/s; 0: any) and no stop sign stands
    before a junction: at most to where the lanes end; without regard to `signs` for as long as there are bends."""
    known = lane, speed, junctions, signs
    if known not in FREE:
        FREE[known] = _free_for(*known)
    return FREE[known]

def _free_for(lane, speed, junctions, signs):
    gone, passed = 0, []
    while lane not in passed:
        passed, step = [*passed, lane], onward(lane, junctions)
        for each in [lane, *([step.connectingLane] if step and step.connectingLane else [])]:
            if speed and kept(each, speed) < each.centerline.length:
                return gone + kept(each, speed)
            gone += each.centerline.length
            if signs and each is lane and step and step.intersection and map_facts().sign(lane, step.intersection) == 'stop':
                return gone
        if not step:
            break
        lane = step.endLane
    return gone if signs else math.inf

BEYOND = 100  # m behind a junction in which there is no stop sign, where there is such a place

def unstopped(lane, metres):
    """Whether the way on, straight where there is a choice, meets no stop sign in the `metres` from a lane's start."""
    goal, gone, passed = lane.centerline[-1] - lane.centerline[-2], 0, []
    while lane and lane not in passed and gone + lane.centerline.length < metres:
        passed, gone = [*passed, lane], gone + lane.centerline.length
        step = onward(lane, True) or min(lane.maneuvers, default=None, key=lambda m: abs(goal.angleWith(begin(m.endLane))))
        if step and step.intersection and map_facts().sign(lane, step.intersection) == 'stop':
            return False
        lane = step and step.endLane
    return True

def leads_freely(lane, metres):
    """Whether no stop sign stands before the junctions over which the last `metres` of the way to a lane's end go."""
    gone = lane.centerline.length
    while gone < metres:
        step = leading_to(lane, True)
        if not step or step.intersection and map_facts().sign(step.startLane, step.intersection) == 'stop':
            return False
        lane, gone = step.startLane, gone + sum(each.centerline.length for each in (step.connectingLane, step.startLane) if each)
    return True

SHARES = [(1, None), (1, ROADS), (0.7, None), (0.7, ROADS), (0.45, None), (0.45, ROADS), (1, JUNCTIONS),
          (0.7, JUNCTIONS), (0.45, JUNCTIONS), (0.25, None), (0.25, ROADS), (0.25, JUNCTIONS)]

def _at_junctions(places, approach, exit, limit, lanes, others=(), roundabout=False, across=False):
    fitting = [place for place in places if lane_fits(place.lane, place.lane.sections[-1], **lanes)]
    for over in (None, ROADS, JUNCTIONS) if across else (None, ROADS):
        found, free = [], set()
        for start, place in [(place, _longer(place, approach, over, lanes, exit=exit)) for place in fitting]:
            reached = [(other, other.lane_to(place.turn, roundabout)) for other in others] if place else []
            if place and all(lane for _, lane in reached):
                found.append(Place(place.lane, place.turn, place.mark, place.merging, place.beside, reached,
                                   place.longer, place.exit))
                free |= {found[-1]} if over != JUNCTIONS or leads_freely(start.lane, approach) else set()
        if found:
            best = _posted(_exactly(lanes.get('lanes'), [place for place in found if place in free] or found), limit)
            return [place for place in best if unstopped(place.turn.endLane, BEYOND)] or best
    return []

def _exactly(lanes, places):
    """The places with so many lanes in ego's direction, if there are any, else those with more; all where none are said."""
    return lanes and [place for place in places if len(place.lane.group.lanes) == lanes] or places

def ordinary(places, speed=0):
    """Of some places those that are meant where nothing is said of lanes, control and limits: with a posted limit that
    suits a speed (m/s), where ego comes to no sign and to no light, with the fewest lanes in ego's direction and then
    about as few on the other roads of the junction; of each only where there are such."""
    facts = map_facts()
    limits = facts.limits
    if speed:
        places = [p for p in places if 0.8 * speed <= limits.get(p.lane.road.id, 0) <= 1.6 * speed] or places
    for control in 'stop', 'signal':
        places = [p for p in places if not (p.turn and p.turn.intersection)
                  or (facts.sign(p.turn.startLane, p.turn.intersection) or '') != control] or places
    fewest = min([len(place.lane.group.lanes) for place in places], default=0)
    few = [place for place in places if len(place.lane.group.lanes) == fewest]
    sizes = {place: len(place.turn.intersection.incomingLanes) if place.turn and place.turn.intersection else 0 for place in few}
    return [place for place in few if sizes[place] <= min(sizes.values(), default=0) + 2]

def _longer(place, metres, over, lanes, ahead=False, exit=0):
    """The place with ego's lane of `metres` up to its end (`ahead`: from its start) and `exit` m behind the junction,
    over several roads if so wished; None where there is not that much."""
    after = place.turn.endLane.centerline.length if place.turn else 0
    if over is None:
        return place if place.length > metres and after >= exit else None
    across = over == JUNCTIONS
    beside = [(other, ahead) for other in place.lane.group.lanes if (lanes.get('lanes') or 1) > 1 and other is not place.lane]
    if lanes.get('oncoming'):
        beside += [(o, not ahead) for o in place.lane.group.opposite.lanes if o.sections[0]._fasterLane is None]
    if exit > after and lengthened(place.turn.endLane, exit + 1, True).centerline.length < exit:
        return None
    if any(reach(lane, metres, way, across) < metres for lane, way in [(place.lane, ahead), *beside]):
        return None
    return Place(lengthened(place.lane, metres + 1, ahead, across), place.turn, place.mark, place.merging, place.beside,
                 longer=(metres + 1, ahead, across), exit=exit + 1)

def _posted(places, limit):
    """The places with that posted limit (m/s), all where there are none."""
    limits = map_facts().limits
    return limit and [p for p in places if abs(limits.get(p.lane.road.id, 0) - limit) < 0.55] or places

# What Scenic's parser leaves out of a map.

class MapFacts(object):
    """Read from a map's OpenDRIVE file; roads and junctions by their ids.

    limits: of roads, m/s; signs: 'signal', 'stop' or 'yield' by (junction, road into it); crosswalks: their outlines, and
    `crossed`: roads with one between their junctions, `between_junctions`: those, as (road, point); motorways, ramps
    (on_ramps, off_ramps): roads; intersections, roundabouts: junctions.
    """
    def __init__(self, path, network):
        root = ElementTree.parse(path).getroot()
        self.limits, self.signs, self.crosswalks, self.between_junctions = {}, {}, [], []
        self.on_lanes = {}
        self.motorways, self.on_ramps, self.off_ramps = set(), set(), set()
        self.intersections, self.roundabouts = set(), set()
        self._read_signs(root)
        roads = {road.id: road for road in network.allRoads}
        for element in root.iterfind('road'):
            road = roads.get(int(element.get('id')))
            if road:
                self._read_road(element, road, element.get('junction') == '-1')
        self._read_junctions(root, network)
        self.crossed = {road.id for road, _ in self.between_junctions}
        self.ramps = self.on_ramps | self.off_ramps

    def sign(self, lane, junction):
        """'signal', 'stop' or 'yield': what there is for who comes to a junction by a lane; None: nothing."""
        return self.signs.get((junction.id, lane.road.id))

    def controlled(self, junction, control):
        """Whether a junction has lights ('signal'), none ('dark'), neither lights nor signs ('none'); whatever else is
        asked."""
        lights = any(signal.isTrafficLight for signal in junction.signals)
        if control == 'none':
            return not lights and all(j != junction.id for j, _ in self.signs)
        return lights != (control == 'dark') if control in ('signal', 'dark') else True

    def crosswalk_on(self, lane):
        """How far along a lane, or straight on beyond it, (m) the middle of the crosswalk at its end lies; None: there is
        none."""
        line = lane.centerline
        if line not in self.on_lanes:  # asked at every step by who comes up to a stop line
            end, last = line[-1], line.pointAlongBy(line.length - 1)
            beyond = 13 * end.x - 12 * last.x, 13 * end.y - 12 * last.y
            way = shapely.geometry.LineString([*[(p.x, p.y) for p in line], beyond])
            across = [way.intersection(outline) for outline in self.crosswalks]
            there = [way.project(part.centroid) for part in across if not part.is_empty]
            self.on_lanes[line] = min([s for s in there if s > line.length - 14], default=None)
        return self.on_lanes[line]

    def _read_road(self, element, road, outside):
        speed, kind = element.find('type/speed'), element.find('type')
        unit = {'km/h': 1 / 3.6, 'mph': 0.44704}
        if speed is not None and speed.get('max') not in (None, 'no limit', 'undefined'):
            self.limits[road.id] = float(speed.get('max')) * unit.get(speed.get('unit'), 1)
        ids = [int(lane.get('id')) for lane in element.iterfind("lanes/laneSection/*/lane[@type='driving']")]
        divided = min([i for i in ids if i > 0], default=1) - max([i for i in ids if i < 0], default=-1) > 2
        apart = divided or not (road.forwardLanes and road.backwardLanes)
        fast = apart and element.find(".//lane[@type='sidewalk']") is None and self.limits.get(road.id, 0) >= 24 or kind is not None and kind.get('type') == 'motorway'
        if outside and fast and max(len(group.lanes) for group in road.laneGroups) > 1:
            self.motorways.add(road.id)
        for crosswalk in element.iterfind("objects/object[@type='crosswalk']"):
            s, outline = float(crosswalk.get('s')), _outline(crosswalk, road)
            self.crosswalks.append(outline)
            if outside and 40 < s < road.centerline.length - 40:
                self.between_junctions.append((road, outline.centroid))

    def _read_signs(self, root):
        kinds, into, of_way = {}, {}, {}
        links = {road.get('id'): road.find('link') for road in root.iterfind('road')}
        for junction in root.iterfind('junction'):
            for connection in junction.iterfind('connection'):
                way, source = connection.get('connectingRoad'), connection.get('incomingRoad')
                begin = 'predecessor' if connection.get('contactPoint') != 'end' else 'successor'
                link = links[way].find(begin) if links.get(way) is not None else None
                into[source, link is None or link.get('contactPoint') != 'start'] = int(junction.get('id'))
                of_way[way] = int(junction.get('id')), int(source)
        for signal in root.iterfind('road/signals/signal'):
            kind = {'1000001': 'signal', '1000009': 'signal', '1000010': 'signal', '1000011': 'signal',
                    '206': 'stop', '205': 'yield'}.get(signal.get('type'))
            named = 'stop' in (signal.get('name') or '').lower() and signal.get('dynamic') != 'yes'
            kinds[signal.get('id')] = kind or ('stop' if named else None)
        for road in root.iterfind('road'):
            for signal in road.iterfind('signals/*'):
                rid, kind, facing = road.get('id'), kinds.get(signal.get('id')), signal.get('orientation', '+')
                valid = [int(v.get(end)) for v in signal.iterfind('validity') for end in ('fromLane', 'toLane')]
                if valid and not any(valid):
                    continue  # it only stands there
                faced = {True: min(valid) < 0, False: max(valid) > 0} if valid else {
                    True: facing in ('+', 'none'), False: facing in ('-', 'none')}
                places = [of_way[rid]] if rid in of_way else [
                    (into.get((rid, end)), int(rid)) for end in (True, False) if faced[end]]
                for place in places if kind else ():
                    self.signs[place] = min(kind, self.signs.get(place, kind), key=('signal', 'stop', 'yield').index)

    def _read_junctions(self, root, network):
        rings = {int(junction.get('junction')) for group in root.iterfind("junctionGroup[@type='roundabout']")
                 for junction in group.iterfind('junctionReference')} or _rings(network)
        def ramp(groups):
            roads = [g.road for g in groups if not (g.road.forwardLanes and g.road.backwardLanes)]
            return {road.id for road in sorted(roads, key=lambda road: (len(road.lanes), road.id))[:1]}
        for junction in network.intersections:
            gentle = not any(_bends(m.connectingLane) for m in junction.maneuvers if m.connectingLane)
            streams = _streams(junction) if gentle else []
            merging = [ramp(into) for into, out in streams if len(into) > 1 and len(out) == 1]
            parting = [ramp(out) for into, out in streams if len(into) == 1 and len(out) > 1]
            if junction.id in rings:
                self.roundabouts.add(junction.id)
            elif any(merging) or any(parting):
                self.on_ramps.update(*merging)
                self.off_ramps.update(*parting)
            elif not gentle or any(len(into) > 1 or len(out) > 1 for into, out in streams):
                self.intersections.add(junction.id)

def _streams(junction):
    """The ways over a junction by what they have in common: for each stream of traffic the lane groups that it comes from
    and those that it goes to."""
    streams = []
    for m in junction.maneuvers:
        into, out = {m.startLane.group}, {m.endLane.group}
        for other in [s for s in streams if s[0] & into or s[1] & out]:
            streams.remove(other)
            into, out = into | other[0], out | other[1]
        streams.append((into, out))
    return streams

_MAP_FILE = globalParameters.map

def map_facts():
    """The facts of the map at hand, read once."""
    if not hasattr(network, 'map_facts'):
        network.map_facts = MapFacts(_MAP_FILE, network)
    return network.map_facts

def _bends(lane):
    """Whether a lane turns off, as no way of a merge or an exit does: by over 25 degrees in a bend of under 40 m, or 60."""
    turned = abs(_turn(lane))
    return turned > 1.0472 or turned > 0.4363 and lane.centerline.length < 40 * turned

def _turn(lane):
    """By how much a lane turns from its beginning to its end: rad, to the left."""
    return begin(lane).angleWith(lane.centerline[-1] - lane.centerline[-2])

def _outline(element, road):
    """The outline of a crosswalk of a road; 2 m around its spot where none is drawn."""
    s, t, turned = (float(element.get(name) or 0) for name in ('s', 't', 'hdg'))
    line = road.centerline
    spot, onward = line.pointAlongBy(min(s, line.length)), line.pointAlongBy(min(s + 1, line.length))
    before = line.pointAlongBy(max(min(s, line.length) - 1, 0))
    heading = math.atan2(onward.y - before.y, onward.x - before.x)
    corners = [(float(c.get('u')), float(c.get('v'))) for c in element.iter('cornerLocal')] or [(0, 0)]
    cos, sin = math.cos(heading + turned), math.sin(heading + turned)
    drawn = shapely.geometry.MultiPoint([(spot.x - t * math.sin(heading) + u * cos - v * sin,
                                          spot.y + t * math.cos(heading) + u * sin + v * cos) for u, v in corners]).convex_hull
    return drawn if drawn.area else drawn.buffer(2)

def _rings(network):
    """The ids of junctions on a circle of one-way roads that bend to the left."""
    following = {}
    for junction in network.intersections:
        for m in junction.maneuvers:
            road, after = m.endLane.road, m.endLane.maneuvers and m.endLane.maneuvers[0].intersection
            one_way = not (road.forwardLanes and road.backwardLanes)
            if after and after is not junction and one_way and 0.14 < _turn(m.endLane) < 3.1:
                following.setdefault(junction.id, set()).add(after.id)
    rings = set()
    for start in following:
        path = [start]
        while len(path) <= 10 and len(following.get(path[-1], ())) == 1 and (path[-1] != start or len(path) == 1):
            path += following[path[-1]]
        if len(path) > 3 and path[-1] == start:
            rings |= set(path)
    return rings


# What programs of version 1 call these; `least` there is `min_length`

way = route
usual = ordinary
into = braking_to_hit
need = braking_needed
most_need = braking_needed
StopShortOf = YieldTo

def pace(car, lead, speed, headway=1.5, standing=4, points=None):
    return following_speed(car, lead, speed, headway, standing, points)
