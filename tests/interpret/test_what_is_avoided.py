"""What is avoided and how; persons ego brakes for; gaps; headings that the text retells; participles behind ego."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    ("text", "reaction", "done"),
    [
        ("The ego avoids a collision with a pedestrian by braking hard.", "brake", []),
        ("By swerving to the left the ego avoids hitting the cyclist.", "brake", ["swerve"]),
        ("The ego manages to avoid a crash with the bus by steering left.", "brake", ["swerve"]),
        ("The ego avoids hitting the van by changing to the left lane.", "none", ["lane_change"]),
    ],
)
def test_how_ego_avoids_somebody(read, text: str, reaction: str, done: list[str]) -> None:
    structure = read(text)
    assert (structure["E"].spec.reaction, actions(structure["E"])) == (reaction, done)
    assert len(structure.objects) == 1


@pytest.mark.parametrize(
    "text", ["Ego yields to a pedestrian.", "Ego brakes for a child.", "The ego stops for an old man."]
)
def test_a_person_for_whom_ego_brakes_crosses(read, text: str) -> None:
    assert actions(read(text).objects[0]) == ["cross_road"]


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("Conflict, turning round. A van at the right edge begins a U-turn in front of the ego.", "u_turn"),
        ("Undertaking motorcyclist. The ego drives in the left lane; a motorcyclist overtakes it.", "overtake"),
    ],
)
def test_a_heading_that_the_text_retells_of_another_is_not_egos(read, text: str, act: str) -> None:
    structure = read(text)
    assert act not in actions(structure["E"])
    assert act in actions(structure.objects[0])


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("A truck in front of ego braking, a car behind it.", "brake"),
        ("A car ahead of the ego reversing towards it.", "reverse"),
        ("A van behind the ego overtaking.", "overtake"),
    ],
)
def test_who_is_placed_by_ego_does_what_follows(read, text: str, act: str) -> None:
    assert act in actions(read(text).objects[0])


@pytest.mark.parametrize(
    "text",
    [
        "The pedestrian steps out, walks as far as the middle of the lane and then freezes there.",
        "A girl runs into the road and stops in the middle of it.",
        "A man walks into the road and halts in ego's lane.",
    ],
)
def test_who_stops_on_the_road(read, text: str) -> None:
    assert actions(read(text).objects[0]) == ["cross_road", "stop"]


def test_who_follows_without_an_object_follows_who_went_before(read) -> None:
    structure = read("A motorcycle overtakes the ego. The car in front moves off, ego follows.")
    follows = [p.target for p in structure["E"].spec.phases if p.action == "follow"]
    assert [structure[f].spec.type for f in follows] == ["car"]


@pytest.mark.parametrize(
    ("text", "lane"),
    [
        ("The ego follows a cement mixer in the right lane; a hatchback cuts in from the left lane.", "rightmost"),
        ("A car is stopped in the left lane, and the ego hits it from behind.", "leftmost"),
        ("Ego follows a truck in the left lane of the motorway.", "leftmost"),
    ],
)
def test_ego_is_in_the_lane_of_whom_it_follows_or_hits_from_behind(read, text: str, lane: str) -> None:
    structure = read(text)
    assert structure.place.spec.ego_lane == lane
    assert structure.objects[0].spec.placement.position == "ahead"


@pytest.mark.parametrize(
    "text",
    [
        "The ego pulls over to let an ambulance through.",
        "Ego pulls over and waits because a fire engine comes from behind.",
        "The ego moves aside to make room for a police car.",
    ],
)
def test_who_pulls_over_goes_right(read, text: str) -> None:
    first = read(text)["E"].spec.phases[0]
    assert (first.action, first.side) == ("lane_change", "right")


@pytest.mark.parametrize(
    "text",
    [
        "The car on the left fails to keep its lane.",
        "A van in the left lane does not stay in its lane.",
        "The truck in the left lane fails to keep to its lane.",
    ],
)
def test_who_does_not_keep_its_lane_drifts(read, text: str) -> None:
    assert actions(read(text).objects[0]) == ["drift"]
