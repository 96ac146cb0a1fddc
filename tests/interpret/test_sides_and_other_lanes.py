"""Which lane, edge or side of the road is meant: the other lane, the edge of ego's side, the sides by the compass."""

import pytest


def position(structure, i: int = 0) -> tuple[str, str | None]:
    placement = structure.objects[i].spec.placement
    return placement.position, placement.side


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("On a two-lane country road a bus comes in the other lane.", "oncoming_lane"),
        ("A lorry comes toward ego in the other lane.", "oncoming_lane"),
    ],
)
def test_the_other_lane_of_two_in_one_direction_is_the_next_one(read, text: str, where: str) -> None:
    assert position(read(text))[0] == where


@pytest.mark.parametrize(
    "text",
    [
        "A cyclist rides towards ego along the right kerb.",
        "A girl on a bike comes the wrong way along the right edge of the road.",
        "A wrong-way cyclist on the shoulder comes towards ego.",
        "Riding against the traffic, a cyclist approaches ego on the right side of the road.",
    ],
)
def test_cyclists_against_the_traffic_keep_to_their_edge(read, text: str) -> None:
    structure = read(text)
    placement = structure.objects[0].spec.placement
    assert (placement.position, placement.side, placement.facing) == ("partly_in_lane", "right", "against")
    assert structure["R"].spec.oncoming is None


def test_an_oncoming_cyclist_of_whom_no_edge_is_told_is_in_the_oncoming_lane(read) -> None:
    assert position(read("A cyclist comes towards ego."))[0] == "oncoming_lane"
    assert position(read("A cyclist comes the other way."))[0] == "oncoming_lane"


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("Ego heads south; a man stands on the northbound side of the street and walks across.", "left"),
        ("Ego drives north. A dog on the southbound side of the road runs across.", "left"),
        ("V1 was northbound. A deer on the east shoulder ran into the road.", "right"),
        ("V1 was traveling west. A pedestrian stepped off the south curb and was struck by V1.", "left"),
        ("Ego drives east. A van is parked on the north side of the street.", "left"),
        ("Ego drives east. A van is parked on the south side of the street.", "right"),
    ],
)
def test_sides_of_the_road_by_the_compass(read, text: str, side: str) -> None:
    assert position(read(text))[1] == side


def test_a_side_road_to_the_north_is_where_one_comes_from(read) -> None:
    text = "A car in the side road to the north pulls out in front of ego, which is heading {}."
    assert position(read(text.format("west")))[0] == "crossing_right"
    assert position(read(text.format("east")))[0] == "crossing_left"


@pytest.mark.parametrize(
    ("text", "where", "along"),
    [
        ("A van is diagonally behind ego on the right.", "right_lane", "behind"),
        ("A motorcycle drives behind ego on the left.", "left_lane", "behind"),
        ("A truck is behind ego.", "behind", None),
    ],
)
def test_behind_on_one_side_is_the_lane_there(read, text: str, where: str, along: str | None) -> None:
    placement = read(text).objects[0].spec.placement
    assert placement.position == where
    assert along is None or placement.along == along


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("Ego drives in the middle lane; a coach undertakes it.", "right_lane"),
        ("A motorcycle undertakes ego and pulls in front.", "right_lane"),
        ("Ego drives in the middle lane; a coach overtakes it.", "left_lane"),
    ],
)
def test_who_undertakes_passes_on_the_right(read, text: str, where: str) -> None:
    assert position(read(text))[0] == where


def test_who_does_not_reach_into_the_lane_is_beside_it(read) -> None:
    assert position(read("A van is parked on the verge and does not project into the road."))[0] == "parked"


@pytest.mark.parametrize(
    "text",
    [
        "Ego comes to a stationary queue in the lane to its right.",
        "A standing queue is in the lane to ego's right.",
    ],
)
def test_queues_in_the_lane_to_one_side(read, text: str) -> None:
    assert position(read(text))[0] == "right_lane"


def test_two_lanes_beside_ego_make_three(read) -> None:
    assert read("A motorcycle is riding two lanes to the left of ego.")["R"].spec.lanes == 3
    assert read("A motorcycle is riding one lane to the left of ego.")["R"].spec.lanes == 2
