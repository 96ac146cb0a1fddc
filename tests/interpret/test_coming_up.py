"""Those who come up beside ego, go round, cut across to an exit; going back to one's own side."""

import pytest


def first(read, text: str):
    return read(text).objects[0].spec


@pytest.mark.parametrize(
    "text",
    [
        "A cyclist comes up on our right while we turn right, we hold and let him go straight over.",
        "Ego turns right at the junction, a push-bike comes up on its right and goes straight on.",
    ],
)
def test_a_cyclist_comes_up_on_the_side_to_which_ego_turns(read, text: str) -> None:
    spec = first(read, text)
    assert (spec.placement.along, spec.placement.side) == ("behind", "right")
    assert "overtake" in [p.action for p in spec.phases]


def test_a_cyclist_who_goes_round_already_comes_from_the_left(read) -> None:
    spec = first(read, "A cyclist is already on the roundabout, ego yields and enters after him.")
    assert spec.placement.position == "crossing_left"


@pytest.mark.parametrize(
    "text",
    [
        "A clown in the second lane dived across our nose and down the off-ramp. We were in the slow lane.",
    ],
)
def test_who_cuts_across_to_the_exit_leaves(read, text: str) -> None:
    assert [p.action for p in first(read, text).phases] == ["cut_in", "leave_road"]


def test_who_is_passed_on_the_right_of_the_left_lane(read) -> None:
    s = read("On the motorway ego is in the left lane and passes a coach on the right, then goes back to the right.")
    assert s.objects[0].spec.placement.position == "right_lane"
    assert [p.action for p in s["E"].spec.phases] == ["overtake", "lane_change"]


def test_one_who_comes_against_ego_drives_the_wrong_way(read) -> None:
    spec = first(read, "On the motorway ego drives in the left lane. In the left lane comes a car against us.")
    assert spec.placement.facing == "against" and not spec.phases


def test_a_rider_alongside_one_who_turns_right_is_at_the_edge_of_its_lane(read) -> None:
    s = read("Ego turns right at traffic lights. A cyclist riding alongside goes straight on and hits the car.")
    place = s.objects[0].spec.placement
    assert (place.position, place.side) == ("partly_in_lane", "right")
