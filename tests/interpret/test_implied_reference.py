"""Who is told by his place beside nobody is beside ego; the places of others are told from him."""

import pytest


@pytest.mark.parametrize(
    ("text", "places"),
    [
        ("A car is 20 m ahead of a bus. The bus brakes.", [("behind", "ego", 20.0)]),
    ],
)
def test_where(read, text: str, places: list[tuple[str, str, float | None]]) -> None:
    found = [o.spec.placement for o in read(text).objects]
    assert [(p.position, p.of, p.gap) for p in found] == places


@pytest.mark.parametrize(
    ("text", "actions"),
    [
        ("The car ahead avoids a box on the road.", ["swerve"]),
        ("There is debris 100 m ahead and the van ahead swerves around it.", ["overtake"]),
        ("Ego stops behind a van until an oncoming car has gone by.", []),
        ("A tyre lies in ego's lane and the car ahead brakes.", ["brake"]),
    ],
)
def test_what_the_others_do(read, text: str, actions: list[str]) -> None:
    movers = [o.spec for o in read(text).objects if o.spec.type in ("car", "van") and o.spec.speed]
    assert [p.action for p in movers[-1].phases] == actions


def test_who_comes_from_in_front_of_a_bus_is_hidden_by_it(read) -> None:
    found = read("A pedestrian emerges from in front of a stopped bus and runs across the road.")
    hidden = next(o for o in found.objects if o.spec.type == "pedestrian")
    assert hidden.spec.placement.hidden_by == next(o.id for o in found.objects if o.spec.type == "bus")


@pytest.mark.parametrize(
    "text",
    [
        "Two children run across the street, a dog follows them.",
        "A child runs across the street, followed by a dog.",
    ],
)
def test_who_goes_after_one_who_crosses_crosses(read, text: str) -> None:
    assert [[p.action for p in o.spec.phases] for o in read(text).objects] == [["cross_road"]] * 2


@pytest.mark.parametrize(
    ("text", "actions"),
    [
        ("A horse rider trots along the right-hand edge of the road.", ["move_along"]),
        ("A man on horseback crosses.", ["cross_road"]),
    ],
)
def test_a_rider_on_a_horse_is_one(read, text: str, actions: list[str]) -> None:
    (rider,) = read(text).objects
    assert rider.spec.type == "animal" and [p.action for p in rider.spec.phases] == actions
