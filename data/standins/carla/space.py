"""Vectors, rotations and transforms with CARLA's conventions."""

import math


class Vector2D:
    """A vector in the plane."""

    __slots__ = ("x", "y")

    def __init__(self, x=0.0, y=0.0):
        self.x, self.y = float(x), float(y)

    def length(self):
        return math.hypot(self.x, self.y)

    def __eq__(self, other):
        return isinstance(other, Vector2D) and (self.x, self.y) == (other.x, other.y)

    def __hash__(self):
        return hash((self.x, self.y))

    def __repr__(self):
        return f"Vector2D(x={self.x:f}, y={self.y:f})"


class Vector3D:
    """A vector in space; Location is one whose unit is metres."""

    __slots__ = ("x", "y", "z")

    def __init__(self, x=0.0, y=0.0, z=0.0):
        self.x, self.y, self.z = float(x), float(y), float(z)

    def __add__(self, other):
        return type(self)(self.x + other.x, self.y + other.y, self.z + other.z)

    def __sub__(self, other):
        return type(self)(self.x - other.x, self.y - other.y, self.z - other.z)

    def __mul__(self, factor):
        return type(self)(self.x * factor, self.y * factor, self.z * factor)

    __rmul__ = __mul__

    def __truediv__(self, factor):
        return type(self)(self.x / factor, self.y / factor, self.z / factor)

    def __neg__(self):
        return type(self)(-self.x, -self.y, -self.z)

    def __eq__(self, other):
        return isinstance(other, Vector3D) and (self.x, self.y, self.z) == (other.x, other.y, other.z)

    def __hash__(self):
        return hash((self.x, self.y, self.z))

    def __repr__(self):
        return f"{type(self).__name__}(x={self.x:f}, y={self.y:f}, z={self.z:f})"

    def length(self):
        return math.sqrt(self.squared_length())

    def squared_length(self):
        return self.x * self.x + self.y * self.y + self.z * self.z

    def dot(self, other):
        return self.x * other.x + self.y * other.y + self.z * other.z

    def dot_2d(self, other):
        return self.x * other.x + self.y * other.y

    def cross(self, other):
        return Vector3D(
            self.y * other.z - self.z * other.y, self.z * other.x - self.x * other.z, self.x * other.y - self.y * other.x
        )

    def distance(self, other):
        return (self - other).length()

    def distance_2d(self, other):
        return math.hypot(self.x - other.x, self.y - other.y)

    def distance_squared(self, other):
        return (self - other).squared_length()

    def make_unit_vector(self):
        length = self.length()
        return Vector3D(self.x, self.y, self.z) / length if length else Vector3D()


class Location(Vector3D):
    __slots__ = ()


class Rotation:
    """Angles in degrees; yaw 0 is x, and clockwise seen from above."""

    __slots__ = ("pitch", "yaw", "roll")

    def __init__(self, pitch=0.0, yaw=0.0, roll=0.0):
        self.pitch, self.yaw, self.roll = float(pitch), float(yaw), float(roll)

    def __eq__(self, other):
        return isinstance(other, Rotation) and (self.pitch, self.yaw, self.roll) == (other.pitch, other.yaw, other.roll)

    def __hash__(self):
        return hash((self.pitch, self.yaw, self.roll))

    def __repr__(self):
        return f"Rotation(pitch={self.pitch:f}, yaw={self.yaw:f}, roll={self.roll:f})"

    def get_forward_vector(self):
        yaw, pitch = math.radians(self.yaw), math.radians(self.pitch)
        return Vector3D(math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch))

    def get_right_vector(self):
        yaw = math.radians(self.yaw)
        return Vector3D(-math.sin(yaw), math.cos(yaw), 0.0)

    def get_up_vector(self):
        return self.get_forward_vector().cross(self.get_right_vector())


class Transform:
    """A place and an attitude."""

    __slots__ = ("location", "rotation")

    def __init__(self, location=None, rotation=None):
        self.location = location if location is not None else Location()
        self.rotation = rotation if rotation is not None else Rotation()

    def __eq__(self, other):
        return isinstance(other, Transform) and (self.location, self.rotation) == (other.location, other.rotation)

    def __hash__(self):
        return hash((self.location, self.rotation))

    def __repr__(self):
        return f"Transform({self.location}, {self.rotation})"

    def transform(self, point):
        """The point of this frame in the world's (yaw only)."""
        yaw = math.radians(self.rotation.yaw)
        cos, sin = math.cos(yaw), math.sin(yaw)
        return Location(
            self.location.x + cos * point.x - sin * point.y,
            self.location.y + sin * point.x + cos * point.y,
            self.location.z + point.z,
        )

    def get_forward_vector(self):
        return self.rotation.get_forward_vector()

    def get_right_vector(self):
        return self.rotation.get_right_vector()

    def get_up_vector(self):
        return self.rotation.get_up_vector()


class BoundingBox:
    """A box by its middle and its half sizes."""

    def __init__(self, location=None, extent=None):
        self.location = location if location is not None else Location()
        self.extent = extent if extent is not None else Vector3D()
        self.rotation = Rotation()


class GeoLocation:
    def __init__(self, latitude=0.0, longitude=0.0, altitude=0.0):
        self.latitude, self.longitude, self.altitude = latitude, longitude, altitude


class Color:
    def __init__(self, r=0, g=0, b=0, a=255):
        self.r, self.g, self.b, self.a = int(r), int(g), int(b), int(a)

    def __eq__(self, other):
        return isinstance(other, Color) and (self.r, self.g, self.b, self.a) == (other.r, other.g, other.b, other.a)

    def __hash__(self):
        return hash((self.r, self.g, self.b, self.a))

    def __repr__(self):
        return f"Color({self.r}, {self.g}, {self.b}, {self.a})"
