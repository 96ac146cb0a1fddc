"""The town's network as stock Scenic parses it, once for all tests of the room, and the names that programs have."""

import warnings

import pytest

from c2s_engine import paths
from c2s_engine.maps.extras import read_extras

TOWN = paths.shipped("maps", "town.xodr")


@pytest.fixture(scope="session")
def extras():
    return read_extras(TOWN)


@pytest.fixture(scope="session")
def names():
    """`network`, `ManeuverType`, `Vector`, and the warnings that parsing gave."""
    from scenic.core.vectors import Vector
    from scenic.domains.driving.roads import ManeuverType, Network

    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        network = Network.fromFile(TOWN, useCache=False, writeCache=False)
    return {"network": network, "ManeuverType": ManeuverType, "Vector": Vector, "warnings": caught}
