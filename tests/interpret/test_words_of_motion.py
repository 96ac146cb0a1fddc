"""Nouns and verbs of motion in plain sentences: who does it, in which order, what triggers it."""

import pytest

from c2s_engine.structure.components import Structure


def acts(s: Structure, who: str) -> list[str]:
    return [p.action for p in s[who].spec.phases]


@pytest.mark.parametrize(
    ("text", "position", "expected"),
    [
        ("A left turn of an oncoming bus across the path of ego.", "opposite_approach", ["turn_left"]),
        ("The crossing of a pedestrian from left to right in front of ego.", "roadside", ["cross_road"]),
        ("A lane change by the neighbouring truck to the left, into the lane of ego.", "right_lane", ["cut_in"]),
        ("Lane change of the lead to the right.", "ahead", ["cut_out"]),
        ("The departure of the parked van from the kerb forces ego to swerve.", "parked", ["enter_road"]),
        ("Emergency braking by ego due to the sudden stop of a taxi.", "ahead", ["stop"]),
        ("The overtaking manoeuvre of a motorcycle on the left of ego.", "left_lane", ["overtake"]),
        ("The merging of a truck from the on-ramp ahead of ego.", "on_ramp", ["cut_in"]),
        ("Encroachment of an oncoming lorry into the lane of ego.", "oncoming_lane", ["oncoming"]),
        ("Loss of control of the car ahead on a wet road.", "ahead", ["lose_control"]),
        ("The exit of the lead vehicle from the lane reveals a stopped car.", "ahead", ["cut_out"]),
        ("The overtaking of ego by a sports car.", "behind", ["overtake"]),
        ("Ego responds to the cut-in with moderate braking.", "left_lane", ["cut_in"]),
        # verbs
        ("A woman runs across the road to catch a bus while ego comes.", "roadside", ["cross_road"]),
        ("A car drives out of the petrol station on the right and turns into ego's lane.", None, ["enter_road"]),
        ("A pedestrian turns round halfway across and goes back.", "roadside", ["cross_road"]),
        ("A car ahead of ego gradually slows until it stands still.", "ahead", ["stop", "wait"]),
        ("The driver behind fails to notice that ego has stopped.", "behind", []),
        (
            "V2, a motorcycle, was eastbound. V2's rider braked hard, and the motorcycle struck V1.",
            None,
            ["brake", "collide"],
        ),
        ("In his lane there was standing a cow. The driver swerved to the left.", "ahead", ["stationary"]),
    ],
)
def test_what_the_other_does(read, text: str, position: str | None, expected: list[str]) -> None:
    s = read(text)
    assert acts(s, "O1") == expected
    assert position in (None, s["O1"].spec.placement.position)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("An ambulance overtakes a standing ego.", ["stationary"]),
        ("The left turn of the lead vehicle is followed by a stop of ego.", ["stop"]),
        ("Ego's overtaking of a tractor.", ["overtake"]),
        ("A lane departure of ego is not acceptable.", []),
        ("Ego was first in line at a red light.", ["stationary"]),
        ("I grabbed the brakes and escaped into the left lane.", ["brake", "lane_change"]),
        ("The driver made a sharp manoeuvre to the left, in the lane for the contrary direction.", ["oncoming"]),
        ("Then it is ego's turn.", []),
        ("A safety driver sits in the ego vehicle.", []),
    ],
)
def test_what_ego_does(read, text: str, expected: list[str]) -> None:
    assert acts(read(text), "E") == expected


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("The pedestrian starts to cross only when ego is 20 m away.", "distance", 20),
        ("The stationary vehicle starts moving again as ego comes closer than 30 m.", "distance", 30),
        ("When ego is 18 m away, the dog decides to run onto the road.", "distance", 18),
    ],
)
def test_what_it_waits_for(read, text: str, kind: str, value: float) -> None:
    trigger = read(text)["O1"].spec.phases[0].trigger
    assert trigger is not None
    assert (trigger.kind, trigger.value) == (kind, value)


def test_a_distance_from_a_junction_is_one_to_it(read) -> None:
    s = read("The oncoming car begins its left turn when ego is 25 m away from the intersection.")
    assert s["R"].spec.kind == "intersection"
    assert read("Ego drives on a road away from any intersection.")["R"].spec.kind != "intersection"


@pytest.mark.parametrize(
    "text",
    [
        "The car behind ego changes into the left lane, overtakes and cuts in 10 m ahead.",
        "A sports car approaches from behind, changes to the left lane, passes ego and cuts in 5 m ahead of it.",
        "The vehicle behind moves to the left lane, passes ego and moves back to the right lane.",
    ],
)
def test_an_overtaking_is_one(read, text: str) -> None:
    s = read(text)
    assert s["O1"].spec.placement.position == "behind"
    assert s["O1"].spec.placement.gap is None
    assert acts(s, "O1") == ["overtake", "cut_in"]
    assert s["O1"].spec.phases[1].side == "right"
    assert s["R"].spec.ego_lane == "rightmost"


def test_debris_is_one_thing(read) -> None:
    assert read("There is debris in ego's lane.")["O1"].spec.count == 1


def test_who_opens_a_door_is_not_on_the_road(read) -> None:
    s = read("Someone opens the door of a parked car on the right, and ego swerves to the left.")
    assert [o.spec.type for o in s.objects] == ["car"]


@pytest.mark.parametrize(
    "text",
    [
        "Ego brakes for any pedestrian within 20 m. A truck is parked on the right. A child behind it runs onto the "
        "road.",
    ],
)
def test_whom_a_condition_foretells(read, text: str) -> None:
    s = read(text)
    assert len(s.objects) == 2
    assert acts(s, "O2") == ["cross_road"]
    assert s["O2"].spec.placement.hidden_by == "O1"
    assert s["O2"].spec.placement.gap is None


def test_others_than_the_foretold(read) -> None:
    s = read("Ego brakes when a cyclist crosses the road. A cyclist behind ego cannot stop.")
    assert [o.spec.placement.position for o in s.objects] == ["roadside", "behind"]


@pytest.mark.parametrize(
    ("text", "position", "expected"),
    [
        ("Ego does not react to the pedestrian.", "roadside", ["cross_road"]),
        ("Ego fails to yield to the pedestrian.", "roadside", ["cross_road"]),
    ],
)
def test_what_is_not_done(read, text: str, position: str | None, expected: list[str]) -> None:
    s = read(text)
    assert len(s.objects) == 1
    assert acts(s, "O1") == expected
    assert position in (None, s["O1"].spec.placement.position)
    assert s["E"].spec.reaction == "none"


def test_who_brakes_to_a_speed_was_faster(read) -> None:
    s = read("The lead car slows to 80 km/h.")
    assert s["O1"].spec.speed > 80 / 3.6
    assert s["E"].spec.speed > 80 / 3.6
    assert read("Ego had slowed to 60 km/h when a dog ran out.")["E"].spec.speed < 17


def test_a_snow_plough_is_no_snow(read) -> None:
    assert read("Ego follows a snow plough.")["G"].spec.weather == ()


@pytest.mark.parametrize(
    "text",
    [
        "A tractor with a trailer turns onto the road in front of ego.",
        "A pickup towing a caravan brakes ahead of ego.",
        "A truck with a wide load drives ahead of ego.",
    ],
)
def test_a_trailer_is_part_of_who_pulls_it(read, text: str) -> None:
    assert len(read(text).objects) == 1


def test_the_oncoming_one_is_who_came_the_other_way(read) -> None:
    s = read("A van overtakes ego although a car is coming the other way. The oncoming car escapes onto the shoulder.")
    assert [o.spec.type for o in s.objects] == ["van", "car"]
    assert acts(s, "O2") == ["leave_road"]


def test_in_front_of_whom_one_cuts_in(read) -> None:
    s = read("A truck ahead of ego brakes suddenly because a car has cut in in front of it.")
    assert s["O2"].spec.phases[0].target == "O1"
    s = read("Ego brakes because a car has cut in in front of it.")
    assert s["O1"].spec.phases[0].target == "ego"


def test_the_lane_that_is_named_first_is_egos(read) -> None:
    assert (
        read("Ego is driving in the middle lane with a van behind it in the left lane.")["R"].spec.ego_lane == "middle"
    )


@pytest.mark.parametrize(
    ("text", "position", "expected"),
    [
        ("The oncoming car leaves its lane and hits ego head-on.", "oncoming_lane", ["oncoming", "collide"]),
        ("A child gets off a bus and steps into the lane of ego.", None, ["cross_road"]),
    ],
)
def test_leaving_and_getting_off(read, text: str, position: str | None, expected: list[str]) -> None:
    s = read(text)
    assert acts(s, "O1") == expected
    assert position in (None, s["O1"].spec.placement.position)


@pytest.mark.parametrize(
    ("text", "who", "expected"),
    [
        ("Ego pulls out to overtake a cyclist but has to abort because of an oncoming car.", "E", ["swerve"]),
        ("Having overtaken ego, the motorcycle brakes sharply.", "O1", ["overtake", "brake"]),
        ("A scooter squeezed past ego on the right and braked in front of it.", "O1", ["overtake", "brake"]),
        ("Ego meant to turn right, waited and then turned.", "E", ["turn_right"]),
        ("As nothing was coming, ego went out into the other lane to pass a bus.", "E", ["oncoming", "overtake"]),
        ("Ego drives on a motorway and moves into the other lane.", "E", ["lane_change"]),
    ],
)
def test_what_is_begun(read, text: str, who: str, expected: list[str]) -> None:
    assert acts(read(text), who) == expected


@pytest.mark.parametrize(
    ("text", "many"),
    [
        ("Ego hit a truck. Two persons are injured.", 1),
        ("Residents have called for better lighting. A car hits ego.", 1),
        ("Two pedestrians were injured when ego ran into them.", 1),
    ],
)
def test_who_is_only_spoken_of(read, text: str, many: int) -> None:
    assert len(read(text).objects) == many


def test_the_course_of_the_road_is_no_side(read) -> None:
    s = read("The vehicle ran off the road in a bend to the left and collided with a tree.")
    assert s["E"].spec.phases[0].side != "left"
