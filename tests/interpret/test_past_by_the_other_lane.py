"""Who gets past ego by the lane of oncoming traffic, stays behind until it can pass, or comes between the lines."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "A car passes ego in the opposite lane.",
        "A pickup goes past us over the solid line on a bend.",
        "A motorbike overtook me on the wrong side of the road.",
        "The minibus was southbound. A pickup behind it pulled into the northbound lane to go around it.",
    ],
)
def test_who_passes_by_the_lane_of_oncoming_traffic_gets_into_it(read, text: str) -> None:
    structure = read(text)
    assert actions(structure.objects[0]) == ["oncoming", "overtake"]
    assert "oncoming" not in actions(structure["E"])


@pytest.mark.parametrize(
    "text",
    [
        "We are in the left lane at 10 mph. A motorbike is filtering up between the two lines of cars.",
        "We crawl along in the left lane. A motorcycle comes up between the rows of cars.",
        "Ego crawls along. A motorcyclist weaves up between the lines of cars.",
    ],
)
def test_who_comes_between_the_lines_comes_past_ego(read, text: str) -> None:
    spec = read(text).objects[0].spec
    assert (spec.placement.position, spec.phases[0].action, spec.phases[0].target) == ("behind", "overtake", "ego")


@pytest.mark.parametrize("how", ["side by side", "abreast", "in single file"])
def test_who_rides_before_ego_in_a_group_does_not_cross(read, how: str) -> None:
    assert actions(read(f"Two cyclists ride {how} in front of the ego at 18 km/h.").objects[0]) == ["move_along"]


def test_the_system_vehicle_is_ego(read) -> None:
    structure = read(
        "A car in the adjacent lane moves across the separating marking into the lane of the system vehicle."
    )
    assert actions(structure.objects[0]) == ["cut_in"]


def test_oncoming_vehicles_are_there(read) -> None:
    structure = read("Oncoming vehicles keep the other lane busy, so the ego stays behind the cyclist.")
    assert [o.spec.placement.position for o in structure.objects] == ["oncoming_lane", "ahead"]
