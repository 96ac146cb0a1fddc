"""Shortcuts in front of Scenic's operators for values that are not random.

Scenic wraps every function and operator so that it also takes random and delayed values, and looks for such values in
each call. While a scene runs there are hardly any, and the looking takes most of the time. Here each wrapper is given a
cheap test in front: arguments that are plain go straight to the wrapped function, all others to Scenic's wrapper as
before. The results are the same; `install` may be called in any process that has imported Scenic, once.
"""

import functools
import math
import sys
import types
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from scenic.core import distributions, errors, object_types, type_support, vectors
from scenic.core.vectors import Orientation, Vector
from scenic.syntax import veneer
from scipy.spatial.transform import Rotation

NUMBERS = frozenset({float, int, np.float64})
PLAIN = NUMBERS | {bool, str, type(None), types.GeneratorType, types.FunctionType}
MAY_HOLD_RANDOM = (tuple, list, slice)
_installed = False


def install() -> None:
    """Put the shortcuts in place, in every module of Scenic that is loaded."""
    global _installed
    if _installed:
        return
    _installed = True
    errors.hiddenFolders.append(__file__)  # as Scenic's own files, it is no place of an error in a program
    codes = {
        _inner(maker)
        for maker in (
            distributions.distributionFunction, distributions.distributionMethod, vectors.scalarOperator,
            vectors.vectorOperator, vectors.vectorDistributionMethod,
        )
    }  # fmt: skip
    shorter: dict[Any, Any] = {}
    modules = [m for name, m in list(sys.modules.items()) if name == "scenic" or name.startswith("scenic.")]
    for module in modules:
        _replace(module, codes, shorter)
        for value in list(vars(module).values()):
            if isinstance(value, type) and value.__module__ == module.__name__:
                _replace(value, codes, shorter)
    _vectors()
    Orientation.r = functools.cached_property(_rotation)  # type: ignore[assignment]
    Orientation.r.__set_name__(Orientation, "r")
    _conversions()
    _calls()
    _objects()


def _inner(maker: Any) -> types.CodeType:
    """The code of the wrapper that a decorator makes."""
    return next(c for c in maker.__code__.co_consts if isinstance(c, types.CodeType) and c.co_name == "helper")


def _replace(owner: Any, codes: set[types.CodeType], shorter: dict[Any, Any]) -> None:
    """Each wrapper in a module or class by its shortcut."""
    for name, value in list(vars(owner).items()):
        inner = value.__func__ if isinstance(value, classmethod | staticmethod) else value
        if not isinstance(inner, types.FunctionType) or inner.__code__ not in codes or _identity(inner):
            continue
        short = shorter.get(inner) or shorter.setdefault(inner, _shortcut(inner))
        setattr(owner, name, short if inner is value else type(value)(short))


def _identity(wrapper: Any) -> bool:
    """Whether the wrapper looks at its operand for more than randomness."""
    names = dict(zip(wrapper.__code__.co_freevars, wrapper.__closure__ or (), strict=True))
    return "identity" in names and names["identity"].cell_contents is not None


def _shortcut(wrapper: Any) -> Callable[..., Any]:
    plain = {"max": max, "min": min}.get(wrapper.__qualname__, wrapper.__wrapped__)

    @functools.wraps(wrapper)
    def short(*args: Any, **kwargs: Any) -> Any:
        for arg in args:
            if arg.__class__ not in PLAIN and _special(arg):
                return wrapper(*args, **kwargs)
        if kwargs and any(_special(arg) for arg in kwargs.values()):
            return wrapper(*args, **kwargs)
        return plain(*args, **kwargs)

    return short


def _special(value: Any) -> bool:
    """Whether a value is random or delayed, or may hold such values."""
    return isinstance(value, MAY_HOLD_RANDOM) or getattr(value, "_isLazy", False)


def _vectors() -> None:
    """Vectors of numbers: made without a search for random parts, and computed with directly."""
    slow_init = Vector.__init__
    for name, value in CONSTANT.items():
        setattr(Vector, name, value)
    Vector._conditioned = property(_conditioned, _condition)

    def init(self: Vector, x: Any, y: Any, z: Any = 0) -> None:
        if x.__class__ in NUMBERS and y.__class__ in NUMBERS and z.__class__ in NUMBERS:
            self.coordinates = (x, y, z)
        else:
            slow_init(self, x, y, z)

    Vector.__init__ = init  # type: ignore[method-assign]
    Vector.__getstate__ = _state  # type: ignore[method-assign]
    for name, fast in (("__sub__", _minus), ("__add__", _plus), ("distanceTo", _distance), ("rotatedBy", _rotated)):
        setattr(Vector, name, _guarded(getattr(Vector, name), fast))


CONSTANT = {
    "_dependencies": (), "_requiredProperties": (), "_needsSampling": False, "_needsLazyEval": False, "_isLazy": False,
}  # fmt: skip
"""What Scenic notes in each vector, where it holds numbers only."""


def _state(vector: Any) -> dict[str, Any]:
    """For pickles that a process without the shortcuts may read."""
    return CONSTANT | {"_conditioned": vector} | vector.__dict__


def _conditioned(vector: Any) -> Any:
    return vector.__dict__.get("_conditioned", vector)


def _condition(vector: Any, value: Any) -> None:
    vector.__dict__["_conditioned"] = value


def _guarded(slow: Any, fast: Callable[[Any, Any], Any]) -> Callable[..., Any]:
    @functools.wraps(slow)
    def guarded(self: Any, other: Any) -> Any:
        if self._isLazy:
            return slow(self, other)
        found = fast(self, other)
        return slow(self, other) if found is NotImplemented else found

    return guarded


def _minus(a: Any, b: Any) -> Any:
    if b.__class__ is not Vector or b._isLazy:
        return NotImplemented
    (x, y, z), (u, v, w) = a.coordinates, b.coordinates
    return Vector(x - u, y - v, z - w)


def _plus(a: Any, b: Any) -> Any:
    if b.__class__ is not Vector or b._isLazy:
        return NotImplemented
    (x, y, z), (u, v, w) = a.coordinates, b.coordinates
    return Vector(x + u, y + v, z + w)


def _distance(a: Any, b: Any) -> Any:
    if b.__class__ is not Vector or b._isLazy:
        return NotImplemented
    (x, y, z), (u, v, w) = a.coordinates, b.coordinates
    return math.hypot(u - x, v - y, w - z)


def _rotated(a: Any, angle: Any) -> Any:
    kind = angle.__class__
    if kind not in NUMBERS:
        return NotImplemented
    x, y, z = a.coordinates
    c, s = math.cos(angle), math.sin(angle)
    return Vector((c * x) - (s * y), (s * x) + (c * y), z)


def _rotation(orientation: Any) -> Any:
    return Rotation.from_quat(orientation.q)


def flat_orientation(heading: float) -> Any:
    """The orientation of who stands upright with a heading (rad); SciPy's rotation is made when it is asked for."""
    made = Orientation.__new__(Orientation)
    made.q = np.array([0.0, 0.0, math.sin(heading / 2), math.cos(heading / 2)])
    return made


def _conversions() -> None:
    """A value that has the type already (or an object whose position is asked for) needs no conversion."""
    slow = type_support.toTypes

    def to_types(thing: Any, types: Iterable[Any], typeError: str = "wrong type") -> Any:
        first = next(iter(types))
        if thing.__class__ is Vector:
            if first is Vector:
                return thing
        elif first is Vector and isinstance(thing, object_types.Object) and not thing._isLazy:
            return thing.position
        elif first is float and thing.__class__ is float:
            return thing
        return slow(thing, types, typeError)

    for name, module in list(sys.modules.items()):
        if name.startswith("scenic.") and getattr(module, "toTypes", None) is slow:
            module.toTypes = to_types  # type: ignore[attr-defined]


def _calls() -> None:
    """A call with `*values` needs no wrapper of its own where none of the values is random."""
    slow = veneer.callWithStarArgs

    def call(_func_to_call: Any, *args: Any, **kwargs: Any) -> Any:
        if kwargs or any(arg.__class__ not in PLAIN and _special(arg) for arg in args):
            return slow(_func_to_call, *args, **kwargs)
        return _func_to_call(*args)

    veneer.callWithStarArgs = call


def _objects() -> None:
    """An object's attributes are looked up in its copy for the run without a detour."""
    get = object.__getattribute__

    def attribute(self: Any, name: str, get: Any = get) -> Any:
        return get(get(self, "_dynamicProxy"), name)

    object_types.Object.__getattribute__ = attribute  # type: ignore[method-assign]
