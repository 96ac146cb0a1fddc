"""What is commanded: throttle, steering, brake, walking."""

from carla.space import Vector3D


class _Values:
    """Equality and text from the attributes."""

    def __eq__(self, other):
        return type(other) is type(self) and other.__dict__ == self.__dict__

    __hash__ = None

    def __repr__(self):
        return f"{type(self).__name__}({', '.join(f'{k}={v}' for k, v in self.__dict__.items())})"


class VehicleControl(_Values):
    """Pedals 0..1, steering -1 (left) .. 1 (right)."""

    def __init__(
        self, throttle=0.0, steer=0.0, brake=0.0, hand_brake=False, reverse=False, manual_gear_shift=False, gear=0
    ):
        self.throttle, self.steer, self.brake = float(throttle), float(steer), float(brake)
        self.hand_brake, self.reverse = bool(hand_brake), bool(reverse)
        self.manual_gear_shift, self.gear = bool(manual_gear_shift), int(gear)


class VehicleAckermannControl(_Values):
    """Steering angle (rad), speed (m/s) and their limits."""

    def __init__(self, steer=0.0, steer_speed=0.0, speed=0.0, acceleration=0.0, jerk=0.0):
        self.steer, self.steer_speed, self.speed = float(steer), float(steer_speed), float(speed)
        self.acceleration, self.jerk = float(acceleration), float(jerk)


class AckermannControllerSettings(_Values):
    def __init__(self, **settings):
        self.__dict__.update(settings)


class WalkerControl(_Values):
    """A direction and a speed (m/s)."""

    def __init__(self, direction=None, speed=0.0, jump=False):
        self.direction = direction if direction is not None else Vector3D(1.0, 0.0, 0.0)
        self.speed, self.jump = float(speed), bool(jump)


class WheelPhysicsControl(_Values):
    def __init__(self, tire_friction=3.5, max_steer_angle=70.0, radius=35.0, **others):
        self.tire_friction, self.max_steer_angle, self.radius = tire_friction, max_steer_angle, radius
        self.__dict__.update(others)


class VehiclePhysicsControl(_Values):
    def __init__(self, mass=1500.0, drag_coefficient=0.3, wheels=(), **others):
        self.mass, self.drag_coefficient, self.wheels = mass, drag_coefficient, list(wheels)
        self.__dict__.update(others)
