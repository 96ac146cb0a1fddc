"""Collisions told by nouns and participles: who hits whom, from where."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "Contact occurred between the front of the ego and the rear of the bus.",
        "A collision occurs between the ego and a bus.",
    ],
)
def test_a_collision_between_two(read, text: str) -> None:
    structure = read(text)
    assert (actions(structure["E"]), structure.objects[0].spec.type) == (["collide"], "bus")


@pytest.mark.parametrize(
    "text",
    [
        "V1 northbound. Lost control on ice. Hit V2 head-on.",
    ],
)
def test_who_is_met_head_on_comes_the_other_way(read, text: str) -> None:
    assert read(text).objects[0].spec.placement.position == "oncoming_lane"


@pytest.mark.parametrize(
    "text",
    [
        "The ego was hit by a van changing lanes.",
        "A car left its lane, sideswiped the ego and drove on.",
        "A lorry switching lanes hits the ego.",
    ],
)
def test_who_hits_ego_while_it_changes_lanes_was_beside_it(read, text: str) -> None:
    spec = read(text).objects[0].spec
    assert (spec.placement.position, [p.action for p in spec.phases]) == ("left_lane", ["cut_in", "collide"])


@pytest.mark.parametrize(
    "text",
    [
        "The ego is hit by a car turning left from the opposite direction.",
        "Ego collides with a car turning left across its path from the opposite direction.",
        "An oncoming car turning left in front of the ego is struck by it.",
    ],
)
def test_what_a_participle_tells_comes_before_the_blow(read, text: str) -> None:
    assert actions(read(text).objects[0])[0] == "turn_left"


@pytest.mark.parametrize(
    "text",
    [
        "The ego car is cut off by a pickup from the right.",
        "A van cuts in from the right.",
        "A taxi cuts me off from the right and brakes.",
    ],
)
def test_who_cuts_in_from_a_side_comes_out_of_that_lane(read, text: str) -> None:
    assert read(text).objects[0].spec.placement.position == "right_lane"


@pytest.mark.parametrize(
    "text",
    [
        "Ego follows a motorcycle which falls over on the slippery road.",
        "A cyclist falls in front of the ego.",
        "A moped rider ahead of the ego comes off his bike.",
    ],
)
def test_a_rider_who_falls_loses_control_ahead(read, text: str) -> None:
    spec = read(text).objects[0].spec
    assert (spec.placement.position, [p.action for p in spec.phases]) == ("ahead", ["lose_control"])


@pytest.mark.parametrize(
    "text",
    [
        "An oncoming car overtakes and the ego must brake.",
        "A car travelling in the opposite direction attempts to overtake.",
        "A van comes the other way and is overtaking, so the ego pulls to the right.",
    ],
)
def test_who_overtakes_coming_towards_ego_is_in_its_lane(read, text: str) -> None:
    spec = read(text).objects[0].spec
    assert (spec.placement.position, spec.phases[0].action) == ("oncoming_lane", "oncoming")


@pytest.mark.parametrize(
    "text",
    [
        "A sudden deceleration of the lead vehicle forces the ego to brake.",
        "The stop of the car in front forces the ego to stop.",
        "The braking of the van ahead forces ego to slow down.",
    ],
)
def test_a_noun_of_motion_forces_ego(read, text: str) -> None:
    structure = read(text)
    assert len(structure.objects) == 1
    assert structure["E"].spec.reaction == "brake"
    assert actions(structure.objects[0])[0] in ("brake", "stop")


@pytest.mark.parametrize(
    "told",
    [
        "{x} rear-ended {y}.",
        "{y} was struck in the rear by {x}.",
        "{x}'s front contacted {y}'s rear.",
        "The front of {x} contacted the back plane of {y}.",
        "There was an impact between the front of {x} and the rear of {y}.",
        "{y} was hit in the rear by the front of {x}.",
        "{y} stopped and was hit from behind by {x}.",
        "A rear-end collision occurred when {x} struck {y}.",
    ],
)
def test_a_rear_end_collision_in_the_words_of_reports(read, told: str) -> None:
    """Who strikes is behind, whoever of the two is ego."""
    before = "V1 and V2, a van, were travelling in the same lane of a straight road. "
    s = read(before + told.format(x="V1", y="V2"))
    assert [(o.spec.type, o.spec.placement.position) for o in s.objects] == [("van", "ahead")]
    assert [p.target for p in s.ego.spec.phases if p.action == "collide"] == ["O1"]
    s = read(before + told.format(x="V2", y="V1"))
    assert [(o.spec.type, o.spec.placement.position) for o in s.objects] == [("van", "behind")]
    assert [p.target for p in s.objects[0].spec.phases if p.action == "collide"] == ["ego"]
