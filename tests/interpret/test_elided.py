"""Verbs left out because they were just said, what is not heeded, and what another keeps ego from."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "A bus from the right had to give way to us but failed to.",
        "A pickup coming from the right was required to yield; it didn't.",
    ],
)
def test_who_should_give_way_and_does_not_goes_on(read, text: str) -> None:
    structure = read(text)
    assert structure.objects[0].spec.placement.position == "crossing_right"
    assert structure["E"].spec.reaction != "yield"


@pytest.mark.parametrize(
    "text",
    [
        "The driver of the SUV did not see the red light and struck the ego in the side.",
        "A taxi on the cross street fails to notice the red light and drives into the ego.",
        "The car from the left does not respect the traffic light.",
    ],
)
def test_who_does_not_heed_a_light_runs_it(read, text: str) -> None:
    assert "run_red" in actions(read(text).objects[0])


def test_who_sees_the_light_stops(read) -> None:
    assert actions(read("Ego sees the red light and stops.")["E"]) == ["stop"]


def test_who_is_kept_from_overtaking_stays_behind(read) -> None:
    structure = read("An oncoming bus keeps the ego from overtaking a slow tractor.")
    assert "overtake" not in actions(structure["E"])
    assert [o.spec.placement.position for o in structure.objects] == ["oncoming_lane", "ahead"]


@pytest.mark.parametrize(
    "text",
    [
        "The ego overtakes a tractor and merges back before an oncoming car arrives.",
        "Ego passes the bus and returns to its lane.",
        "Ego goes past a cyclist and moves back in.",
    ],
)
def test_going_back_in_ends_the_overtaking(read, text: str) -> None:
    assert actions(read(text)["E"]) == ["overtake"]
