"""Which lane one is in: by number, by the lane that ego goes to, beside ego, in a turning lane."""

import pytest


def at(read, text: str, one: str = "O1") -> tuple:
    place = read(text)[one].spec.placement
    return place.position, place.along


@pytest.mark.parametrize(
    ("text", "position", "ego"),
    [
        
        
        
        
        ("Ego drives in the second lane from the right; a van in the third lane changes to ego's lane.",
         "left_lane", "middle"),
    ],
)  # fmt: skip
def test_lanes_by_number(read, text: str, position: str, ego: str) -> None:
    s = read(text)
    assert s["O1"].spec.placement.position == position and s["R"].spec.ego_lane == ego
    assert {"cut_in", "overtake"} & {p.action for p in s["O1"].spec.phases}


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("Ego accelerates and merges in front of a truck doing 70 km/h.", ("left_lane", "behind")),
        ("Ego changes lanes to the right, ahead of a car that approaches from behind.", ("right_lane", "behind")),
        ("Ego slows down and moves to the left lane behind a bus.", ("left_lane", "ahead")),
        ("Ego overtakes a bus and returns to its lane in front of it.", ("ahead", None)),
    ],
)
def test_whom_ego_goes_before_or_behind(read, text: str, where: tuple) -> None:
    assert at(read, text) == where


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("A car drives level with ego in the left lane.", ("left_lane", "abreast")),
        ("A van drives beside ego in the right lane.", ("right_lane", "abreast")),
        ("A police car approaches ego from behind at high speed in the left lane.", ("left_lane", "behind")),
        ("A taxi overtakes ego in the left lane and cuts in.", ("left_lane", "behind")),
        ("There is a truck on ego's left. The car in front brakes.", ("left_lane", "abreast")),
        ("To the right of ego a coach drives at 80 km/h.", ("right_lane", "abreast")),
    ],
)
def test_beside_ego(read, text: str, where: tuple) -> None:
    assert at(read, text) == where


@pytest.mark.parametrize(
    ("text", "way"),
    [
        ("Ego is in the left-turn lane but goes straight on. A car from the right honks.", "straight"),
    ],
)
def test_turning_lanes(read, text: str, way: str) -> None:
    assert read(text)["R"].spec.manoeuvre == way


def test_another_in_a_turning_lane(read) -> None:
    assert read("A car waits in the right-turn lane next to ego.")["O1"].spec.placement.side == "right"
    s = read("A car in the right turn lane goes straight on and cuts off ego.")
    assert [p.action for p in s["O1"].spec.phases] == ["go_straight", "cut_in"] and not s["E"].spec.phases


@pytest.mark.parametrize(
    ("text", "where", "moves"),
    [
        ("The lane to the right is filled with slow traffic.", ("right_lane", "abreast"), True),
        ("The left lane is full of cars. A truck in front of ego brakes.", ("left_lane", "abreast"), True),
        ("The right lane is blocked by a stationary bus.", ("right_lane", "ahead"), False),
    ],
)
def test_a_lane_that_is_taken(read, text: str, where: tuple, moves: bool) -> None:
    assert at(read, text) == where and (read(text)["O1"].spec.speed > 0) is moves


@pytest.mark.parametrize(
    "text",
    [
        "Ego is in the left lane at 100 km/h when an ambulance nears from the rear in that lane at 130 km/h.",
        "Ego drives in the right lane. A van comes up from behind in the same lane.",
    ],
)
def test_behind_in_egos_lane(read, text: str) -> None:
    assert read(text)["O1"].spec.placement.position == "behind"


@pytest.mark.parametrize(
    "text",
    [
        "The scooter travels at 20 km/h close to the kerb in the same direction as ego.",
        "A cyclist rides near the right kerb at 15 km/h.",
        "A moped drives along the kerb ahead of ego.",
    ],
)
def test_along_the_kerb(read, text: str) -> None:
    spec = read(text)["O1"].spec
    assert (spec.placement.position, spec.placement.side) == ("partly_in_lane", "right") and spec.speed > 0


def test_catches_up(read) -> None:
    s = read("VUT at 72 km/h in the right-hand lane of two. The motorcyclist target catches up in the left-hand lane at"
             " 80 km/h from a point 30 m behind.")  # fmt: skip
    place = s["O1"].spec.placement
    assert (place.position, place.along, place.gap) == ("left_lane", "behind", 30.0)


@pytest.mark.parametrize(
    ("text", "ego"),
    [
        ("A car is stopped in the right lane. Ego drives in that very lane at 90 km/h.", "rightmost"),
        ("A truck is in the left lane and ego follows in the same lane.", "leftmost"),
        ("A ghost driver comes in the left lane of a motorway. The AV, in that same lane, brakes.", "leftmost"),
    ],
)
def test_the_lane_spoken_of(read, text: str, ego: str) -> None:
    s = read(text)
    assert s["R"].spec.ego_lane == ego and s["O1"].spec.placement.position == "ahead"


def test_across_both_lanes(read) -> None:
    s = read("Rural road, one lane each direction. A school bus coming the other way has stopped. Two children walk"
             " from the bus across both lanes. Ego waits.")  # fmt: skip
    children = s["O2"].spec
    assert children.count == 2 and children.placement.side == "left" and s["R"].spec.lanes == 1


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("On a three-lane motorway ego is in the right lane and a van in the middle lane 20 m behind.", "left_lane"),
        ("Ego drives in the left lane of three. A truck in the middle lane drifts to the left.", "right_lane"),
        ("Ego is in the right lane. A car in the middle lane 10 m ahead changes to the right.", "left_lane"),
    ],
)
def test_in_the_middle_lane(read, text: str, position: str) -> None:
    assert read(text)["O1"].spec.placement.position == position


def test_on_the_left_a_car(read) -> None:
    s = read("Ego drives at 110 km/h. On the left a car 10 m behind ego at 120 km/h.")
    place = s["O1"].spec.placement
    assert (place.position, place.along, place.gap) == ("left_lane", "behind", 10.0)


def test_the_side_that_one_leaves(read) -> None:
    s = read("A cyclist 20 m ahead of ego moves from the bike lane on the right into ego's lane.")
    assert s["O1"].spec.phases[0].side == "left"


def test_the_other_party_is_never_ego(read) -> None:
    s = read("The POV is 2 car lengths ahead in the adjacent left lane and drifts right.")
    assert s["O1"].spec.placement.position == "left_lane"
