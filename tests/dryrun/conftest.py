"""The real road network of the town, hand-made ways on it, and programs run in this process."""

import os
import random
import sys
import warnings
from importlib import resources
from pathlib import Path

import numpy as np
import pytest

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
STANDINS = str(resources.files("c2s_engine.data").joinpath("standins"))
sys.path.insert(0, STANDINS)
warnings.simplefilter("ignore")
import scenic  # noqa: E402
import scenic.simulators.carla.simulator  # noqa: E402
from scenic.domains.driving.roads import Network  # noqa: E402
from scenic.syntax import translator  # noqa: E402

from c2s_engine.check import networks, warm  # noqa: E402
from c2s_engine.dryrun import runner  # noqa: E402
from c2s_engine.dryrun.events.derivation import derive  # noqa: E402
from c2s_engine.dryrun.recording import Path as Way  # noqa: E402
from c2s_engine.dryrun.recording import Recording  # noqa: E402
from c2s_engine.dryrun.roads import index_of  # noqa: E402
from c2s_engine.maps.extras import read_extras  # noqa: E402

sys.path.remove(STANDINS)
TOWN = Path(str(resources.files("c2s_engine.data").joinpath("maps/town.xodr")))
DT = 0.1


class Town:
    """Hand-made ways on the town's lanes, and what they show."""

    def __init__(self, network):
        self.network = network
        self.index = index_of(network)
        self.extras = read_extras(TOWN)

    def lane(self, road, lane=0):
        """The index of a lane of a road; lane 0 is the rightmost in the road's own direction."""
        found = next(r for r in self.network.roads if int(r.id) == road)
        lanes = found.forwardLanes.lanes if lane >= 0 else found.backwardLanes.lanes
        return self.index.number[lanes[lane if lane >= 0 else -lane - 1].uid]

    def ride(self, name, lane, start, speed, aside=0.0, kind="car", steps=201, against=False, size=(4.5, 2.0, 1.5),
             heading=None, lanes=None, role="", blueprint=""):  # fmt: skip
        """A way along a lane's line: m from its start, m/s (a number or one a step), m to the left."""
        speed = np.broadcast_to(np.asarray(speed, float), steps).copy()
        aside = np.broadcast_to(np.asarray(aside, float), steps).copy()
        s = start + np.concatenate([[0.0], np.cumsum(speed[:-1]) * DT]) * (-1 if against else 1)
        points = self.index.line(lanes or self.index.path(lane, float(abs(s).max()) + 50.0))
        along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
        i = np.clip(np.searchsorted(along, s, side="right") - 1, 0, len(points) - 2)
        unit = (points[i + 1] - points[i]) / np.hypot(*(points[i + 1] - points[i]).T)[:, None]
        x = points[i, 0] + unit[:, 0] * (s - along[i]) - unit[:, 1] * aside
        y = points[i, 1] + unit[:, 1] * (s - along[i]) + unit[:, 0] * aside
        turned = np.arctan2(-unit[:, 0], unit[:, 1]) + (np.pi if against else 0.0)
        return self.way(name, x, y, turned if heading is None else np.full(steps, heading), kind, size, role, blueprint)

    def way(self, name, x, y, heading, kind="car", size=(4.5, 2.0, 1.5), role="", blueprint=""):
        """A way by its coordinates."""
        x, y = np.asarray(x, float), np.asarray(y, float)
        vx, vy = np.diff(x, append=2 * x[-1] - x[-2]) / DT, np.diff(y, append=2 * y[-1] - y[-2]) / DT
        heading = np.broadcast_to(np.asarray(heading, float), len(x)).copy()
        blueprint = blueprint or {"prop": "static.prop.box01", "walker": "walker.pedestrian.0001"}.get(
            kind, "vehicle.x.y"
        )
        return Way(name, kind, blueprint, role, *size, x, y, heading, vx, vy)

    def walk(self, name, lane, s, start, speed, steps=201, role="", kind="walker"):
        """Somebody who walks across a lane at `s`: from `start` m left of its middle to the right (m/s)."""
        speed = np.broadcast_to(np.asarray(speed, float), steps)
        info = self.index.lanes[lane]
        x, y = info.point_at(s)
        h = info.heading_at(s)
        d = start - np.concatenate([[0.0], np.cumsum(speed[:-1]) * DT])
        size = (1.8, 0.6, 1.6) if kind == "bicycle" else (0.5, 0.5, 1.8)
        return self.way(name, x - np.cos(h) * d, y - np.sin(h) * d, h - np.pi / 2, kind, size, role)

    def prop(self, name, lane, s, aside=0.0, role="", blueprint="static.prop.box01", heading=None, steps=201):
        """A thing beside or on a lane."""
        more = {"size": (0.7, 0.7, 0.7), "heading": heading, "role": role, "blueprint": blueprint}
        return self.ride(name, lane, s, 0.0, aside, "prop", steps, **more)

    def facts(self, *ways, contacts=(), lights=(), **params):
        """What hand-made ways show."""
        recording = Recording(DT, list(ways), list(contacts), list(lights), params)
        return derive(recording, self.index, self.extras)

    def through(self, junction, kind, arm=0):
        """The lanes of a manoeuvre through a junction: lane before, connecting lane, lane after."""
        crossing = next(i for i in self.network.intersections if int(i.id) == junction)
        maneuver = [m for m in crossing.maneuvers if m.type.name == kind][arm]
        return [self.index.number[x.uid] for x in (maneuver.startLane, maneuver.connectingLane, maneuver.endLane)]


@pytest.fixture(scope="session")
def network():
    original = Network.fromFile.__func__
    found = networks.from_file(original)(Network, TOWN)
    compile_stream = translator.compileStream

    def from_file(cls, path, *args, **options):
        return found if Path(path).samefile(TOWN) else original(cls, path, *args, **options)

    Network.fromFile = classmethod(from_file)
    library = str(Path(scenic.__file__).parent)

    def compile_once(stream, namespace, options, filename):
        chosen = warm._compile_stream if str(filename).startswith(library) else compile_stream
        return chosen(stream, namespace, options, filename)

    translator.compileStream = compile_once
    yield found
    translator.compileStream = compile_stream
    Network.fromFile = classmethod(original)


@pytest.fixture(scope="session")
def town(network):
    return Town(network)


HEAD = f"""
param map = {str(TOWN)!r}
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model
"""


@pytest.fixture(scope="session")
def run(network):
    """Compile, sample and run a program here; gives the runner's Run with the scene's network."""

    def go(text, seconds=6.0, seed=0):
        random.seed(seed)
        np.random.seed(seed)
        scenario = scenic.scenarioFromString(HEAD + text, mode2D=True)
        scene, _ = scenario.generate(maxIterations=200)
        names = {id(o): getattr(o, "name", f"o{i}") for i, o in enumerate(scene.objects)} | {id(scene.egoObject): "ego"}
        return runner.simulate(scene, names=names, seed=seed, seconds=seconds, map_path=str(TOWN))

    return go
