"""A CARLA server and its client in one module: what Scenic's CARLA simulator asks of them, answered by the bodies of
the dry run, which obey `LAG` ticks late. So it is known what `c2s calibrate` must find different.

The values (locations, controls, weather) are those of data/standins/carla, which this package extends.
"""

import os
import signal
import socket
from pathlib import Path
from types import SimpleNamespace

VALUES = Path(__file__).parents[4] / "data" / "standins" / "carla"
__path__.append(str(VALUES))
exec(compile((VALUES / "__init__.py").read_text(encoding="utf-8"), str(VALUES), "exec"))

from carla.space import Location, Transform  # noqa: E402
from carla.weather import WeatherParameters  # noqa: E402

LAG = int(os.environ.get("STANDIN_LAG", "1"))
SUBSTEPS = 5


class Client:
    """A client whose server is this process."""

    def __init__(self, host, port):
        self.address, self.world = (host, port), Server()

    def set_timeout(self, seconds):
        pass

    def get_server_version(self):
        if os.environ.get("STANDIN_HANGS"):
            with socket.create_connection(self.address) as there:
                there.sendall(str(os.getpid()).encode())
            signal.pause()
        if os.environ.get("STANDIN_MUTE"):  # something listens there that is no CARLA; said as the real client says it
            raise RuntimeError(
                "time-out of 10000ms while waiting for the simulator, make sure the simulator is ready and connected"
            )
        return "0.9.15"

    def load_world(self, name):
        return self.world

    def generate_opendrive_world(self, text):
        assert "<OpenDRIVE" in text
        return self.world

    def get_world(self):
        return self.world

    def get_trafficmanager(self, port):
        return SimpleNamespace(set_synchronous_mode=lambda on: None, get_port=lambda: port)

    def stop_recorder(self):
        pass


class Blueprint:
    def __init__(self, id):
        self.id = id

    def has_attribute(self, name):
        return name == "role_name"

    def set_attribute(self, name, value):
        assert isinstance(value, str)


class Server:
    """The world, in synchronous mode: it stands still between ticks."""

    def __init__(self):
        self.settings, self.actors, self.due, self.frame = SimpleNamespace(), [], [], 0

    def get_settings(self):
        return self.settings

    def apply_settings(self, settings):
        self.settings = settings

    def get_map(self):
        return SimpleNamespace(get_waypoint=lambda spot: SimpleNamespace(transform=Transform(Location(spot.x, spot.y))))

    def get_blueprint_library(self):
        return SimpleNamespace(find=Blueprint)

    def set_weather(self, weather):
        assert isinstance(weather, WeatherParameters)

    def try_spawn_actor(self, blueprint, transform, attach_to=None):
        if attach_to is not None:
            return SimpleNamespace(stop=lambda: None, destroy=lambda: None)
        from math import radians

        from scenic.core.vectors import Vector
        from scenic.simulators.carla import blueprints

        from c2s_engine.dryrun import actors, runner

        where, turned, name = transform.location, -radians(transform.rotation.yaw + 90), blueprint.id
        size = {side: getattr(blueprints, side)(name, 0.5) for side in ("length", "width", "height")}
        thing = SimpleNamespace(
            blueprint=name, position=Vector(where.x, -where.y), heading=turned, rolename=None, **size
        )
        actor = actors.make(len(self.actors), thing, actors.class_of(name, runner.blueprint_classes()))
        for obeys in ("set_target_velocity", "apply_control"):
            if hasattr(actor, obeys):
                setattr(actor, obeys, self._late(getattr(actor, obeys)))
        self.actors.append(actor)
        return actor

    def _late(self, obey):
        return lambda told: self.due.append((self.frame + LAG, obey, told))

    def tick(self):
        for when, obey, told in self.due:
            if when <= self.frame:
                obey(told)
        self.due = [order for order in self.due if order[0] > self.frame]
        for actor in self.actors:
            for _ in range(SUBSTEPS):
                actor.advance(self.settings.fixed_delta_seconds / SUBSTEPS)
        self.frame += 1
        return self.frame
