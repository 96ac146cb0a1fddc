"""What of Scenic is cut short while a run goes on: nothing is random then, so values go straight where they belong."""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import shapely
from scenic.core.distributions import RejectionException
from scenic.core.vectors import Vector

from c2s_engine.dryrun.plain import flat_orientation


@contextmanager
def lookups(network: Any) -> Iterator[dict[Any, Any]]:
    """While this lasts, the network finds elements at points without looking for random values, and each once a step.

    Yields the memory of found elements; whoever moves things clears it.
    """
    known: dict[Any, Any] = {}
    ranks: dict[int, dict[str, int]] = {}

    def find(point: Any, elems: Any, reject: Any) -> Any:
        position = getattr(point, "position", point)
        x, y = float(position[0]), float(position[1])
        key = (x, y, id(elems))
        if key not in known:
            known[key] = _find(network, x, y, elems, ranks)
        found = known[key]
        if found is None and reject:
            raise RejectionException(reject if isinstance(reject, str) else "requested element does not exist")
        return found

    network.__dict__["findPointIn"] = find
    try:
        yield known
    finally:
        network.__dict__.pop("findPointIn", None)


def _find(network: Any, x: float, y: float, elems: Any, ranks: dict[int, dict[str, int]]) -> Any:
    """The first of the elements that holds the point, exactly or else within the network's tolerance."""
    order = ranks.get(id(elems))
    if order is None:
        order = ranks[id(elems)] = {}
        for i, elem in enumerate(elems):
            order.setdefault(elem.uid, i)
    point = shapely.Point(x, y)
    for distance in (0, network.tolerance):
        if distance:
            hits = network._rtree.query(point, predicate="dwithin", distance=distance)
        else:
            hits = network._rtree.query(point, predicate="intersects")
        numbers = [order[uid] for uid in (network._uidForIndex[i] for i in hits) if uid in order]
        if numbers:
            return elems[min(numbers)]
        if network.tolerance <= 0:
            break
    return None


class Mirror:
    """Writes the state of an actor to its Scenic object, as `Simulation.updateObjects` would."""

    def __init__(self, obj: Any, actor: Any) -> None:
        self.obj, self.actor = obj, actor
        parent = obj.parentOrientation
        self.parent, self.parent_yaw = parent, float(parent.yaw)
        self.seen: tuple[float, ...] | None = None
        self.known: set[str] = set()

    def write(self) -> None:
        body, obj = self.actor.body, self.obj
        vx, vy = body.velocity()
        state = (body.x, body.y, body.heading, vx, vy, self.actor.elevation, body.yaw_rate)
        values = object.__getattribute__(object.__getattribute__(obj, "_dynamicProxy"), "__dict__")
        for name in values.keys() - self.known:
            if name.startswith("_cached_"):
                del values[name]
            else:
                self.known.add(name)
        if state == self.seen:
            return
        self.seen = state
        x, y, heading, _, _, elevation, rate = state
        yaw = math.remainder(heading - self.parent_yaw, math.tau)
        values["position"] = Vector(x, y, elevation)
        values["velocity"] = Vector(vx, vy, 0.0)
        values["speed"] = math.hypot(vx, vy)
        values["angularSpeed"] = rate
        values["angularVelocity"] = Vector(0.0, 0.0, rate)
        values["yaw"], values["pitch"], values["roll"] = yaw, 0.0, 0.0
        values["elevation"] = elevation
        values["orientation"] = flat_orientation(heading)
        values["heading"] = math.remainder(heading, math.tau)
