"""The stand-in as a server on the wire, for the real client of CARLA 0.9.16: `python wire.py PORT`.

Calls come as MessagePack-RPC at PORT, the world's snapshots go out at PORT + 1. What a calibration does not need is
answered with "done". Needs the package msgpack; the stand-in for `carla` beside this file must be on the path.
"""

import contextlib
import socket
import struct
import sys
import threading
import time

import carla
import msgpack
from scenic.simulators.carla import blueprints

DONE, OBSERVER, NOTHING = [[False]], 17, (0.0,) * 3
EMPTY = ("get_required_files", "query_lights_state", "get_vehicle_light_states")


class Wire:
    """What is asked of the server, answered by the stand-in's world."""

    def __init__(self, port):
        self.port, self.lock, self.streams = port, threading.RLock(), []
        self.episode, self.map = 0, ""
        self.settings = [False, False, [False], True, 0.01, 10, 0.0, False, 3.0, 2.0, True]
        ids = {name for members in blueprints.ids.values() for name in members} | {"controller.ai.walker"}
        role = ["role_name", 3, "", [], True, False]
        self.blueprints = [[k, name, name.replace(".", ","), [role]] for k, name in enumerate(sorted(ids), 1)]
        self.begin()

    def begin(self):
        """A new episode, which runs on by itself until the client ticks."""
        self.episode, self.world, self.known = self.episode + 1, carla.Server(), {}
        self.world.settings.fixed_delta_seconds = 0.1
        self.world.frame = 1000 * self.episode
        self.set([False, *self.settings[1:]])

    def set(self, settings):
        self.settings = settings
        if not settings[0]:
            threading.Thread(target=self.run, args=(self.episode,), daemon=True).start()
        return self.tick()

    def run(self, episode):
        while episode == self.episode and not self.settings[0]:
            self.tick()
            time.sleep(0.05)

    def tick(self):
        with self.lock:
            frame = self.world.tick()
            self.send()
            return frame

    def send(self):
        message = self.snapshot()
        for stream in list(self.streams):
            try:
                stream.sendall(struct.pack("<I", len(message)) + message)
            except OSError:  # nobody reads it any more
                self.streams.remove(stream)

    def snapshot(self):
        told = struct.pack("<QQd6f", OBSERVER, self.world.frame, self.world.frame / 10, *NOTHING, *NOTHING)
        told += struct.pack("<Qdf4i", self.episode, time.time(), 0.1, 0, 0, 0, 0)
        return told + b"".join(self.state(number) for number in self.known)

    def state(self, number):
        actor, _ = self.known[number]
        if actor is None:
            return struct.pack("<IB15f54x", number, 2, *NOTHING * 5)
        at, speed, turn = actor.get_transform(), actor.get_velocity(), actor.get_angular_velocity()
        place, turned = at.location, at.rotation
        values = (place.x, place.y, place.z, turned.pitch, turned.yaw, turned.roll)
        values += (speed.x, speed.y, speed.z, turn.x, turn.y, turn.z, *NOTHING)
        return struct.pack("<IB15f", number, 2, *values) + self.control(actor).ljust(54, b"\0")

    def control(self, actor):
        if isinstance(actor, carla.Walker):
            c = actor.get_control()
            return struct.pack("<4f?", c.direction.x, c.direction.y, c.direction.z, c.speed, c.jump)
        if isinstance(actor, carla.Vehicle):
            c = actor.get_control()
            pedals = c.throttle, c.steer, c.brake, c.hand_brake, c.reverse, c.manual_gear_shift, c.gear
            return struct.pack("<3f3?ifB?IB", *pedals, 30, 2, False, 0, 0)
        return b""

    def spawn(self, told, transform, parent=0, *_):
        number, name, actor, half = 100 + len(self.known), told[1], None, (0.5, 0.5, 0.5)
        if not parent:
            place, turned = transform
            at = carla.Transform(carla.Location(*place), carla.Rotation(*turned))
            actor = self.world.try_spawn_actor(carla.Blueprint(name), at)
            half = tuple(side / 2 for side in actor.size)
        box = [NOTHING, half, NOTHING, number]
        self.known[number] = actor, [number, parent, told, box, b"", b""]
        return self.known[number][1]

    def answer(self, name, told):
        """What is answered to a call; None: done."""
        if name in EMPTY:
            return []
        if name.startswith("spawn_actor"):
            return self.spawn(*told)
        if name.startswith("apply_control_to_"):
            walker = name.endswith("walker")
            direction, *rest = told[1]
            actor = self.known[told[0]][0]
            given = carla.WalkerControl(carla.Vector3D(*direction), *rest) if walker else carla.VehicleControl(*told[1])
            actor.apply_control(given)
            return None
        return {
            "version": lambda: "0.9.16",
            "get_episode_info": lambda: [self.episode, self.token(1)],
            "get_sensor_token": lambda: self.token(told[0]),
            "get_episode_settings": lambda: self.settings,
            "set_episode_settings": lambda: self.set(told[0]),
            "tick_cue": self.tick,
            "load_new_episode": lambda: self.begin(),
            "copy_opendrive_to_file": lambda: setattr(self, "map", told[0]),
            "get_map_info": lambda: ["OpenDriveMap", []],
            "get_map_data": lambda: self.map,
            "get_weather_parameters": lambda: [0.0] * 14,
            "get_actor_definitions": lambda: self.blueprints,
            "get_actors_by_id": lambda: [self.known[number][1] for number in told[0] if number in self.known],
            "get_actor_bounding_box": lambda: self.known[told[0]][1][3],
            "set_actor_target_velocity": lambda: self.known[told[0]][0].set_target_velocity(carla.Vector3D(*told[1])),
            "destroy_actor": lambda: self.known.pop(told[0], None) is not None,
            "is_traffic_manager_running": lambda: False,
            "add_traffic_manager_running": lambda: True,
        }.get(name, lambda: None)()

    def token(self, stream):
        return [struct.pack("<IHBB4s12x", stream, self.port + 1, 1, 1, socket.inet_aton("127.0.0.1"))]

    def calls(self, connection):
        unpacker = msgpack.Unpacker(raw=False, strict_map_key=False)
        with contextlib.suppress(OSError):
            while data := connection.recv(1 << 16):
                unpacker.feed(data)
                for _, number, name, (_, *told) in unpacker:
                    with self.lock:
                        value = self.answer(name, told)
                    reply = [] if name == "apply_batch" else DONE if value is None else [[1, value]]
                    connection.sendall(msgpack.packb([1, number, None, reply]))

    def subscribed(self, connection):
        connection.recv(4)
        connection.settimeout(1)
        with self.lock:
            self.streams.append(connection)


def serve(listening, answer):
    while True:
        connection, _ = listening.accept()
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        threading.Thread(target=answer, args=(connection,), daemon=True).start()


if __name__ == "__main__":
    at = int(sys.argv[1])
    calls, snapshots = (socket.create_server(("127.0.0.1", port)) for port in (at, at + 1))
    wire = Wire(at)
    threading.Thread(target=serve, args=(snapshots, wire.subscribed), daemon=True).start()
    print("ready", flush=True)
    serve(calls, wire.calls)
