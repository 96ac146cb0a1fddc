"""Closed lanes, what lies in a lane that is named, signs that people hold, lights of others, weather that is over."""

import pytest


@pytest.mark.parametrize(
    ("text", "kind", "position", "ego"),
    [
        ("The left lane is closed due to construction. Ego drives in the right lane.", "construction_zone",
         "left_lane", "rightmost"),
        ("The right lane is coned off ahead. Ego merges left.", "cone", "ahead", "rightmost"),
        ("Roadworks close the right lane 200 m ahead; ego is in the right lane.", "construction_zone",
         "ahead", "rightmost"),
        
    ],
)  # fmt: skip
def test_closed_lanes(read, text: str, kind: str, position: str, ego: str) -> None:
    s = read(text)
    zone = next(o.spec for o in s.objects if o.spec.type == kind)
    assert zone.placement.position == position and s["R"].spec.ego_lane == ego


@pytest.mark.parametrize(
    ("text", "position", "ego"),
    [
        ("A tyre tread is on the left lane of the freeway, where ego drives at 65 mph.", "ahead", "leftmost"),
        ("A vehicle merges from the on-ramp into the right lane, where ego is driving.", "on_ramp", "rightmost"),
        ("A fallen tree blocks the right lane. Ego has to stop.", "ahead", "rightmost"),
        ("A stalled car blocks the left lane; ego is in the right lane and slows down.", "left_lane", "rightmost"),
    ],
)
def test_the_lane_where_ego_drives(read, text: str, position: str, ego: str) -> None:
    s = read(text)
    assert (s["O1"].spec.placement.position, s["R"].spec.ego_lane) == (position, ego)


@pytest.mark.parametrize(
    "text",
    [
        "A worker with a stop sign stands in front of the roadworks. Ego stops.",
        "A flagger holding a stop/slow paddle stands at the beginning of the works. Ego brakes.",
        "A policeman holds up a stop sign and ego halts.",
    ],
)
def test_a_stop_sign_in_the_hand(read, text: str) -> None:
    assert read(text)["R"].spec.control is None


def test_a_stop_sign_of_the_junction(read) -> None:
    assert read("Ego reaches a junction with a stop sign. A car comes from the left.")["R"].spec.control == "stop"


def test_whose_light_it_is(read) -> None:
    assert read("The light for ego is red, so it stops behind a van.")["G"].spec.light == "red"
    assert read("The pedestrian light is red but a man crosses anyway. Ego brakes.")["G"].spec.light is None
    assert read("The pedestrian signal turned green and a woman walks. Ego turns right.")["G"].spec.light is None


@pytest.mark.parametrize(
    "text",
    [
        "It has just stopped raining and the road is still wet. Ego follows a car.",
        "Ego follows a bus on a wet road; it is not raining.",
        "It is no longer raining but the asphalt is wet. A car brakes in front of ego.",
    ],
)
def test_rain_that_is_over(read, text: str) -> None:
    assert read(text)["G"].spec.weather == ("wet",)


@pytest.mark.parametrize(
    "text",
    [
        "The other car has a yield sign but pulls out in front of ego.",
        "At the junction a van ignores its give-way sign and pulls out in front of ego.",
        "At a crossroads a truck edges out in front of ego.",
    ],
)
def test_out_of_the_minor_road(read, text: str) -> None:
    assert read(text)["O1"].spec.placement.position.startswith("crossing")


def test_a_construction_vehicle_is_a_truck(read) -> None:
    s = read("A construction vehicle with flashing lights drives at 10 km/h in ego's lane.")
    assert [o.spec.type for o in s.objects] == ["truck"]
