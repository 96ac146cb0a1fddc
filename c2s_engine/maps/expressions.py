"""Places as Scenic code: the one source for what a PlaceSpec selects on a map, in programs and in counts.

    code = place_code(spec, read_extras(map_file.path))    # -> PlaceCode(yields, expression, comment)

`expression` is one static list expression, valid as Scenic and as Python, over `network`, `ManeuverType` and builtins
only (no random values), so that a program holds it as it is and the check server counts it as it is. It yields

- "maneuvers": for intersection, roundabout, on_ramp, off_ramp: scenic Maneuver objects of ego's way
  (`m.startLane`: ego's approach lane, `m.connectingLane`, `m.endLane`, `m.intersection`, `m.conflictingManeuvers`);
- "lanes": for road, straight, curve, motorway: scenic Lane objects in which ego starts;
- "spots": for crosswalk: points (x, y) in m where a crosswalk crosses the middle of a lane that ego drives; ego starts
  `following roadDirection from spot for -distance`, the lane is `network.laneAt(spot)`.

A program then draws: `place = Uniform(*EXPRESSION)`. `room` (m) asks for lanes at least that long (approaches too).
Where stock Scenic knows nothing (stop, yield, limits, crosswalks, ramps, motorways), ids from the map's extras stand in
the expression, with `comment` to say so. An empty id set gives `[]`: the map has no such place.
"""
