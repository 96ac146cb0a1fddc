"""When something is done, wherever and however the sentence says so: behind a comma, in a clause of its own."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "Ego drives at 70 km/h where 50 is allowed.",
        "A car comes at 70 km/h, where only 50 km/h are permitted. Ego drives at 40 km/h.",
    ],
)
def test_the_limit_that_is_told_beside_a_speed(read, text: str) -> None:
    assert round(read(text).place.spec.speed_limit, 2) == 13.89


@pytest.mark.parametrize(
    "text",
    [
        "Ego drives at 40 km/h. A cyclist crosses the lane from right to left.",
        "Ego drives at 40 km/h. A cyclist crosses ego's lane from the right.",
        "Ego drives at 40 km/h. A cyclist emerges from the right and crosses the lane from right to left.",
        "Ego drives at 40 km/h. An e-scooter rider crosses the lane from right to left.",
    ],
)
def test_a_cyclist_across_the_lane(read, text: str) -> None:
    (one,) = read(text).objects
    assert (one.spec.placement.position, one.spec.placement.side) == ("roadside", "right")
    assert [p.action for p in one.spec.phases] == ["cross_road"]


@pytest.mark.parametrize(
    "text",
    [
        "There is two cars. Ego drives at 50 km/h from south to north, the other car comes from the left.",
    ],
)
def test_ego_and_another_are_the_two(read, text: str) -> None:
    (one,) = read(text).objects
    assert one.spec.placement.position == "crossing_left"


@pytest.mark.parametrize(
    "text",
    [
        "Ego turns left. An adversary, a sedan, comes the other way. Ego waits for the sedan that comes near.",
        "Ego turns left. The first adversary, a sedan, comes the other way at 70 km/h. The sedan goes straight.",
        "Ego drives. The lead vehicle, a pickup, brakes. The pickup then stops.",
    ],
)
def test_one_that_was_named_besides_its_part(read, text: str) -> None:
    assert len(read(text).objects) == 1


@pytest.mark.parametrize(
    "text",
    [
        "Ego drives at 70 km/h. It changes lanes to the left while a van in that lane brakes.",
        "Ego drives at 70 km/h and changes lanes to the left. A van in that lane brakes.",
    ],
)
def test_the_lane_that_ego_changes_to(read, text: str) -> None:
    (one,) = read(text).objects
    assert one.spec.placement.position == "left_lane"


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("Trucks in a platoon. Ego follows two trucks.", 2),
    ],
)
def test_those_of_a_title_that_are_counted_then(read, text: str, count: int) -> None:
    assert [o.spec.count for o in read(text).objects] == [count]
