"""Accounts of riders and walkers, and what in a report is no part of the scene (police, queues that back up)."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "I'm in the bike lane doing maybe 25 km/h. A white van comes by me on the left and turns right across it.",
        "I cycle to school along Church Road. A van overtook me and pulled in right in front of me.",
        "I was riding in the cycle lane when a van passed me and turned right across my path.",
    ],
)
def test_a_cyclist_tells_it(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.type == "van" and s["O1"].spec.type == "bicycle"
    assert s.ego.spec.phases[0].action == "overtake" and s.ego.spec.phases[0].target == "O1"


@pytest.mark.parametrize(
    "text",
    [
        "I had the walk signal and started crossing Main Street. A pickup turning left knocked me down.",
        "I'm walking along the shoulder when a pickup drifts over and hits me.",
        "I was in the crosswalk when a pickup ran the red light and hit me.",
    ],
)
def test_somebody_on_foot_tells_it(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.type == "truck" and s["O1"].spec.type == "pedestrian"
    assert s.ego.spec.phases[-1].target == "O1"


@pytest.mark.parametrize(
    "text",
    [
        "V1 ran off the road to the left. Deputies said speed was a factor.",
        "The van left the road to the left. Officers were told by the driver that he fell asleep.",
    ],
)
def test_police_that_only_hear_of_it(read, text: str) -> None:
    s = read(text)
    assert not any(o.spec.type in ("police_car", "pedestrian") for o in s.objects)
    assert s.ego.spec.phases[0].action == "leave_road"


def test_a_number_said_twice(read) -> None:
    s = read("V1 was going 72 km/h (45 mph) when it hit V2. The posted speed limit was 89 km/h (55 mph).")
    assert s.ego.spec.speed == 20.0 and s.place.spec.speed_limit == 24.72


@pytest.mark.parametrize(
    "text",
    [
        "Traffic ahead was backing up from an exit. V2 stopped and V1 ran into its rear.",
        "Traffic was backed up from the exit. V2 stopped and V1 ran into its rear.",
        "V1 followed V2. Traffic backed up and V2 stopped. V1 ran into its rear.",
    ],
)
def test_traffic_that_backs_up_does_not_reverse(read, text: str) -> None:
    s = read(text)
    assert all(p.action != "reverse" for c in (s.ego, *s.objects) for p in c.spec.phases)


def test_over_the_line_at_the_edge(read) -> None:
    s = read("V1 went over the fog line and struck a mailbox. An ice pack was given. The sky was clear.")
    assert [p.action for p in s.ego.spec.phases] == ["leave_road", "collide"]
    assert s.settings.spec.weather == ("clear",)


def test_a_driver_who_runs_off_the_road_stays_inside(read) -> None:
    s = read("Our driver brakes hard and runs out onto the right shoulder.")
    assert not s.objects and s.ego.spec.phases[-1].action == "leave_road"


def test_after_some_way_is_no_order(read) -> None:
    s = read("V1 departed the road on the right, and after some 20 meters it struck a pole.")
    assert [p.action for p in s.ego.spec.phases] == ["leave_road", "collide"]


def test_between_the_lanes(read) -> None:
    s = read("The AV was stopped in the left lane when a motorcycle lane-splitting beside it clipped its right mirror.")
    assert s["O1"].spec.type == "motorcycle" and {p.action for p in s["O1"].spec.phases} == {"overtake", "collide"}
    assert all(p.action != "collide" for p in s.ego.spec.phases)
