"""Who has stopped and goes on; what a driver cannot hold; who does what a passive says, in a participle."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "It is an all way stop. V1 stopped, then started into the intersection, and V2 ran into it from the right.",
    ],
)
def test_who_stops_before_a_junction_then_goes_in(read, text: str) -> None:
    structure = read(text)
    assert [a for a in actions(structure["E"]) if a != "start"] == ["stop", "go_straight"]
    assert actions(structure.objects[0]) == ["collide"]


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("I turned the wheel but the car went straight on into the ditch.", "leave_road"),
        ("I hit a patch of ice and the car spun off the road.", "leave_road"),
        ("I lost it on the bend and the car just slid into a fence.", "collide"),
    ],
)
def test_the_car_that_gets_out_of_hand_is_ones_own(read, text: str, act: str) -> None:
    structure = read(text)
    assert actions(structure["E"])[-1] == act
    assert all(o.spec.type != "car" for o in structure.objects)


@pytest.mark.parametrize(
    "text",
    [
        "I was driving at 50 km/h and the car hit me from behind.",
        "We were doing 80 when the car swerved into our lane.",
        "I braked but the car behind carried on and ran into me.",
    ],
)
def test_the_car_that_does_something_to_me_is_another(read, text: str) -> None:
    assert [o.spec.type for o in read(text).objects] == ["car"]


@pytest.mark.parametrize(
    "text",
    [
        "Unit 1 was crossing and was hit by Unit 2 travelling through from the left.",
    ],
)
def test_who_is_named_before_a_participle_does_it(read, text: str) -> None:
    structure = read(text)
    assert actions(structure.objects[0])[-1] == "collide"
    assert "collide" not in actions(structure["E"])
