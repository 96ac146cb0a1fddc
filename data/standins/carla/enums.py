"""Enumerations whose members print as their bare names, as CARLA's do."""

import enum


class _Named(enum.Enum):
    def __str__(self):
        return self.name


class _Numbered(enum.IntEnum):
    __str__ = _Named.__str__


class _Flags(enum.IntFlag):
    def __str__(self):
        return self.name or str(int(self))


class TrafficLightState(_Numbered):
    Red = 0
    Yellow = 1
    Green = 2
    Off = 3
    Unknown = 4


class VehicleLightState(_Flags):
    NONE = 0
    Position = 1
    LowBeam = 2
    HighBeam = 4
    Brake = 8
    RightBlinker = 16
    LeftBlinker = 32
    Reverse = 64
    Fog = 128
    Interior = 256
    Special1 = 512
    Special2 = 1024
    All = 2047


class LaneType(_Flags):
    NONE = 1
    Driving = 2
    Stop = 4
    Shoulder = 8
    Biking = 16
    Sidewalk = 32
    Border = 64
    Restricted = 128
    Parking = 256
    Bidirectional = 512
    Median = 1024
    Any = -2


class LaneChange(_Flags):
    NONE = 0
    Right = 1
    Left = 2
    Both = 3


class LaneMarkingColor(_Numbered):
    Standard = 0
    Blue = 1
    Green = 2
    Red = 3
    White = 0
    Yellow = 4
    Other = 5


class LaneMarkingType(_Numbered):
    NONE = 0
    Other = 1
    Broken = 2
    Solid = 3
    SolidSolid = 4
    SolidBroken = 5
    BrokenSolid = 6
    BrokenBroken = 7
    BottsDots = 8
    Grass = 9
    Curb = 10


class LandmarkOrientation(_Numbered):
    Positive = 0
    Negative = 1
    Both = 2


class LandmarkType:
    """Types of signs and lights as the map files number them."""

    Danger = "101"
    YieldSign = "205"
    StopSign = "206"
    MaximumSpeed = "274"
    LightPost = "1000001"


class ColorConverter(_Numbered):
    Raw = 0
    Depth = 1
    LogarithmicDepth = 2
    CityScapesPalette = 3


ColorConverter.names = dict(ColorConverter.__members__)


class AttachmentType(_Numbered):
    Rigid = 0
    SpringArm = 1
    SpringArmGhost = 2


class VehicleDoor(_Numbered):
    FL = 0
    FR = 1
    RL = 2
    RR = 3
    All = 6


class VehicleFailureState(_Numbered):
    NONE = 0
    Rollover = 1
    Engine = 2
    TirePuncture = 3


class VehicleWheelLocation(_Numbered):
    FL_Wheel = 0
    FR_Wheel = 1
    BL_Wheel = 2
    BR_Wheel = 3


class CityObjectLabel(_Numbered):
    Any = 255
    NONE = 0
    Roads = 1
    Sidewalks = 2
    Buildings = 3
    Walls = 4
    Fences = 5
    Poles = 6
    TrafficLight = 7
    TrafficSigns = 8
    Vegetation = 9
    Terrain = 10
    Sky = 11
    Pedestrians = 12
    Rider = 13
    Car = 14
    Truck = 15
    Bus = 16
    Train = 17
    Motorcycle = 18
    Bicycle = 19
    Static = 20
    Dynamic = 21
    Other = 22
    Water = 23
    RoadLines = 24
    Ground = 25
    Bridge = 26
    RailTrack = 27
    GuardRail = 28
