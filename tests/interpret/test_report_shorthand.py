"""The shorthand of reports: numbers and letters for the parties, headlines, near misses, causers."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "MV1 was stopped at a red light when MV2 struck it from behind.",
        "#1 was stopped. #2 hit #1 in the rear.",
        'Vehicle "A" was stopped; Vehicle "B" hit it from behind.',
        "AP1 stood at the lights. AP2 struck the rear of AP1.",
    ],
)
def test_the_second_hits_the_first(read, text: str) -> None:
    s = read(text)
    assert [(o.spec.placement.position, o.spec.phases[-1].target) for o in s.objects] == [("behind", "ego")]


def test_two_makes_are_two_cars(read) -> None:
    assert len(read("The Kia hit the Hyundai.").objects) == 1
    assert len(read("The van hit a Ford Focus. The Ford was parked.").objects) == 1


def test_who_runs_somebody_down_is_ego(read) -> None:
    s = read("A cyclist was knocked down by a van.")
    assert (s.ego.spec.type, s["O1"].spec.type) == ("van", "bicycle")


def test_a_near_miss_is_no_hit(read) -> None:
    s = read("A woman pushing a pram was nearly hit by a bus.")
    assert "collide" not in [p.action for p in s.ego.spec.phases]


def test_what_could_not_be_avoided_happens(read) -> None:
    s = read("I braked but could not avoid hitting the deer.")
    assert [p.action for p in s.ego.spec.phases] == ["collide"]


@pytest.mark.parametrize(
    ("text", "action"),
    [
        ("An oncoming car came round the bend on my side of the road and forced me onto the verge.", "oncoming"),
    ],
)
def test_causers(read, text: str, action: str) -> None:
    assert [p.action for p in read(text)["O1"].spec.phases] == [action]


@pytest.mark.parametrize(
    "text",
    [
        "A school bus was loading on the other side of the road ahead of the ego.",
        "A taxi ahead was picking up a passenger and the ego waited behind it.",
        "A delivery van ahead of the ego was unloading in the lane.",
    ],
)
def test_standing_to_load(read, text: str) -> None:
    assert [p.action for p in read(text)["O1"].spec.phases] == ["stationary"]


def test_lights_that_are_on_are_no_signals(read) -> None:
    s = read("An ambulance came up behind the ego with its lights on.")
    assert "run_red" not in [p.action for p in s["O1"].spec.phases]
