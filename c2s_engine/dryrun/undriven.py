"""Objects of world models that know of no CARLA: the abstract driving model's, the Newtonian one's, plain ones.

Scenic leaves it to a simulator to give them what their actions need. Here they get our vehicles and our walkers: while
a run lasts, an object's class is one derived from its own, with the setters that the actions call.
"""

import functools
from typing import Any

from scenic.core.vectors import Vector
from scenic.domains.driving.actions import Steers, Walks
from scenic.simulators.carla.utils import utils


class _Acting:
    """What objects of CARLA's world model have, too: the control that is gathered in a step."""

    carlaActor: Any
    _control: Any

    @property
    def control(self) -> Any:
        if self._control is None:
            self._control = self.carlaActor.get_control()
        return self._control

    def setPosition(self, pos: Any, elevation: Any) -> None:
        self.carlaActor.set_location(utils.scenicToCarlaLocation(pos, elevation))

    def setVelocity(self, vel: Any) -> None:
        self.carlaActor.set_target_velocity(utils.scenicToCarlaVector3D(*vel))


class _Driving(_Acting, Steers):
    def setThrottle(self, throttle: float) -> None:
        self.control.throttle = throttle

    def setSteering(self, steering: float) -> None:
        self.control.steer = steering

    def setBraking(self, braking: float) -> None:
        self.control.brake = braking

    def setHandbrake(self, handbrake: bool) -> None:
        self.control.hand_brake = handbrake

    def setReverse(self, reverse: bool) -> None:
        self.control.reverse = reverse


class _Walking(_Acting, Walks):
    def setWalkingDirection(self, heading: float) -> None:
        self.control.direction = utils.scenicToCarlaVector3D(*Vector(0, 1, 0).rotatedBy(heading))

    def setWalkingSpeed(self, speed: float) -> None:
        self.control.speed = speed


DRIVEN = ("car", "van", "truck", "bus", "motorcycle", "bicycle")
KINDS = {**dict.fromkeys(DRIVEN, _Driving), "walker": _Walking, "prop": _Acting}


def kind_of(obj: Any) -> str | None:
    """What a vehicle's class is called (a car, if nothing else), walker or prop; None for an object of CARLA's world
    model, whose blueprint tells more."""
    if hasattr(obj, "carlaActor"):
        return None
    if getattr(obj, "isVehicle", False):
        return next((name for cls in type(obj).__mro__ if (name := cls.__name__.lower()) in DRIVEN), "car")
    return "walker" if any(cls.__name__ == "Pedestrian" for cls in type(obj).__mro__) else "prop"


def adapt(obj: Any, kind: str) -> None:
    """Give an object, for the time of a run, what the actions of its kind ask for."""
    obj.__class__ = _adapted(obj.__class__, KINDS[kind])
    obj._control = None


@functools.cache
def _adapted(own: type, more: type) -> type:
    return type(own)(own.__name__, (more, own), {"__module__": own.__module__})
