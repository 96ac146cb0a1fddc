"""What one waits for that another does, and where who is hit by a change of lanes stands."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    ("text", "who", "of", "action"),
    [
        ("When the lead vehicle brakes, the car behind ego changes to the left lane.", "O2", "O1", "brake"),
        ("A van in the left lane cuts in when the truck ahead of ego brakes.", "O1", "O2", "brake"),
        ("As ego enters the intersection an oncoming truck turns left in front of it.", "O1", "ego", "go_straight"),
        ("When ego turns left, the oncoming car accelerates.", "O1", "ego", "turn_left"),
    ],
)
def test_a_phase_waits_for_what_another_does(read, text: str, who: str, of: str, action: str) -> None:
    trigger = next(p.trigger for p in read(text)[who].spec.phases if p.trigger is not None)
    assert (trigger.kind, trigger.of, trigger.action) == ("action", of, action)


@pytest.mark.parametrize(
    "text",
    [
        "The adult starts to walk from the left kerb when ego is 35 m from the crossing.",
        "A boy runs onto the zebra crossing when the ego is 35 m from the crosswalk.",
        "Once ego is 35 m away from the crosswalk, a woman crosses from the right.",
    ],
)
def test_a_person_at_the_crossing_watches_egos_distance(read, text: str) -> None:
    phase = read(text).objects[0].spec.phases[0]
    assert (phase.action, phase.trigger.kind, phase.trigger.value) == ("cross_road", "distance", 35.0)


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("Ego changes to the left lane and hits a van.", "left_lane"),
        ("V1 drifted to the right and struck a truck.", "right_lane"),
        ("V1 changed lanes to the left and sideswiped V2.", "left_lane"),
    ],
)
def test_whom_ego_hits_while_it_changes_lanes_is_beside_it(read, text: str, position: str) -> None:
    structure = read(text)
    assert structure.objects[0].spec.placement.position == position
    assert actions(structure["E"])[-1] == "collide"


@pytest.mark.parametrize(
    ("text", "action"),
    [
        ("As the ego is overtaking, the car being overtaken accelerates.", "accelerate"),
        ("A car going straight collides with the left-turning ego.", "collide"),
        ("A vehicle in the opposite lane blinds ego with high beams and drifts across the center line.", "oncoming"),
    ],
)
def test_the_verb_behind_a_long_subject_is_its_own(read, text: str, action: str) -> None:
    assert action in actions(read(text).objects[0])
