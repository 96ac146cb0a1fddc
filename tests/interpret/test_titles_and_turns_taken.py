"""Who a title names, who goes first, who comes towards whom, and what hides somebody."""

import pytest


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Crossing vehicle. At a T-junction a pickup comes from the left and does not stop for the ego.", ["truck"]),
        ("Crossing vehicle does not stop. A van comes from the left while the ego goes straight.", ["van"]),
        ("Overtaking motorcycle. The ego drives at 80 km/h; a motorcycle passes it.", ["motorcycle"]),
        ("Wrong-way vehicle. The ego is on a motorway when a van comes towards it in its lane.", ["van"]),
        ("Vehicle ahead brakes. A truck behind ego hits it.", ["car", "truck"]),
        ("Lead vehicle brakes. A truck behind ego hits it.", ["car", "truck"]),
    ],
)
def test_who_a_title_names(read, text: str, types: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == types


@pytest.mark.parametrize(
    "text",
    ["The ego and a truck approach each other.", "A van and the ego drive towards each other on a rural road."],
)
def test_towards_each_other(read, text: str) -> None:
    assert read(text).objects[0].spec.placement.position == "oncoming_lane"


@pytest.mark.parametrize(
    "text",
    [
        "A bus stands in the opposite lane. From behind it, a cyclist rides across the ego's lane from the left.",
        "A bus is parked on the right. From in front of it, a child runs onto the road.",
    ],
)
def test_from_behind_it(read, text: str) -> None:
    assert read(text).objects[1].spec.placement.hidden_by == "O1"


@pytest.mark.parametrize("verb", ["forces its way into the gap", "squeezes into the space", "slips into a small gap"])
def test_into_the_gap(read, verb: str) -> None:
    s = read(f"The other car {verb} between ego and the truck ahead.")
    assert [p.action for p in s.objects[0].spec.phases] == ["cut_in"]


def test_what_it_starts_at(read) -> None:
    s = read("The lead vehicle starts 25 m in front of the ego.")
    assert s.objects[0].spec.placement.gap == 25


def test_a_fare_is_picked_up(read) -> None:
    s = read("A taxi ahead of ego stops to pick up a fare; ego passes it on the left and then goes back.")
    assert len(s.objects) == 1 and [p.action for p in s["E"].spec.phases] == ["overtake"]


def test_zips_over_the_crossing(read) -> None:
    s = read("A person on an e-scooter zips over the zebra crossing from right to left.")
    assert [p.action for p in s.objects[0].spec.phases] == ["cross_road"]


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Slow truck ahead. A car overtakes ego.", ["truck", "car"]),
        ("Parked vehicle on the right. A car pulls out in front of ego.", ["car", "car"]),
    ],
)
def test_who_is_only_in_the_title(read, text: str, types: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == types


@pytest.mark.parametrize(
    ("text", "phases"),
    [
        ("Ego brakes. A car behind it runs into its rear end.", [("brake", None)]),
        ("Ego brakes hard; the car behind hits it.", [("brake", 6.0)]),
    ],
)
def test_brakes_with_nobody_ahead(read, text: str, phases: list) -> None:
    assert [(p.action, p.rate) for p in read(text)["E"].spec.phases] == phases
