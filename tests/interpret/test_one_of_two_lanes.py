"""Where two lanes are told of and others are in both, ego is in one of them."""

import pytest


@pytest.mark.parametrize(
    ("text", "lane", "positions"),
    [
        (
            "Two lanes per direction. A crate lies in the right lane. A van drives beside ego in the left lane.",
            "rightmost",
            ["ahead", "left_lane"],
        ),
        (
            "Two lanes in each direction. A van is in the left lane and a truck in the right lane ahead of ego.",
            "rightmost",
            ["left_lane", "ahead"],
        ),
        (
            "Two-lane motorway. An ambulance comes up from behind in the left lane. Ego changes to the right lane.",
            "leftmost",
            ["behind"],
        ),
    ],
)
def test_ego_is_in_one_of_two_lanes(read, text: str, lane: str, positions: list[str]) -> None:
    structure = read(text)
    road = structure["R"].spec
    assert (road.lanes, road.ego_lane) == (2, lane)
    assert [o.spec.placement.position for o in structure.objects] == positions


def test_ego_is_between_two_lanes_of_more(read) -> None:
    road = read("A road with three lanes. A box lies in the right lane. A car is in the left lane beside ego.")[
        "R"
    ].spec
    assert (road.lanes, road.ego_lane) == (3, "middle")
