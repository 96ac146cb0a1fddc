"""The town's network as stock Scenic parses it, once for all tests of the room, and the names that programs have."""

import io
import shutil
import sys
import warnings

import pytest

from c2s_engine import driving, paths
from c2s_engine.maps.expressions import place_call
from c2s_engine.maps.extras import read_extras
from c2s_engine.structure.specs import PlaceSpec

TOWN = paths.shipped("maps", "town.xodr")


@pytest.fixture(scope="session")
def extras():
    return read_extras(TOWN)


PROGRAM = """
param map = {town!r}
param use2DMap = True
model scenic.domains.driving.model
from c2s_driving import *
"""


@pytest.fixture(scope="session")
def names(tmp_path_factory):
    """The names that a program on the town has, and the warnings that parsing its map gave."""
    return names_on(shutil.copy(TOWN, tmp_path_factory.mktemp("town")))


def names_on(town):
    """The names that a program on a map has: `network` and the driving library's; leaves no Scenic module loaded."""
    from scenic.syntax import translator

    found: dict = {}
    before = list(sys.modules)
    with warnings.catch_warnings(record=True) as caught, pytest.MonkeyPatch.context() as patch:
        warnings.simplefilter("always")
        patch.syspath_prepend(driving.path().parent)
        program = io.BytesIO(PROGRAM.format(town=str(town)).encode())
        try:
            translator.compileStream(program, found, translator.CompileOptions(mode2D=True), "town.scenic")
        finally:
            translator.purgeModulesUnsafeToCache(before)
    return {**found, "warnings": [w for w in caught if "boundary" not in str(w.message)]}


def places(names, approach=0.0, length=0.0, **fields):
    """The places of the town that a spec selects."""
    call = place_call(PlaceSpec(**fields), approach=approach, length=length, min_length=length)
    return eval(str(call), names)
