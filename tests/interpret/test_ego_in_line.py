"""Ego as one of a line of vehicles, and others who are told again by where they are."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "Three cars drive in a row. The third car, the ego, follows. The first car brakes.",
        "Three cars drive in a row. The last one is the ego. The first car brakes.",
        "The ego is the last of three cars in a column. The first brakes.",
        "Three cars, the last of which is the ego, drive in a row. The first car brakes.",
    ],
)
def test_last_in_line(read, text: str) -> None:
    middle, first = (o.spec for o in read(text).objects)
    assert middle.count == first.count == 1
    assert not middle.phases
    assert [p.action for p in first.phases] == ["brake"]
    assert first.placement.of == "O1"


@pytest.mark.parametrize(
    "text",
    [
        "Three trucks drive in a convoy. The ego is the middle truck. The lead truck brakes.",
        "We were the second of three vehicles in line. The vehicle in front braked.",
    ],
)
def test_middle_of_line(read, text: str) -> None:
    others = {o.spec.placement.position: o.spec for o in read(text).objects}
    assert {place: [p.action for p in o.phases] for place, o in others.items()} == {"ahead": ["brake"], "behind": []}


def test_vehicles_in_line_are_no_lanes(read) -> None:
    assert read("The ego is the second of three cars. The first brakes.").place.spec.lanes is None
    assert read("The ego drives in the second of three lanes.").place.spec.lanes == 3


@pytest.mark.parametrize(
    "text",
    [
        "Car in front stops. Ego stops behind it. Car in front moves off again.",
        "Step 1: van ahead stops, ego stops behind it. Step 2: van ahead moves off.",
        "Bus in front stops. Ego stops. Bus in front sets off.",
    ],
)
def test_told_again_without_article(read, text: str) -> None:
    (one,) = read(text).objects
    assert [p.action for p in one.spec.phases] == ["stop", "start"]


@pytest.mark.parametrize(
    "text",
    [
        "The ego waits behind a bus in the left lane.",
        "A bus stands in the left lane. The ego waits behind it.",
        "We were stopped behind a bus in the left lane.",
        "The ego stops behind a bus, which is blocking the left lane.",
    ],
)
def test_behind_one_in_a_lane(read, text: str) -> None:
    scene = read(text)
    assert scene.place.spec.ego_lane == "leftmost"
    assert [o.spec.placement.position for o in scene.objects] == ["ahead"]


@pytest.mark.parametrize(
    "text",
    [
        "In the left lane traffic goes on flowing at 36 km/h. The ego stands in the right lane.",
        "The ego stands in the right lane. Traffic in the left lane keeps moving at 36 km/h.",
        "Traffic to the left of the ego flows at 36 km/h. The ego stands.",
    ],
)
def test_traffic_goes_on(read, text: str) -> None:
    scene = read(text)
    (traffic,) = (o.spec for o in scene.objects)
    assert (traffic.placement.position, traffic.speed) == ("left_lane", 10.0)
    assert scene.ego.spec.speed != 10.0


def test_system_vehicle(read) -> None:
    for over in ("the separating marking", "the dividing line", "the lane marking"):
        text = f"With the system active, a passenger car moves across {over} into the lane of the system vehicle."
        assert [p.action for o in read(text).objects for p in o.spec.phases] == ["cut_in"], over
