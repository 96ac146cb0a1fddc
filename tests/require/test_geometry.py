"""Distances between boxes, against the library that the driving library measures with."""

import numpy as np
import shapely
from hypothesis import given
from hypothesis import strategies as st
from shapely import affinity

from c2s_engine.require.geometry import box_distance

POSE = st.tuples(st.floats(-12, 12), st.floats(-12, 12), st.floats(-4, 4))
SIZE = st.tuples(st.floats(0.5, 12), st.floats(0.4, 3))


def outline(pose: tuple[float, float, float], size: tuple[float, float]) -> shapely.Polygon:
    box = shapely.box(-size[1] / 2, -size[0] / 2, size[1] / 2, size[0] / 2)
    return affinity.translate(affinity.rotate(box, pose[2], origin=(0, 0), use_radians=True), *pose[:2])


@given(POSE, POSE, SIZE, SIZE)
def test_boxes_are_as_far_apart_as_their_outlines(one, other, size, other_size):
    found = box_distance(np.array([one]), np.array([other]), size, other_size)
    assert abs(found[0] - outline(one, size).distance(outline(other, other_size))) < 1e-6
