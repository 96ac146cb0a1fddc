"""Ego as one of a line of vehicles, and others who are told again by where they are."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "Three cars drive in a row. The third car, the ego, follows. The first car brakes.",
        "Three cars drive in a row. The last one is the ego. The first car brakes.",
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


def test_system_vehicle(read) -> None:
    for over in ("the separating marking", "the dividing line", "the lane marking"):
        text = f"With the system active, a passenger car moves across {over} into the lane of the system vehicle."
        assert [p.action for o in read(text).objects for p in o.spec.phases] == ["cut_in"], over
