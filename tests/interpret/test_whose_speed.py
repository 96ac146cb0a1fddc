"""Whose speed is told, and that it rises or falls."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter


def read(text: str):
    return EmbeddedInterpreter().interpret(text).structure


@pytest.mark.parametrize(
    "text",
    [
        "A pedestrian crosses the road from the right; walking speed 5 km/h.",
        "A pedestrian crosses the road from the right. Pedestrian speed is 5 km/h.",
        "A 5 km/h pedestrian crosses the road from the right.",
    ],
)
def test_the_speed_of_a_walk_is_not_that_of_ego(text: str) -> None:
    structure = read(text)
    (person,) = structure.objects
    assert person.spec.speed == pytest.approx(1.39, abs=0.01)
    assert structure.ego.spec.speed > 5


@pytest.mark.parametrize(
    ("text", "action", "speed"),
    [
        ("The speed of the car ahead drops from 80 to 30 km/h.", "brake", 8.33),
        ("Ego follows a truck at 60 km/h. Its speed suddenly drops to 30 km/h.", "brake", 8.33),
        ("Ego follows a truck. The truck's speed is reduced to 30 km/h after 5 s.", "brake", 8.33),
    ],
)
def test_a_speed_that_changes_is_a_deed(text: str, action: str, speed: float) -> None:
    (phase,) = read(text).objects[0].spec.phases
    assert phase.action == action
    assert phase.speed == pytest.approx(speed, abs=0.01)


@pytest.mark.parametrize("scene", ["scene", "clip", "street", "story"])
def test_a_place_where_somebody_does_something_does_not_do_it(scene: str) -> None:
    assert len(read(f"Create a {scene} where a pedestrian on the right crosses the road.").objects) == 1
