"""One program in CARLA, through Scenic's own interface:

    python -m c2s_engine.calibrate.in_carla FILE HOST PORT SECONDS

A process of its own: it needs the real `carla` package, and a client that waits for its server cannot be cancelled
otherwise. The last line on stdout is `Trajectories` as JSON, or `{"error": why}`; exit code 3: no server to talk to.
SIGINT and SIGTERM end it in order, so that the server is not left waiting for ticks.
"""

import json
import signal
import sys
from typing import Any

from c2s_engine.structure.facts import Track, Trajectories

ANSWER, LOADING = 10, 60
"""s that the server may take to say its version, and for any other call; loading a town takes most of them."""


class NoServer(RuntimeError):
    """There is no CARLA to talk to; the message is the client's."""


def drive(file: str, host: str, port: int, seconds: float) -> Trajectories:
    """The ways of all objects. Raises NoServer, and whatever Scenic raises."""
    import carla
    import scenic
    from scenic.simulators.carla import simulator as stock

    class Recorded(stock.CarlaSimulation):
        """Scenic's simulation, that keeps headings and speeds beside positions."""

        def currentState(self) -> tuple:
            return tuple((o.position.x, o.position.y, o.heading, o.speed) for o in self.objects)

    stock.CarlaSimulation = Recorded
    try:
        client = carla.Client(host, port)
        client.set_timeout(ANSWER)
        client.get_server_version()
    except RuntimeError as error:
        raise NoServer(str(error).partition(", make sure")[0]) from error
    params = {"address": host, "port": port, "render": 0, "timeout": LOADING}
    scenario = scenic.scenarioFromFile(file, params=params, mode2D=True)
    simulator = scenario.getSimulator()
    try:
        scene, _ = scenario.generate(maxIterations=1)
        steps = round(seconds / simulator.timestep)
        run = simulator.createSimulation(scene, timestep=None, maxSteps=steps, name="calibration")
    finally:
        simulator.destroy()
    return Trajectories(step=run.timestep, tracks=tuple(_track(o, i, run) for i, o in enumerate(run.objects)))


def _track(thing: Any, place: int, run: Any) -> Track:
    x, y, heading, speed = zip(*(state[place] for state in run.result.trajectory), strict=True)
    name = ("ego", "other")[place]
    return Track(name=name, x=x, y=y, heading=heading, speed=speed, length=thing.length, width=thing.width)


def _leave(*_: Any) -> None:
    raise KeyboardInterrupt


def main() -> int:
    signal.signal(signal.SIGTERM, _leave)
    file, host, port, seconds = sys.argv[1:]
    try:
        found = drive(file, host, int(port), float(seconds))
    except Exception as error:  # noqa: BLE001
        print(f"\n{json.dumps({'error': str(error) or type(error).__name__})}")
        return 3 if isinstance(error, NoServer) else 1
    print(f"\n{found.model_dump_json()}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
