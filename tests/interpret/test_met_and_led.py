"""Who meets ego, whom ego gives way to, who is driven behind together, and whose view is blocked."""

import pytest


@pytest.mark.parametrize(
    "text", ["Ego and a truck meet on a narrow road.", "A truck and ego meet at a narrow bridge. Ego waits."]
)
def test_who_meets_ego_comes_the_other_way(read, text: str) -> None:
    assert read(text)["O1"].spec.placement.position == "oncoming_lane"


def test_who_meets_ego_at_a_junction_comes_from_where_it_says(read) -> None:
    s = read("Ego and a cyclist meet at a crossroads, the cyclist coming from the right.")
    assert s["O1"].spec.placement.position == "crossing_right"


def test_nobody_gives_way_to_the_parked(read) -> None:
    s = read(
        "Ego and a truck meet on a narrow road with parked cars on ego's side. Ego gives way behind the parked cars."
    )
    assert (s.ego.spec.reaction, s[s.ego.spec.react_to].spec.type) == ("yield", "truck")


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Ego is driving behind a bus and a taxi.", ["bus", "car"]),
        ("Ego follows a van and a truck.", ["van", "truck"]),
    ],
)
def test_those_ahead_of_ego_are_both_there(read, text: str, types: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == types


def test_whose_view_is_blocked(read) -> None:
    s = read("A truck blocks the view of ego to the crossing pedestrian.")
    assert s["O2"].spec.placement.hidden_by == "O1"


@pytest.mark.parametrize(
    ("text", "crosswalk"),
    [
        ("One pedestrian crossing 30 m ahead from the right, a parked truck on the right of ego.", None),
        ("There is a pedestrian crossing 30 m ahead, where a woman walks over.", True),
    ],
)
def test_a_pedestrian_who_crosses_is_no_crosswalk(read, text: str, crosswalk: bool | None) -> None:
    assert read(text).place.spec.crosswalk is crosswalk
