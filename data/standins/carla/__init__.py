"""Inert stand-in for the `carla` package: value types only, as far as Scenic's CARLA world model uses them.

Axes and units are CARLA's: x forward/east, y right/south, z up, in metres; angles in degrees, clockwise.
"""

from carla.control import (
    AckermannControllerSettings, VehicleAckermannControl, VehicleControl, WalkerControl, WheelPhysicsControl,
    VehiclePhysicsControl,
)
from carla.enums import (
    AttachmentType, CityObjectLabel, ColorConverter, LaneChange, LaneMarkingColor, LaneMarkingType, LaneType,
    LandmarkOrientation, LandmarkType, TrafficLightState, VehicleDoor, VehicleFailureState, VehicleLightState,
    VehicleWheelLocation,
)
from carla.space import BoundingBox, Color, GeoLocation, Location, Rotation, Transform, Vector2D, Vector3D
from carla.weather import WeatherParameters


class Actor:
    """Base of the fake actors of a dry run."""


class Vehicle(Actor):
    pass


class Walker(Actor):
    pass


class WalkerAIController(Actor):
    pass


class TrafficSign(Actor):
    pass


class TrafficLight(TrafficSign):
    pass


class Sensor(Actor):
    pass


class World:
    pass


class Map:
    pass


class Waypoint:
    pass


class Landmark:
    pass


class TrafficManager:
    pass


class WorldSettings:
    """Settings of a world; kept, without effect."""

    def __init__(self, synchronous_mode=False, no_rendering_mode=False, fixed_delta_seconds=0.0, **others):
        self.synchronous_mode = synchronous_mode
        self.no_rendering_mode = no_rendering_mode
        self.fixed_delta_seconds = fixed_delta_seconds
        self.__dict__.update(others)


class Client:
    """There is no server behind this package."""

    def __init__(self, host="127.0.0.1", port=2000, worker_threads=0):
        raise RuntimeError(
            "this is the stand-in of the dry run; to run in CARLA itself, install the carla package and start its server"
        )
