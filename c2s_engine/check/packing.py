"""A road network in a form that is read several times faster than Scenic's own pickle, with equal values and types.

Shapes are read all at once. What a polyline holds beside its shape (points, segments, lengths: most of a pickle)
follows from the shape and is made when it is first asked for; where it would not come out the same it is kept.
"""

import copyreg
import io
import math
import mmap
import pickle
from collections.abc import Callable
from typing import Any

import numpy
import shapely
from shapely.geometry.base import BaseGeometry

FORMAT = 1
_HOW = "_packed_points"
"""Of a packed polyline: how its points are made (`_how`)."""


def pack(thing: Any) -> bytes:
    """A network, or anything that holds one, as bytes."""
    out = io.BytesIO()
    pickler = _Pickler(out)
    pickler.dump(thing)
    shapes = shapely.to_wkb(numpy.array(pickler.shapes, dtype=object), include_srid=True)
    return pickle.dumps((FORMAT, list(shapes), out.getvalue()), protocol=5)


def unpack(data: bytes | mmap.mmap) -> Any:
    """What was packed; raises pickle.UnpicklingError where the data is none of this."""
    install()
    try:
        form, shapes, body = pickle.loads(data)
        if form != FORMAT:
            raise ValueError
        known = shapely.from_wkb(numpy.array(shapes, dtype=object))
        return _Unpickler(io.BytesIO(body), list(known)).load()
    except pickle.UnpicklingError:
        raise
    except Exception as error:
        raise pickle.UnpicklingError("the packed network cannot be read") from error


class _Pickler(pickle.Pickler):
    def __init__(self, out: io.BytesIO) -> None:
        super().__init__(out, protocol=5)
        self.shapes: list[BaseGeometry] = []
        self._numbers: dict[int, int] = {}

    def persistent_id(self, thing: Any) -> int | None:
        if not isinstance(thing, BaseGeometry):
            return None
        number = self._numbers.setdefault(id(thing), len(self.shapes))
        if number == len(self.shapes):
            self.shapes.append(thing)
        return number

    def reducer_override(self, thing: Any) -> Any:
        from scenic.core.regions import PolylineRegion

        if type(thing) is not PolylineRegion:
            return NotImplemented
        shorter = _shortened({name: getattr(thing, name) for name in (*thing.__dict__, *_MADE)})
        return NotImplemented if shorter is None else (copyreg.__newobj__, (type(thing),), shorter)  # type: ignore[attr-defined]


class _Unpickler(pickle.Unpickler):
    def __init__(self, data: io.BytesIO, shapes: list[BaseGeometry]) -> None:
        super().__init__(data)
        self.persistent_load = shapes.__getitem__  # type: ignore[method-assign,assignment]


def _shortened(state: dict[str, Any]) -> dict[str, Any] | None:
    """A polyline's state without what follows from its shape; None where that does not give the same."""
    shape = state["lineString"]
    how: bytes | None = _how(state["points"])
    segments = _segments(shape)
    made = {"segments": segments, "cumulativeLengths": _lengths(segments), "points": _points(shape, segments, how)}
    if not all(_same(made[name], state[name]) for name in _MADE):
        made["points"] = _points(shape, segments, None)
        if not all(_same(made[name], state[name]) for name in _MADE):
            return None
        how = None
    return {**{name: value for name, value in state.items() if name not in _MADE}, _HOW: how}


def _how(points: Any) -> bytes:
    """For each coordinate of points that a polyline was made from whether it is a number of NumPy's or of Python's."""
    return bytes(isinstance(number, numpy.float64) for point in points for number in point[:2])


def _same(one: Any, other: Any) -> bool:
    """Whether two nests of tuples and lists are equal, with equal types."""
    if type(one) is not type(other):
        return False
    if isinstance(one, tuple | list):
        return len(one) == len(other) and all(map(_same, one, other))
    return bool(one == other)


def _segments(shape: BaseGeometry) -> list:
    from scenic.core.regions import PolylineRegion

    return PolylineRegion.segmentsOf(shape)


def _lengths(segments: list) -> list:
    found: list[Any] = []
    total: Any = 0
    for p, q in segments:
        total += math.hypot(p[0] - q[0], p[1] - q[1])
        found.append(total)
    return found


def _points(shape: BaseGeometry, segments: list, how: bytes | None) -> tuple:
    """A polyline's points: those that it was made from; where `how` is none, as Scenic takes them from a shape."""
    from scenic.core.type_support import toVector

    if how is not None:
        if not isinstance(shape, shapely.LineString):
            return ()
        kinds = [_NUMBERS[which] for which in how]
        coordinates = zip(shape.coords, kinds[::2], kinds[1::2], strict=False)
        return tuple((x(point[0]), y(point[1]), 0) for point, x, y in coordinates)
    found: list[Any] = []
    last: Any = None
    for p, q in segments:
        if last is None or p[:2] != last[:2]:
            found.append(toVector(p).coordinates)
        found.append(toVector(q).coordinates)
        last = q
    return tuple(found)


_NUMBERS: tuple[Callable[[float], float], ...] = (float, numpy.float64)
_MADE: dict[str, Callable[[Any], Any]] = {
    "segments": lambda line: _segments(line.lineString),
    "cumulativeLengths": lambda line: _lengths(line.segments),
    "points": lambda line: _points(line.lineString, line.segments, line.__dict__[_HOW]),
}


class _Late:
    """An attribute that is made when it is first asked for; one that an object has itself goes before it."""

    def __init__(self, name: str) -> None:
        self.name = name

    def __get__(self, line: Any, owner: Any = None) -> Any:
        if line is None or _HOW not in line.__dict__:
            raise AttributeError(self.name)
        made = line.__dict__[self.name] = _MADE[self.name](line)
        return made


def install() -> None:
    """Let polylines make what they were packed without."""
    from scenic.core.regions import PolylineRegion

    for name in _MADE:
        if not isinstance(vars(PolylineRegion).get(name), _Late):
            setattr(PolylineRegion, name, _Late(name))
