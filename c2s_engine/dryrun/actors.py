"""A fake CARLA actor behind each object: what actions call, with the body that moves."""

import copy
import math
from typing import Any

import carla

from c2s_engine.dryrun.dynamics import CLASSES, Body


class Placed(carla.Actor):
    """Anything with a place. x, y, heading are Scenic's; what goes in and out is CARLA's."""

    def __init__(self, number: int, blueprint: str, body: Body, size: tuple[float, float, float], role: str) -> None:
        self.id, self.type_id, self.body, self.size = number, blueprint, body, size
        self.attributes = {"role_name": role}
        self.is_alive, self.physics, self.elevation = True, True, 0.0
        extent = carla.Vector3D(size[0] / 2, size[1] / 2, size[2] / 2)
        self.bounding_box = carla.BoundingBox(carla.Location(0, 0, size[2] / 2), extent)

    def get_location(self) -> Any:
        return carla.Location(self.body.x, -self.body.y, self.elevation)

    def get_transform(self) -> Any:
        return carla.Transform(self.get_location(), carla.Rotation(yaw=-math.degrees(self.body.heading) - 90.0))

    def get_velocity(self) -> Any:
        vx, vy = self.body.velocity()
        return carla.Vector3D(vx, -vy, 0.0)

    def get_angular_velocity(self) -> Any:
        return carla.Vector3D(0.0, 0.0, -math.degrees(self.body.yaw_rate))

    def get_acceleration(self) -> Any:
        return carla.Vector3D()

    def set_location(self, location: Any) -> None:
        self.body.x, self.body.y = location.x, -location.y

    def set_transform(self, transform: Any) -> None:
        self.set_location(transform.location)
        self.body.heading = -math.radians(transform.rotation.yaw + 90.0)

    def set_target_velocity(self, velocity: Any) -> None:
        if self.physics and not self.body.dead:
            self.body.set_velocity(velocity.x, -velocity.y)

    def set_target_angular_velocity(self, velocity: Any) -> None:
        self.body.yaw_rate = -math.radians(velocity.z)

    set_angular_velocity = set_target_angular_velocity

    def set_simulate_physics(self, enabled: bool = True) -> None:
        self.physics = bool(enabled)

    def destroy(self) -> bool:
        self.is_alive = False
        return True

    def advance(self, dt: float) -> None:
        """One substep: things stand still."""


class Prop(Placed):
    """A thing that does not move."""


class VehicleActor(Placed, carla.Vehicle):
    """A vehicle that rides on its own wheels."""

    def __init__(self, *args: Any) -> None:
        super().__init__(*args)
        self._control = carla.VehicleControl()
        self.light_state = carla.VehicleLightState.NONE
        self.autopilot = False
        self.traffic_light: Any = None

    def get_control(self) -> Any:
        return copy.copy(self._control)

    def apply_control(self, control: Any) -> None:
        self._control = copy.copy(control)
        body = self.body
        body.throttle = min(1.0, max(0.0, control.throttle))
        body.brake = min(1.0, max(0.0, control.brake))
        body.steer = min(1.0, max(-1.0, control.steer))
        body.handbrake = bool(control.hand_brake)
        body.reverse = bool(control.reverse) or (control.manual_gear_shift and control.gear < 0)

    def set_autopilot(self, enabled: bool = True, port: int = 8000) -> None:
        self.autopilot = bool(enabled)

    def set_light_state(self, state: Any) -> None:
        self.light_state = state

    def get_light_state(self) -> Any:
        return self.light_state

    def is_at_traffic_light(self) -> bool:
        return self.traffic_light is not None

    def get_traffic_light(self) -> Any:
        return self.traffic_light

    def advance(self, dt: float) -> None:
        if self.physics:
            self.body.advance(dt)


class WalkerActor(Placed, carla.Walker):
    """A person on foot: goes where it is told, at once."""

    def __init__(self, *args: Any) -> None:
        super().__init__(*args)
        self._control = carla.WalkerControl()
        self._steered = False
        self.jumping = 0.0
        self.guide: Any = None

    def get_control(self) -> Any:
        control = copy.copy(self._control)
        control.direction = copy.copy(control.direction)
        return control

    def apply_control(self, control: Any) -> None:
        self._control = copy.copy(control)
        self._control.direction = copy.copy(control.direction)
        self._steered = True
        if control.jump and not self.jumping:
            self.jumping = 0.6

    def set_target_velocity(self, velocity: Any) -> None:
        super().set_target_velocity(velocity)
        self._steered = False

    def advance(self, dt: float) -> None:
        body = self.body
        if body.dead:
            body.speed = body.sideways = 0.0
            return
        if self.jumping:
            self.jumping = max(0.0, self.jumping - dt)
            self.elevation = 4.905 * self.jumping * (0.6 - self.jumping)
        if self.guide is not None and self.guide.active:
            self.guide.lead(dt)
        elif self._steered:
            direction, speed = self._control.direction, self._control.speed
            size = math.hypot(direction.x, direction.y)
            if size and speed:
                body.heading = math.atan2(-direction.x, -direction.y)
            body.speed, body.sideways = (speed if size else 0.0), 0.0
        vx, vy = body.velocity()
        body.x += vx * dt
        body.y += vy * dt


def class_of(blueprint: str, kinds: dict[str, str]) -> str:
    """The class of a blueprint: car, truck, van, bus, motorcycle, bicycle, walker or prop."""
    if blueprint in kinds:
        return kinds[blueprint]
    if blueprint.startswith("walker."):
        return "walker"
    return "car" if blueprint.startswith("vehicle.") else "prop"


def make(number: int, obj: Any, kind: str) -> Placed:
    """The actor of a Scenic object."""
    size = (float(obj.length), float(obj.width), float(obj.height))
    body = Body(CLASSES.get(kind, CLASSES["car"]), obj.position.x, obj.position.y, obj.heading, size[0])
    role = str(obj.rolename) if getattr(obj, "rolename", None) is not None else ""
    form = VehicleActor if kind in CLASSES else WalkerActor if kind == "walker" else Prop
    return form(number, str(getattr(obj, "blueprint", "") or ""), body, size, role)
