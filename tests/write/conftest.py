"""The writer on the shipped town."""

import pytest

from c2s_engine.maps.library import MapLibrary
from c2s_engine.session.places import map_choice
from c2s_engine.write.typed import TypedWriter


@pytest.fixture(scope="session")
def writer() -> TypedWriter:
    library = MapLibrary()
    return TypedWriter(map_choice(library, library.find("town")))
