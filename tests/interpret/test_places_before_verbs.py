"""The place before the verb, what takes the view by way of "so", rows of parked cars, "both" beside parked ones."""

import pytest


@pytest.mark.parametrize(
    ("text", "kind", "place"),
    [
        ("The ego drives on. On the sidewalk on the right waits a pedestrian.", "pedestrian", "sidewalk"),
        ("The ego drives on. On the shoulder is parked a truck.", "truck", "parked"),
        ("The ego drives on. In front of the ego is driving a tractor and the ego brakes.", "truck", "ahead"),
        ("The ego drives on. On the opposite lane is coming a truck.", "truck", "oncoming_lane"),
        ("Ego is in the right lane. From the back in the left lane is coming one fast car.", "car", "left_lane"),
        ("The ego drives on. In the oncoming lane waits a van with its lights on.", "van", "oncoming_lane"),
    ],
)
def test_the_place_stands_first(read, text: str, kind: str, place: str) -> None:
    spec = read(text).objects[0].spec
    assert (spec.type, spec.placement.position) == (kind, place)


@pytest.mark.parametrize(
    "text",
    [
        "A car came out of a driveway backwards on my left. There is a big hedge there so I couldn't see her.",
        "Put a big building on the corner, so the ego can not see the other car. The other car comes from the left.",
        "There is a truck in the oncoming lane, so the ego cannot see the motorcycle coming.",
        "A van stood at the kerb, which is why I did not see the boy who ran out.",
        "There is a wall on the corner, so the ego sees a car from the right only late.",
    ],
)
def test_so_that_it_cannot_be_seen(read, text: str) -> None:
    specs = [o.spec for o in read(text).objects]
    assert [s.placement.hidden_by for s in specs] == [None, "O1"]


def test_both_are_those_who_move(read) -> None:
    s = read(
        "The ego is parked between two parked cars. A cyclist comes by, then a van. When both have passed, it goes."
    )
    assert [[p.action for p in o.spec.phases] for o in s.objects[:2]] == [["stationary"], ["stationary"]]


@pytest.mark.parametrize(
    "text",
    [
        "The truck ahead of the ego changes lanes with a lateral speed of at most 1 m/s.",
        "Object 1 ahead of the ego performs a lane change with a lateral velocity of up to 1.2 m/s.",
    ],
)
def test_sideways_speed_is_no_speed(read, text: str) -> None:
    s = read(text)
    assert s.objects[0].spec.speed == s.ego.spec.speed
