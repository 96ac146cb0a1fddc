"""The shortcuts give what Scenic's own wrappers give, leave random values to those, and leave runs as they are."""

import math
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scenic.core import geometry, type_support, vectors
from scenic.core.distributions import Distribution, Range, needsSampling
from scenic.core.vectors import Orientation, Vector

from c2s_engine import paths
from c2s_engine.dryrun import plain

plain.install()
numbers = st.floats(-1e4, 1e4) | st.integers(-1000, 1000) | st.floats(-1e4, 1e4).map(np.float64)
points = st.tuples(numbers, numbers, numbers)
angles = st.floats(-10, 10)


def close(a, b):
    return np.allclose(np.asarray(tuple(a), float), np.asarray(tuple(b), float), rtol=1e-12, atol=1e-12)


def stock(shortcut):
    """What the shortcut stands in front of, down to Scenic's wrapper."""
    while shortcut.__module__ == plain.__name__ or hasattr(shortcut.__wrapped__, "__wrapped__"):
        shortcut = shortcut.__wrapped__
    return shortcut


@given(points, points)
def test_vectors_add_subtract_and_measure_as_before(a, b):
    one, two = Vector(*a), Vector(*b)
    for name in ("__add__", "__sub__"):
        assert close(getattr(Vector, name)(one, two), stock(getattr(Vector, name))(one, two))
        assert close(getattr(Vector, name)(one, b), stock(getattr(Vector, name))(one, b)), "with a tuple, too"
    assert one.distanceTo(two) == pytest.approx(stock(Vector.distanceTo)(one, two))


@given(points, angles)
def test_vectors_rotate_as_before(a, angle):
    assert close(Vector(*a).rotatedBy(angle), stock(Vector.rotatedBy)(Vector(*a), angle))
    turned = Vector(*a).rotatedBy(Orientation._fromHeading(angle))
    assert np.allclose(tuple(turned), tuple(Vector(*a).rotatedBy(angle)), atol=1e-6)


@given(st.lists(numbers, min_size=2, max_size=6))
def test_functions_of_numbers(values):
    assert geometry.min(*values) == min(values) and geometry.max(values) == max(values)
    assert geometry.max((v for v in values), default=0) == max(values)
    assert geometry.hypot(*values) == math.hypot(*values)
    assert geometry.normalizeAngle(values[0] % 7 - 3.5) == stock(geometry.normalizeAngle)(values[0] % 7 - 3.5)


def test_random_values_stay_random():
    some = Range(1, 2)
    for made in (geometry.min(some, 3), geometry.max([some, 3]), geometry.sin(some), geometry.hypot(3, some)):
        assert isinstance(made, Distribution)
        assert needsSampling(made) and made.sample() <= 4
    assert 1 <= geometry.min(some, 3).sample() <= 2 and geometry.max([some, 3]).sample() == 3
    for made in (Vector(some, 0) + Vector(1, 1), Vector(1, 1) - Vector(some, 0), Vector(1, 1).rotatedBy(some),
                 Vector(some, 0).rotatedBy(1.0)):  # fmt: skip
        assert needsSampling(made) and not needsSampling(made.sample())
    assert needsSampling(Vector(0, 0).distanceTo(Vector(some, 0)))
    assert 1 <= Vector(0, 0).distanceTo(Vector(some, 0)).sample() <= 2


@given(points)
def test_conversions_and_pickles(a):
    vector = Vector(*a)
    assert type_support.toVector(vector) is vector and type_support.toVector(a) == vector
    assert type_support.toScalar(a[0]) == float(a[0])
    with pytest.raises(TypeError):
        type_support.toVector(3.5)
    state = vector.__getstate__()
    assert {"coordinates", "_conditioned", "_dependencies", "_needsSampling", "_isLazy"} <= set(state)
    again = pickle.loads(pickle.dumps(vector))
    assert again == vector and again._conditioned == vector and not needsSampling(again)


@given(angles, points)
def test_an_upright_orientation_is_the_one_that_scipy_makes(heading, a):
    flat, full = plain.flat_orientation(heading), Orientation._fromHeading(heading)
    assert flat.approxEq(full)
    assert math.cos(flat.yaw - full.yaw) == pytest.approx(1) and close(flat.r.as_quat() ** 2, full.r.as_quat() ** 2)
    assert np.allclose(tuple(Vector(*a).applyRotation(flat)), tuple(Vector(*a).applyRotation(full)), atol=1e-6)
    assert vectors.alwaysGlobalOrientation(plain.flat_orientation(0.0))


SCRIPT = """
import pickle, sys
from c2s_engine import paths
from c2s_engine.check import warm
from c2s_engine.dryrun import plain
if sys.argv[1] == "stock":
    plain.install = lambda: None
warm.warm(paths.shipped("standins"), "c2s_engine.dryrun.runner:run_scene")
import scenic
from scenic.core.vectors import Orientation
if sys.argv[1] == "stock":
    from c2s_engine.dryrun import fast
    fast.flat_orientation = Orientation._fromHeading
from c2s_engine.dryrun import runner
found = []
for path in sys.argv[2:]:
    warm.reseed(1)
    scene, _ = scenic.scenarioFromFile(path, mode2D=True).generate(maxIterations=2000)
    names = {id(o): str(i) for i, o in enumerate(scene.objects)}
    run = runner.simulate(scene, names=names, seed=1, seconds=12, map_path=str(scene.params["map"]))
    assert run.ended_by not in ("error", "rejected"), run.reason
    found.append([(p.x.tolist(), p.y.tolist(), p.heading.tolist()) for p in run.recording.paths])
sys.stdout.buffer.write(pickle.dumps(found))
"""
PROGRAMS = ("02_pedestrian_from_behind_parked_van", "03_left_turn_oncoming", "04_cut_in_motorway")


@pytest.mark.full
def test_scenes_and_runs_are_those_of_stock_scenic(tmp_path):
    (tmp_path / "town.xodr").symlink_to(paths.shipped("maps", "town.xodr"))
    files = []
    for name in PROGRAMS:
        files.append(tmp_path / f"{name}.scenic")
        files[-1].write_text(Path(paths.shipped("examples", "programs", f"{name}.scenic")).read_text())
    made = []
    for mode in ("stock", "short"):
        done = subprocess.run([sys.executable, "-c", SCRIPT, mode, *map(str, files)], capture_output=True, check=True)
        made.append(pickle.loads(done.stdout))
    for one, two in zip(*made, strict=True):
        assert len(one) == len(two) > 1
        assert np.allclose(np.array(one), np.array(two), rtol=0, atol=1e-6)
