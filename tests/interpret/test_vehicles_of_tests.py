"""The vehicles of tests by their many names, what falls off them, and when in the test something is done."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "The car ahead brakes hard after 3 s down to 20 km/h.",
        "The lead vehicle brakes hard after 3 s to a speed of 20 km/h.",
    ],
)
def test_the_time_of_a_braking(read, text: str) -> None:
    (phase,) = read(text).objects[0].spec.phases
    assert phase.action == "brake"
    assert phase.trigger.value == 3.0
    assert round(phase.speed, 2) == 5.56


@pytest.mark.parametrize(
    ("text", "after"),
    [
        ("Ego turns right after 5 s.", 5.0),
        ("Ego drives on a road and turns left after 4 s.", 4.0),
        ("The ego goes along a street and turns right after about 6 s.", 6.0),
    ],
)
def test_the_time_of_a_turn(read, text: str, after: float) -> None:
    (phase,) = read(text).ego.spec.phases
    assert phase.action.startswith("turn_")
    assert phase.trigger.value == after


@pytest.mark.parametrize(
    "text",
    [
        "Ego drives at 50 km/h. It avoids a pallet shed by the lorry in front.",
        "Ego drives at 50 km/h. It evades a crate lost by the leading truck.",
    ],
)
def test_who_drops_something_ahead_drives_there(read, text: str) -> None:
    s = read(text)
    assert {o.spec.type for o in s.objects} == {"box", "truck"}
    truck = next(o for o in s.objects if o.spec.type == "truck")
    assert truck.spec.speed > 5
    assert not truck.spec.phases


@pytest.mark.parametrize(
    "text",
    [
        "Ego drives at 40 km/h. There is a pedestrian on the right and a truck behind.",
        "Ego drives at 40 km/h. There is a pedestrian on the right and a truck behind it.",
        "Ego drives at 40 km/h. Pedestrian on the right, truck behind.",
        "Ego drives at 40 km/h with a pedestrian on the right and a truck behind.",
    ],
)
def test_each_has_a_place_of_its_own(read, text: str) -> None:
    s = read(text)
    by = {o.spec.type: o.spec.placement for o in s.objects}
    assert by["pedestrian"].position == "roadside"
    assert by["pedestrian"].side == "right"
    assert by["truck"].position == "behind"


@pytest.mark.parametrize(
    "text",
    [
        "Ego drives at 80 km/h. The vehicle in front, a pickup 30 m ahead, brakes hard.",
    ],
)
def test_who_is_told_by_place_and_then_named(read, text: str) -> None:
    (one,) = read(text).objects
    assert one.spec.type == "truck"
    assert one.spec.placement.gap == 30.0
    assert [p.action for p in one.spec.phases] == ["brake"]


@pytest.mark.parametrize(
    "text",
    [
        "Ego, at 40 km/h, comes up on a truck stopped in its lane.",
        "Ego drives at 40 km/h and comes upon a garbage truck stopped dead in its lane.",
        "Ego drives at 40 km/h towards a truck stopped in its lane.",
    ],
)
def test_one_that_stands_where_ego_comes(read, text: str) -> None:
    s = read(text)
    (one,) = s.objects
    assert [p.action for p in one.spec.phases] == ["stationary"]
    assert not [p for p in s.ego.spec.phases if p.action == "stop"]
