"""Place expressions inside programs: Scenic compiles them as they are, and samples scenes on the places."""

import random

import numpy
import pytest

from c2s_engine.maps.expressions import place_code
from c2s_engine.maps.library import MapLibrary
from c2s_engine.structure.specs import PlaceSpec

PLACES = {
    "road": ("ego = new Car on place.centerline", {"kind": "road", "lanes": 2, "sidewalk": True}),
    "motorway": ("ego = new Car on place.centerline", {"kind": "motorway", "lanes": 3, "ego_lane": "middle"}),
    "curve": ("ego = new Car on place.centerline", {"kind": "curve", "curve": "left", "oncoming": True}),
    "intersection": (
        "ego = new Car following roadDirection from place.startLane.centerline[-1] for -60",
        {"kind": "intersection", "arms": 4, "control": "stop", "manoeuvre": "left", "distance": 60},
    ),
    "on_ramp": ("ego = new Car on place.startLane.centerline", {"kind": "on_ramp"}),
    "roundabout": ("ego = new Car on place.startLane.centerline", {"kind": "roundabout"}),
    "crosswalk": (
        "ego = new Car following roadDirection from place for -40",
        {"kind": "crosswalk", "oncoming": True, "distance": 40},
    ),
}


@pytest.fixture(scope="module")
def town(tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        library = MapLibrary()
        return library.working_copy(library.find("town"))


@pytest.mark.full
@pytest.mark.parametrize("kind", PLACES)
def test_places_stand_in_programs(town, extras, kind):
    import scenic

    line, fields = PLACES[kind]
    code = place_code(PlaceSpec(**fields), extras)
    program = (
        f"param map = {str(town)!r}\n"
        "param use2DMap = True\nmodel scenic.domains.driving.model\n"
        f"# {code.comment}\nplace = Uniform(*{code.expression})\n{line}\n"
    )
    scenario = scenic.scenarioFromString(program, mode2D=True)
    for seed in range(3):
        random.seed(seed)
        numpy.random.seed(seed)
        scene, _ = scenario.generate(maxIterations=200)
        position = scene.egoObject.position
        assert scenario.egoObject is not None
        network = scene.workspace.network
        assert network.laneAt(position) is not None
