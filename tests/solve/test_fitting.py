"""Of the speeds of a scene the fewest are lowered that keep everybody in the same order."""

import pytest

from c2s_engine.require.scene import Scene
from c2s_engine.solve.fitting import slower
from c2s_engine.solve.unknowns import unknowns
from c2s_engine.structure.components import FITTED, Component, Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Placement, PlaceSpec
from c2s_engine.write.typed.usual_values import usual_values


def scene(ego: float | None, *others: ObjectSpec) -> Structure:
    return Structure(
        place=Component(id="R", spec=PlaceSpec(kind="road")),
        ego=Component(id="E", spec=EgoSpec(speed=ego)),
        objects=tuple(Component(id=f"O{k}", spec=o) for k, o in enumerate(others, 1)),
    )


def car(speed: float, position: str = "ahead") -> ObjectSpec:
    return ObjectSpec(name="other", speed=speed, placement=Placement(position=position))  # type: ignore[arg-type]


def speeds(structure: Structure) -> dict[str, float]:
    return {c.id: c.spec.speed for c in (structure.ego, *structure.objects)}  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("structure", "first"),
    [
        (scene(20.0), {"E": 17.0}),
        (scene(20.0, car(10.0)), {"E": 17.0, "O1": 10.0}),  # still the faster one
        (scene(20.0, car(18.0)), {"E": 17.0, "O1": 15.3}),  # else it would be the slower one
        (scene(20.0, car(18.0), car(16.0)), {"E": 17.0, "O1": 15.3, "O2": 13.6}),
        (scene(20.0, car(20.0, "crossing_left")), {"E": 17.0, "O1": 20.0}),  # on another road
    ],
)
def test_the_fewest_are_lowered(structure, first):
    assert speeds(slower(structure, "Town07")[0]) == first


def test_what_is_left_open_is_lowered_before_what_is_said():
    found = slower(scene(None, car(12.0)), "Town07")
    assert speeds(found[0])["O1"] == 12.0
    assert [a.by for a in found[0]["E"].assumed] == ["planner"]
    assert min(speeds(each)["O1"] for each in found) < 12.0


def test_who_stands_or_walks_is_left_alone():
    child = ObjectSpec(name="child", type="child", speed=2.0, placement=Placement(position="sidewalk"),
                       phases=(Phase(action="cross_road"),))  # fmt: skip
    assert slower(scene(0.0, car(0.0), child), "Town07") == []


def test_a_lowered_speed_counts_as_said():
    after = slower(scene(20.0), "Town07")[0]
    (note,) = after.ego.assumed
    assert (note.by, note.value) == (FITTED, "61.2 km/h")
    assert note.reason == "72 km/h was specified; the roads of Town07 only allow 61.2 km/h"
    assert Scene(after).stated("E", "speed")
    assert ("E", "speed") not in {(u.component, u.path) for u in unknowns(after, usual_values(after, 1.0))}
