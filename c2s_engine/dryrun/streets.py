"""The part of CARLA's map that the stock model asks: waypoints on lanes, and the lights and signs ahead of them."""

import math
import random
from dataclasses import dataclass
from typing import Any

import carla
import shapely

from c2s_engine.dryrun.lights import Lights
from c2s_engine.dryrun.roads import RoadIndex
from c2s_engine.maps.controls import ControlPoint
from c2s_engine.maps.extras import MapExtras

SIGN_TYPES = {"signal": "1000001", "stop": "206", "yield": "205"}


@dataclass(eq=False)
class Sign(carla.Landmark):
    """A light or sign ahead of a waypoint."""

    id: str
    type: str
    distance: float
    transform: Any
    light: Any = None
    name: str = ""


class Place(carla.Waypoint):
    """A point on a lane's middle line."""

    def __init__(self, streets: "Streets", lane: int, s: float) -> None:
        self.streets, self.lane, self.s = streets, lane, s
        info = streets.index.lanes[lane]
        x, y = info.point_at(s)
        heading = info.heading_at(s)
        self.transform = carla.Transform(carla.Location(x, -y, 0.0), carla.Rotation(yaw=-math.degrees(heading) - 90.0))
        self.road_id, self.lane_width = info.road, info.width
        self.is_junction = self.is_intersection = info.junction is not None
        self.lane_type = carla.LaneType.Driving
        self.lane_id = info.index

    def next(self, distance: float) -> list["Place"]:
        return self.streets.further(self, distance)

    def get_left_lane(self) -> "Place | None":
        return self._beside(self.streets.index.lanes[self.lane].left)

    def get_right_lane(self) -> "Place | None":
        return self._beside(self.streets.index.lanes[self.lane].right)

    def _beside(self, lanes: set[int]) -> "Place | None":
        location = self.transform.location
        for lane in sorted(lanes):
            return Place(self.streets, lane, self.streets.index.lanes[lane].project(location.x, -location.y)[0])
        return None

    def get_landmarks_of_type(self, distance: float, type: str, stop_at_junction: bool = False) -> list[Sign]:
        return [sign for sign in self.get_landmarks(distance, stop_at_junction) if sign.type == str(type)]

    def get_landmarks(self, distance: float, stop_at_junction: bool = False) -> list[Sign]:
        return self.streets.signs_ahead(self, distance)


class Streets(carla.Map):
    """CARLA's map as far as it is asked."""

    def __init__(self, index: RoadIndex, extras: MapExtras | None, lights: Lights, name: str) -> None:
        self.index, self.extras, self.lights, self.name = index, extras, lights, name

    def get_waypoint(self, location: Any, project_to_road: bool = True, lane_type: Any = None) -> Place | None:
        x, y = location.x, -location.y
        lane = self.index.lane_at(x, y)
        if lane is None:
            if not project_to_road:
                return None
            lane = int(self.index.tree.nearest(shapely.Point(x, y)))
        info = self.index.lanes[lane]
        s = min(max(info.project(x, y)[0], 0.0), info.length)
        return Place(self, lane, s)

    def further(self, place: Place, distance: float) -> list[Place]:
        """The places a distance ahead, one for each way there."""
        info = self.index.lanes[place.lane]
        if place.s + distance <= info.length:
            return [Place(self, place.lane, place.s + distance)]
        rest = distance - (info.length - place.s)
        return [p for lane in info.next for p in self.further(Place(self, lane, 0.0), rest)]

    def signs_ahead(self, place: Place, distance: float) -> list[Sign]:
        """Lights and signs that face who drives on from a place, to where the next junction begins."""
        found: list[Sign] = []
        lane: int | None = place.lane
        gone = -place.s
        while lane is not None and gone < distance:
            info = self.index.lanes[lane]
            junctions = {self.index.lanes[n].junction for n in info.next} - {None}
            gone += info.length
            if junctions:
                if gone <= distance:
                    found += self._signs_of(info.road, junctions, gone)
                break
            lane = self.index.ahead(lane)
        return found

    def _signs_of(self, road: str, junctions: set, distance: float) -> list[Sign]:
        return [
            self._sign(control, distance)
            for control in (self.extras.controls if self.extras else ())
            if str(control.road) == road and str(control.junction) in junctions
        ]

    def _sign(self, control: ControlPoint, distance: float) -> Sign:
        transform = carla.Transform(carla.Location(control.x, -control.y, 0.0))
        light = self.lights.by_approach.get((str(control.junction), str(control.road)))
        name = f"{control.junction}/{control.road}"
        shown = light if control.kind == "signal" else None
        return Sign(name, SIGN_TYPES[control.kind], distance, transform, shown, control.kind)

    def get_all_landmarks_from_id(self, opendrive_id: Any) -> list[Sign]:
        """The signs and lights that have an id in the map's file."""
        controls = self.extras.controls if self.extras else ()
        return [self._sign(control, 0.0) for control in controls if control.mark == str(opendrive_id)]

    def random_walk(self, rng: random.Random) -> Any:
        """A point on some sidewalk."""
        walks = self.index.network.sidewalks
        if not walks:
            return None
        points = rng.choice(walks).centerline.points
        x, y = points[rng.randrange(len(points))][:2]
        return carla.Location(x, -y, 0.0)
