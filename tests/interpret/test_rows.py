"""Ego as one of a row, in a queue or between two; whom "behind it" means beside ego; who runs after whom."""

import pytest


def rows(structure) -> list[tuple[str, int, str]]:
    return [(o.spec.type, o.spec.count, o.spec.placement.position) for o in structure.objects]


@pytest.mark.parametrize(
    ("text", "kind", "others"),
    [
        (
            "The ego is the second of three trucks that run at 80 km/h with gaps of 12 m.",
            "truck",
            [("truck", 1, "ahead"), ("truck", 1, "behind")],
        ),
        (
            "Three trucks drive in the right lane with 15 m between them; the ego is the middle one.",
            "truck",
            [("truck", 1, "ahead"), ("truck", 1, "behind")],
        ),
        ("The ego is the last of four cars waiting at a red light.", "car", [("car", 3, "ahead")]),
        ("The ego is the first of three trucks in a platoon.", "truck", [("truck", 2, "behind")]),
        ("Four buses travel in convoy. The ego is the last of them.", "bus", [("bus", 3, "ahead")]),
    ],
)
def test_ego_has_a_rank(read, text: str, kind: str, others: list) -> None:
    s = read(text)
    assert (s.ego.spec.type, rows(s)) == (kind, others)


def test_a_row_shares_gap_and_speed(read) -> None:
    s = read("The ego is the second of three trucks that run at 80 km/h with gaps of 12 m.")
    assert round(s.ego.spec.speed * 3.6) == 80
    assert [o.spec.placement.gap for o in s.objects] == [12.0, 12.0]


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("The ego is stuck in a queue at a red light.", 2),
        ("The ego is standing in a long line at the traffic light.", 2),
    ],
)
def test_who_stands_before_ego_in_a_queue(read, text: str, count: int) -> None:
    s = read(text)
    assert s.ego.spec.speed == 0.0
    assert [(o.spec.count, o.spec.placement.position, o.spec.speed) for o in s.objects] == [(count, "ahead", 0.0)]


@pytest.mark.parametrize(
    "text",
    [
        "The ego is the first in line at a red light.",
        "The ego waits in line with the kerb.",
    ],
)
def test_nobody_before_ego(read, text: str) -> None:
    assert not read(text).objects


@pytest.mark.parametrize(
    "text",
    [
        "The ego is parked at the right kerb between two other parked cars.",
        "The agent starts parallel parked on the right side, boxed in between two other parked cars.",
        "The ego stands in a parking bay between two parked cars and pulls out.",
    ],
)
def test_parked_between_two(read, text: str) -> None:
    places = [o.spec.placement for o in read(text).objects]
    assert [(p.position, p.along) for p in places] == [("parked", "ahead"), ("parked", "behind")]


@pytest.mark.parametrize(
    "text",
    [
        "There is a van in front of the ego and a cyclist rides behind it.",
        "A truck is ahead of the ego, and a cyclist rides close behind it.",
    ],
)
def test_behind_whom_ego_follows(read, text: str) -> None:
    place = read(text).objects[1].spec.placement
    assert (place.position, place.of) == ("behind", "O1")


def test_an_owner_without_an_animal_is_nobody(read) -> None:
    assert len(read("The ego hit a parked car. The owner of the car ran out into the road.").objects) == 1


def test_after_the_ball(read) -> None:
    s = read("A ball rolls into the road from the left. A boy runs after it.")
    assert s.objects[0].spec.placement.side == "left"


def test_a_rider_at_the_lights_rides(read) -> None:
    s = read("A courier on a bicycle stood at the lights. The ego stopped behind him.")
    assert [o.spec.type for o in s.objects] == ["bicycle"]


@pytest.mark.parametrize(
    ("text", "gaps"),
    [
        (
            "On a motorway the ego drives in the left lane and passes a truck. "
            "A car comes towards it in the same lane; the initial distance is 400 m.",
            [None, 400.0],
        ),
        ("A bus is behind the ego. A van drives ahead of the ego, the gap is 15 m.", [None, 15.0]),
        ("The ego follows a truck. The initial distance is 30 m.", [30.0]),
    ],
)
def test_whose_distance_it_is(read, text: str, gaps: list) -> None:
    assert [o.spec.placement.gap for o in read(text).objects] == gaps
