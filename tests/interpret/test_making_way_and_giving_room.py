"""Pulling over, giving room, dropping in behind, coming back onto the road; who does what after a comma."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "Two cars ahead pull to the side and wait.",
        "A car ahead pulls over to the right shoulder and stops.",
    ],
)
def test_who_pulls_over_to_the_side_leaves_the_road_and_stops(read, text: str) -> None:
    first = read(text).objects[0]
    assert actions(first) == ["leave_road", "stop"]
    assert first.spec.phases[0].side == "right"


def test_room_behind_is_no_going_around(read) -> None:
    assert read("Ego keeps plenty of space behind the truck.")["E"].spec.reaction != "evade"


@pytest.mark.parametrize("verb", ["tucks in", "drops in", "slots in", "zips in"])
def test_who_drops_in_behind_ego_follows_it(read, verb: str) -> None:
    first = read(f"A van {verb} behind ego.").objects[0]
    assert first.spec.placement.position == "behind"
    assert actions(first) == ["follow"]


@pytest.mark.parametrize(
    "text",
    [
        "A lorry on the hard shoulder rejoins the carriageway in front of ego.",
        "A car on the shoulder rejoins lane 1 ahead of ego.",
        "A van in the emergency lane moves off in front of ego.",
    ],
)
def test_who_comes_back_from_the_shoulder_enters_the_road(read, text: str) -> None:
    assert actions(read(text).objects[0]) == ["enter_road"]


@pytest.mark.parametrize(
    "text",
    [
        "The van stops, ego behind it cannot brake in time.",
    ],
)
def test_what_a_comma_joins_has_its_own_subject(read, text: str) -> None:
    structure = read(text)
    assert actions(structure["E"]) == ["collide"]
    assert "collide" not in actions(structure.objects[0])


def test_who_has_gone_by_is_not_the_one_that_is_passed(read) -> None:
    structure = read("Ego follows a tractor. Once an oncoming bus has passed, ego overtakes it.")
    assert structure["E"].spec.phases[-1].target == "O1"
    waits = read("Ego waits behind a broken-down van until an oncoming car has gone by, then overtakes it.")
    assert waits["E"].spec.phases[-1].target == "O1"
    assert waits["E"].spec.react_to == "O2"


def test_a_side_of_the_passing_is_not_that_of_who_crosses(read) -> None:
    structure = read("V1 passed a stopped bus on the left and struck a child crossing from in front of the bus.")
    assert structure.objects[1].spec.placement.side == "right"


def test_one_steps_off_an_island(read) -> None:
    first = read("A pedestrian stands on the refuge island and steps off as ego approaches.").objects[0]
    assert actions(first) == ["cross_road"]
    assert first.spec.placement.side == "left"


def test_who_halts_at_a_stop_starts_ahead(read) -> None:
    bus = read("The bus ahead stops at the bus stop.").objects[0]
    assert bus.spec.placement.position == "ahead"
    assert actions(bus) == ["stop"]


def test_a_closed_footway_comes_no_nearer(read) -> None:
    user = read("A wheelchair user goes along the edge of the road ahead of ego, because the footway is closed.")
    assert user.objects[0].spec.placement.position != "sidewalk"


def test_the_lane_of_whom_one_cuts_off_is_egos(read) -> None:
    structure = read("A tanker from the inner lane cuts off ego in the outer lane of the roundabout.")
    assert structure["R"].spec.ego_lane == "rightmost"
    assert structure.objects[0].spec.placement.position == "left_lane"


def test_who_turns_off_into_a_yard_turns(read) -> None:
    bus = read("Ego follows a bus, which turns off into a depot on the left.").objects[0]
    assert actions(bus) == ["turn_left"]
