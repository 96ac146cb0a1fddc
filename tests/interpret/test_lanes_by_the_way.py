"""Lanes that are told by the way: of whom ego passes, of what it gets round, of traffic; sides told by an indicator."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "The ego is in the left lane, passing a truck in the right lane.",
        "I was in the left lane of the motorway, passing a camper van.",
        "Ego is out in the left lane of a dual carriageway, about to pass a van in the right lane.",
    ],
)
def test_passed_from_the_left_lane(read, text: str) -> None:
    s = read(text)
    assert (s.place.spec.ego_lane, s.objects[0].spec.placement.position) == ("leftmost", "right_lane")


@pytest.mark.parametrize(
    "text",
    [
        "A van has broken down in the right lane. The ego moves to the left lane to get past.",
        "A coach had broken down in the right-hand lane. I saw it late and moved over to the left lane.",
    ],
)
def test_what_ego_gets_round_is_in_its_lane(read, text: str) -> None:
    s = read(text)
    assert (s.place.spec.ego_lane, s.objects[0].spec.placement.position) == ("rightmost", "ahead")


def test_no_traffic_in_a_lane(read) -> None:
    s = read("There is no traffic in the left lane. The ego overtakes a truck.")
    assert [o.spec.type for o in s.objects] == ["truck"]


@pytest.mark.parametrize(
    ("text", "turn"),
    [
        ("V1, with its right turn signal on, turned into Oak Street.", "turn_right"),
        ("The ego, signalling left, turns into a side street.", "turn_left"),
    ],
)
def test_the_side_of_the_indicator(read, text: str, turn: str) -> None:
    assert [p.action for p in read(text).ego.spec.phases][-1] == turn


@pytest.mark.parametrize(
    "text",
    [
        "The ego lets a cyclist pass before it turns right.",
        "The ego allows a van and a bus from the left to pass before it turns right.",
    ],
)
def test_who_lets_others_pass_turns(read, text: str) -> None:
    s = read(text)
    assert [p.action for p in s.ego.spec.phases] == ["turn_right"]
    assert not any(p.action == "turn_right" for o in s.objects for p in o.spec.phases)


@pytest.mark.parametrize(
    "text",
    [
        "A car that was following the ego changes to the left lane and overtakes it.",
        "The car that was behind the ego in the same lane changes to the left lane and goes past.",
        "A car follows the ego, pulls out to the left and passes it.",
    ],
)
def test_who_follows_starts_behind(read, text: str) -> None:
    assert read(text).objects[0].spec.placement.position == "behind"


@pytest.mark.parametrize(
    "text", ["The ego trails a truck by 25 m in the same lane.", "The ego follows the truck by 25 m."]
)
def test_followed_by_metres(read, text: str) -> None:
    assert read(text).objects[0].spec.placement.gap == 25.0


def test_behind_somebody_unknown_is_not_behind_ego(read) -> None:
    s = read("A truck was parked in the right lane behind the crew. The ego hits it.")
    assert s.objects[0].spec.placement.position == "ahead"


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("I am employed as driver of a refuse truck. I turned right and hit a cyclist.", "truck"),
        ("I was at the wheel of a loaded tipper when a car pulled out.", "truck"),
        ("I was riding my Honda CB500 along the main road. A car pulled out.", "motorcycle"),
        ("V1, a 2019 Harley-Davidson touring motorcycle, was westbound.", "motorcycle"),
    ],
)
def test_what_the_writer_drives(read, text: str, kind: str) -> None:
    s = read(text)
    assert s.ego.spec.type == kind and len(s.objects) < 2


def test_a_dummy_bicycle_is_one_thing(read) -> None:
    s = read("The dummy bicycle comes up from behind on the right-hand side of the lorry. The lorry turns right.")
    assert [(o.spec.type, o.spec.placement.side) for o in s.objects] == [("bicycle", "right")]


@pytest.mark.parametrize(
    "text",
    [
        "The left lane is closed by cones. A truck is parked in the closed lane. V1 was in the left lane and hit it.",
        "V1 was in the right lane, which was closed off with cones. A truck was parked in the closed lane. V1 hit it.",
        "The lorry was parked in the closed inside lane. The ego hit the lorry.",
    ],
)
def test_parked_in_the_closed_lane(read, text: str) -> None:
    truck = next(o.spec for o in read(text).objects if o.spec.type == "truck")
    assert (truck.placement.position, truck.speed) == ("ahead", 0.0)


def test_in_the_closed_lane_beside(read) -> None:
    s = read("Cones close the left lane and a truck is parked in the closed lane. The ego drives in the right lane.")
    assert {o.spec.placement.position for o in s.objects} == {"left_lane"}


@pytest.mark.parametrize(
    "text",
    [
        "A car in the adjacent lane moves across the separating marking into the lane of the system car.",
        "With the system active, a passenger car in the adjacent lane moves into the lane of the system vehicle.",
        "A car in the next lane drifts over the solid marking and cuts in in front of the system car.",
    ],
)
def test_cut_in_over_a_marking(read, text: str) -> None:
    spec = read(text).objects[0].spec
    assert (spec.placement.position, spec.phases[-1].action) == ("left_lane", "cut_in")
