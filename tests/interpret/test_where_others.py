"""Where one is, seen from another: before and behind it, between it and ego, with it, on the other side."""

import pytest


@pytest.mark.parametrize(
    ("text", "position", "gap"),
    [
        ("The truck is 40 m in front of ego. 20 m behind the truck a motorcycle follows.", "behind", 20.0),
        ("The truck drives 40 m in front of ego; 15 m ahead of the truck, a van brakes.", "ahead", 15.0),
        ("A truck stands 60 m in front of ego. About 10 m behind the truck there is a small car.", "behind", 10.0),
    ],
)
def test_a_place_before_the_one_who_is_there(read, text: str, position: str, gap: float) -> None:
    place = read(text)["O2"].spec.placement
    assert (place.position, place.of, place.gap) == (position, "O1", gap)


@pytest.mark.parametrize(
    "text",
    [
        "A truck drives 50 m ahead of ego; between ego and the truck there is a small red car.",
        "The bus is 60 m ahead. Between the ego vehicle and the bus a cyclist rides at 15 km/h.",
        "A lorry is 40 m ahead of ego and a motorcycle drives between the lorry and ego.",
    ],
)
def test_between_ego_and_another(read, text: str) -> None:
    s = read(text)
    far, near = s["O1"].spec.placement, s["O2"].spec.placement
    assert near.position == "ahead" and max(near.gap) < far.gap


def test_between_without_distances(read) -> None:
    s = read("A van is between the ego car and a stopped truck. The van swerves to the left.")
    assert s["O2"].spec.placement.of == "O1" and s["O2"].spec.placement.position == "ahead"


@pytest.mark.parametrize(
    ("text", "places"),
    [
        ("A truck stands in ego's lane with cones behind it.", [("ahead", "ego"), ("behind", "O1")]),
        ("Ego drives on a motorway with a truck behind it and a van in front of it.",
         [("behind", "ego"), ("ahead", "ego")]),
        ("A police car stands in the right lane with a warning sign in front of it.",
         [("right_lane", "ego"), ("ahead", "O1")]),
    ],
)  # fmt: skip
def test_told_of_with_another(read, text: str, places: list) -> None:
    assert [(o.spec.placement.position, o.spec.placement.of) for o in read(text).objects] == places


@pytest.mark.parametrize(
    ("text", "position", "side"),
    [
        ("A car is parked on the opposite side of the street.", "parked", "left"),
        ("A pedestrian waits at the opposite kerb and then crosses.", "sidewalk", "left"),
        ("A man stands on the right.", "roadside", "right"),
        ("A cyclist is on the road and a hedge hides a pedestrian standing on the left. The pedestrian waits.",
         "roadside", "left"),
    ],
)  # fmt: skip
def test_sides_of_the_road(read, text: str, position: str, side: str) -> None:
    place = read(text).objects[-1].spec.placement
    assert (place.position, place.side) == (position, side)


def test_one_side_each(read) -> None:
    s = read("A man stands on the left and a car is parked on the right.")
    assert [o.spec.placement.side for o in s.objects] == ["left", "right"]


@pytest.mark.parametrize(
    "text",
    [
        "A car on the other carriageway crosses the median and comes into ego's lane.",
        "A motorcycle on the other side of the median loses control and slides into ego's lane.",
    ],
)
def test_over_the_median(read, text: str) -> None:
    s = read(text)
    assert s["O1"].spec.placement.position == "oncoming_lane"
    assert "oncoming" in [p.action for p in s["O1"].spec.phases]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "There are two vehicles ahead of ego: a van directly ahead and a truck in front of the van.",
            [("van", "ahead"), ("truck", "ahead")],
        ),
        (
            "Ego follows a van, which swerves into the left lane, revealing a truck that stands in ego's lane.",
            [("van", "ahead"), ("truck", "ahead")],
        ),
        (
            "A stationary truck stands in ego's lane; the van between ego and the truck changes to the left lane.",
            [("van", "ahead"), ("truck", "ahead")],
        ),
    ],
)
def test_who_is_before_whom(read, text: str, expected: list[tuple[str, str]]) -> None:
    found = [(o.spec.type, o.spec.placement.position) for o in read(text).objects]
    assert found == expected
