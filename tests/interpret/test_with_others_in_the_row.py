"""Who stands in a row, who accompanies whom, who goes between ego and something, and what a rider rides."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "V2 was stopped as the last car in the queue. V1 ran into it.",
        "V2 stood as the third car at the red light, and V1 rear-ended it.",
        "V2 was waiting as the last vehicle in the line when V1 hit it.",
    ],
)
def test_as_the_last_one_is_the_same(read, text: str) -> None:
    structure = read(text)
    assert [actions(o) for o in structure.objects] == [["stationary"]]
    assert actions(structure["E"])[-1] == "collide"


def test_who_is_also_stopped_stands(read) -> None:
    first, second = read("V2 was stopped in the lane behind V3, likewise stopped. V1 struck the back of V2.").objects
    assert actions(first) == actions(second) == ["stationary"]


@pytest.mark.parametrize(
    "text",
    [
        "Vehicle 1 was eastbound. A truck was ahead of it, with Vehicle 2 behind it.",
    ],
)
def test_who_is_told_of_with_another_is_placed_by_it(read, text: str) -> None:
    truck, other = read(text).objects
    assert (truck.spec.placement.position, other.spec.placement.position) == ("ahead", "behind")


@pytest.mark.parametrize(
    "text",
    [
        "A scooter approached from the rear and tried to squeeze between the AV and the parked cars on the right.",
        "A motorbike squeezed between me and the parked cars on the right.",
        "A cyclist forced his way between my van and the kerb.",
    ],
)
def test_who_goes_between_ego_and_the_edge_overtakes_on_the_right(read, text: str) -> None:
    spec = read(text).objects[0].spec
    assert (spec.placement.position, spec.phases[0].action, spec.phases[0].side) == ("behind", "overtake", "right")


@pytest.mark.parametrize(
    "text",
    [
        "I was riding my Honda CB500 along the main road when a car cut me off.",
    ],
)
def test_what_the_first_person_rides_is_a_motorcycle(read, text: str) -> None:
    structure = read(text)
    assert structure["E"].spec.type == "motorcycle"
    assert len(structure.objects) == 1


@pytest.mark.parametrize(
    ("text", "lanes"),
    [
        ("I was on the 405, five lanes, in the middle one, doing 50 mph.", 4),
        ("Four lanes here, and I was in the third from the left.", 4),
        ("I was on the M6, three lanes, in the middle one.", 3),
    ],
)
def test_lanes_are_counted_beside_the_one_that_is_told(read, text: str, lanes: int) -> None:
    assert read(text)["R"].spec.lanes == lanes


@pytest.mark.parametrize("text", ["The flagger jumped clear, unhurt.", "He steered clear. V1 struck V2."])
def test_who_gets_clear_tells_nothing_of_the_sky(read, text: str) -> None:
    assert read(text)["G"].spec.weather == ()
