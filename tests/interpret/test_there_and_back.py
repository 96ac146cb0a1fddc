"""Who leaves his lane and comes back: both ways are told, or the whole is one overtaking; lights that change."""

import pytest


def sides(component) -> list[tuple[str, str | None]]:
    return [(p.action, p.side) for p in component.spec.phases]


BACK = [
    "and returns to the right lane",
    "and later moves back to the right lane",
]


@pytest.mark.parametrize("back", BACK)
def test_ego_changes_lanes_and_back(read, back: str) -> None:
    s = read(f"Ego changes to the left lane {back}.")
    assert sides(s.ego) == [("lane_change", "left"), ("lane_change", "right")]
    assert (s.place.spec.lanes, s.place.spec.ego_lane) == (2, "rightmost")


@pytest.mark.parametrize("back", BACK)
def test_another_changes_lanes_and_back(read, back: str) -> None:
    s = read(f"A car ahead of ego changes to the left lane {back}.")
    assert sides(s["O1"]) == [("cut_out", "left"), ("cut_in", "right")]


@pytest.mark.parametrize(
    "text",
    [
        "Ego changes to the left lane to pass a parked van and returns to the right lane.",
        "Ego changes to the left lane, passes a parked van and returns to the right lane.",
    ],
)
def test_past_one_that_is_parked(read, text: str) -> None:
    assert sides(read(text).ego) == [("lane_change", "left"), ("lane_change", "right")]


@pytest.mark.parametrize(
    "text",
    [
        "Ego moves to the left lane, overtakes a truck and moves back to the right lane.",
    ],
)
def test_an_overtaking_that_is_complete(read, text: str) -> None:
    s = read(text)
    assert [p.action for p in s.ego.spec.phases] == ["overtake"] and s.ego.spec.reaction == "none"


@pytest.mark.parametrize("back", ["It then returns to the left lane"])
def test_who_drifts_and_comes_back(read, back: str) -> None:
    s = read(f"A car in the left lane drifts towards ego. {back}.")
    assert [p.action for p in s["O1"].spec.phases] == ["drift", "lane_change"]
    assert s["O1"].spec.phases[-1].side == "left"


@pytest.mark.parametrize(
    ("text", "state"),
    [
        ("The traffic light turns from green to red. Ego stops.", "red"),
        ("Ego approaches a traffic light that changes from red to green.", "green"),
        ("The light switches from green to amber as ego approaches the junction.", "yellow"),
    ],
)
def test_a_light_that_changes(read, text: str, state: str) -> None:
    s = read(text)
    assert s.settings.spec.light == state
    assert not [p for p in s.ego.spec.phases if p.action.startswith("turn")]


def test_a_trigger_outlives_the_merging_of_phases(read) -> None:
    s = read("A car ahead of ego changes to the left lane. A few seconds later it comes back in front of ego.")
    assert s["O1"].spec.phases
