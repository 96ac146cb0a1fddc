"""Reports of crashes: whoever the parties are called, the same happens; what comes after the crash is no scene."""

import pytest

NAMES = {
    "unit": ("Unit 1", "Unit 1", "Unit 2", "Unit 2"),
    "driver": ("Driver 1", "Driver 1", "Driver 2", "Driver 2"),
    "typed": ("V1, a 2019 Toyota Camry driven by a 34-year-old man,", "V1", "V2, a 2014 Ford Focus,", "V2"),
    "av": ("The AV", "the AV", "a sedan", "the sedan"),
    "other": ("I", "my vehicle", "the other driver", "the other driver"),
}
CRASHES = {
    "turn": (
        "{A} was eastbound on Main Street. {B} was westbound on Main Street and turned left in front of {a}. "
        "The front of {a} struck the right side of {b}.",
        (["collide"], "opposite_approach", ["turn_left"]),
    ),
    "cross": (
        "{A} was traveling east on Main Street. {B} was traveling north on Oak Avenue. "
        "{b} ran the stop sign and {a} struck {b} in the left side.",
        (["collide"], "crossing_right", ["run_stop", "go_straight"]),
    ),
    "rear": (
        "{A} was stopped at a red light. {B} failed to stop in time and struck the rear of {a}.",
        (["stationary"], "behind", ["collide"]),
    ),
    "lane": (
        "{A} was eastbound in the right lane. {B} was eastbound in the left lane and changed lanes to the right. "
        "The right side of {b} struck the left side of {a}.",
        ([], "left_lane", ["cut_in", "collide"]),
    ),
    "line": (
        "{A} was traveling east on Route 9. {B} was traveling west, crossed the centerline and struck {a} head-on.",
        ([], "oncoming_lane", ["oncoming", "collide"]),
    ),
}
AFTERWARDS = [
    "Both drivers exited their vehicles and exchanged information.",
]


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


def crash(structure) -> tuple:
    """What ego does, where the only other one is, and what it does."""
    (other,) = structure.objects
    return (actions(structure["E"]), other.spec.placement.position, actions(other))


def told(text: str, names: tuple[str, ...]) -> str:
    filled = text.format(A=names[0], a=names[1], B=names[2], b=names[3])
    return ". ".join(part[:1].upper() + part[1:] for part in filled.split(". "))


@pytest.mark.parametrize("name", NAMES)
def test_whatever_the_parties_are_called(read, name: str) -> None:
    for kind, (text, expected) in CRASHES.items():
        assert crash(read(told(text, NAMES[name]))) == expected, kind


@pytest.mark.parametrize("after", AFTERWARDS)
def test_what_follows_the_crash_is_no_scene(read, after: str) -> None:
    for kind, (text, expected) in CRASHES.items():
        assert crash(read(told(f"{text} {after}", ("V1", "V1", "V2", "V2")))) == expected, kind


@pytest.mark.parametrize(
    "text",
    [
        "V1 was northbound. V2 was eastbound, ran a red light and hit V1. D2 was charged with running a red light.",
    ],
)
def test_a_charge_tells_what_was_run_before(read, text: str) -> None:
    assert crash(read(text)) == ([], "crossing_left", ["run_red", "collide"])


@pytest.mark.parametrize(
    "text",
    [
        "V2 struck V1 in the rear. V1 had come to rest at a red light.",
        "V2 struck V1 from behind when V1 came to rest at the light.",
    ],
)
def test_a_rest_before_the_crash_is_told(read, text: str) -> None:
    assert set(actions(read(text)["E"])) & {"stationary", "stop"}


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("V1, eastbound on Main, was struck by V2, which was northbound and ran the red light.", "crossing_right"),
        ("A northbound Honda was struck by an eastbound Ford that ran the red light.", "crossing_left"),
        ("V2, southbound on Elm, ran the red light and was hit by V1, eastbound on Main.", "crossing_left"),
        ("V1 was northbound on South Elm Street. V2, westbound on West Pine, ran the light.", "crossing_right"),
        (
            "V1 was eastbound. V2 came from a lot on the south side of Main and ran the stop sign.",
            "crossing_right",
        ),
    ],
)
def test_a_direction_is_that_of_whom_it_stands_beside(read, text: str, position: str) -> None:
    assert read(text).objects[0].spec.placement.position == position


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("V1 was traveling east. V2 pulled out of a driveway on the north side of the street. V1 struck V2.", "left"),
        ("V1 was traveling west. V2 came out of a driveway on the north side of the road. V1 struck V2.", "right"),
    ],
)
def test_a_drive_on_a_side_by_the_compass(read, text: str, side: str) -> None:
    assert read(text).objects[0].spec.placement.side == side


@pytest.mark.parametrize(
    "text",
    [
        "V1, eastbound, was struck by V2, which was northbound and ran the red light.",
        "V1 was struck by V2, which was going south and had run the red light.",
    ],
)
def test_what_the_striker_did_is_told_before_the_blow(read, text: str) -> None:
    assert actions(read(text).objects[0]) == ["run_red", "collide"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("V1 E/B on Main St. V2 N/B on Oak Ave, failed to stop at stop sign. V1 struck V2.", "crossing_right run_stop"),
        ("V1 EB Main at Oak. V2 SB Oak, ran red light, T-boned V1.", "crossing_left run_red"),
        ("V1 EB. V2 WB, turning left. V1 struck V2.", "opposite_approach turn_left"),
    ],
)
def test_notes_without_a_verb(read, text: str, expected: str) -> None:
    (other,) = read(text).objects
    assert f"{other.spec.placement.position} {actions(other)[0]}" == expected


@pytest.mark.parametrize(
    ("text", "acts", "side"),
    [
        ("V1 ran off the left side of the road and hit a tree.", ["leave_road", "collide"], "left"),
        ("V1 departed the right side of the roadway and struck a pole.", ["leave_road", "collide"], "right"),
        ("V1 went off the right edge of the road into a ditch.", ["leave_road"], "right"),
        (
            "V1 drifted off the right side of the road, overcorrected to the left and crossed the centerline.",
            ["leave_road", "swerve", "oncoming"],
            "right",
        ),
    ],
)
def test_who_leaves_a_side_of_the_road(read, text: str, acts: list[str], side: str) -> None:
    phases = read(text)["E"].spec.phases
    assert ([p.action for p in phases], phases[0].side) == (acts, side)


@pytest.mark.parametrize(
    ("text", "acts"),
    [
        ("V1 was turning right when it was rear-ended by V2.", ["turn_right"]),
        ("The AV was making a turn to the right when it was struck by a van.", ["turn_right"]),
        ("V1 was changing lanes to the right when it struck V2.", ["lane_change", "collide"]),
    ],
)
def test_right_before_when_is_a_side(read, text: str, acts: list[str]) -> None:
    phases = read(text)["E"].spec.phases
    assert [p.action for p in phases] == acts
    assert all(p.side != "left" for p in phases)


@pytest.mark.parametrize(
    "text",
    [
        "The AV was eastbound. A sedan pulled out of a driveway on the right into its path. The AV struck the sedan.",
        "A Tahoe was eastbound. An Altima pulled out of a driveway on the right. The front of the Tahoe struck it.",
        "V1 was eastbound. A car backed out of a driveway on the right into its path. V1 struck the car.",
    ],
)
def test_a_past_form_behind_a_new_one_tells(read, text: str) -> None:
    structure = read(text)
    spec = structure.objects[0].spec
    assert (actions(structure["E"]), spec.placement.position, spec.placement.side) == (["collide"], "roadside", "right")


@pytest.mark.parametrize(
    ("text", "acts"),
    [
        ("V2, westbound, failed to yield while turning left and was struck by V1, eastbound.", ["turn_left"]),
        ("V2 was westbound and failed to yield when turning left in front of V1, eastbound.", ["turn_left"]),
        ("V1, in the right lane, was sideswiped by V2, which was changing lanes.", ["cut_in", "collide"]),
        ("V1, eastbound, was struck by V2, which was westbound and turning left.", ["turn_left", "collide"]),
    ],
)
def test_what_goes_on_while_it_fails_or_hits(read, text: str, acts: list[str]) -> None:
    assert actions(read(text).objects[0]) == acts


@pytest.mark.parametrize(
    "text",
    [
        "The driver of V1 was eastbound when V2 took a left in front of him. He hit V2.",
    ],
)
def test_who_hits_somebody_is_another(read, text: str) -> None:
    assert crash(read(text)) == (["collide"], "opposite_approach", ["turn_left"])


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "V1 was eastbound and V2 was westbound. V2 crossed into the eastbound lanes and struck V1.",
            ([], "oncoming_lane", ["oncoming", "collide"]),
        ),
        (
            "V1 was eastbound. V2, westbound, drifted into the eastbound lane and hit V1.",
            ([], "oncoming_lane", ["oncoming", "collide"]),
        ),
    ],
)
def test_the_lanes_of_the_other_direction(read, text: str, expected: tuple) -> None:
    assert crash(read(text)) == expected


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("V1 was northbound. V2 was eastbound. The front of V1 struck the left side of V2.", "crossing_left"),
        ("V1 was traveling north and V2 was traveling west. V2's front contacted V1's right side.", "crossing_right"),
        ("V1 was going north on Elm. V2 was going east on Pine. They collided.", "crossing_left"),
    ],
)
def test_who_meets_ego_at_a_junction_by_the_compass(read, text: str, position: str) -> None:
    structure = read(text)
    assert structure.place.spec.kind == "intersection"
    assert structure.objects[0].spec.placement.position == position
    assert "run_red" not in actions(structure["E"])


@pytest.mark.parametrize(
    "text",
    [
        "V1 was eastbound when V2 turned left in front of it and struck V1.",
        "The AV was eastbound when a van turned left across its path and made contact with its left side.",
        "V1 was slowing for traffic when V2 turned left in front of it and hit V1's front.",
    ],
)
def test_what_the_other_then_did(read, text: str) -> None:
    assert actions(read(text).objects[0]) == ["turn_left", "collide"]


@pytest.mark.parametrize(
    "text",
    [
        "The driver in front of me braked suddenly and I ran into the back of him.",
        "A van ahead of me braked suddenly and I ran into it.",
    ],
)
def test_who_runs_into_another_is_not_on_foot(read, text: str) -> None:
    assert crash(read(text)) == (["collide"], "ahead", ["brake"])


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("V2, in the left lane, merged right into V1.", "left_lane"),
    ],
)
def test_who_changes_lanes_into_another(read, text: str, position: str) -> None:
    assert crash(read(text)) == ([], position, ["cut_in", "collide"])


@pytest.mark.parametrize(
    "text",
    [
        "V1 was behind V2 in lane one. V2 changed to lane two and V1 struck V3, which was stopped ahead.",
        "V1 was following V2. V2 moved into the left lane and V1 hit V3, which was stopped ahead of it.",
    ],
)
def test_a_new_subject_behind_a_place(read, text: str) -> None:
    structure = read(text)
    assert actions(structure["E"]) == ["follow", "collide"]
    assert "collide" not in actions(structure.objects[0])


@pytest.mark.parametrize(
    "text",
    [
        "O/V was southbound on Elm and ran the red light. My vehicle was eastbound. O/V hit me.",
        "I/V was eastbound. O/V was southbound and ran the red light and hit I/V.",
    ],
)
def test_letters_for_the_other_vehicle(read, text: str) -> None:
    assert crash(read(text)) == ([], "crossing_left", ["run_red", "collide"])


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("While attempting to overtake a tractor, a Golf collided with an oncoming van.", ["truck", "van"]),
        ("While overtaking a bus, a Fiat collided with an oncoming truck.", ["bus", "truck"]),
        ("While following a bus, a Fiat rear-ended it when it braked.", ["bus"]),
    ],
)
def test_who_passes_is_ego_not_who_is_passed(read, text: str, types: list[str]) -> None:
    structure = read(text)
    assert [o.spec.type for o in structure.objects] == types
    assert "collide" in actions(structure["E"])


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("V1 struck a parked van, V2.", "van"),
    ],
)
def test_a_label_between_commas(read, text: str, kind: str) -> None:
    structure = read(text)
    assert [o.spec.type for o in structure.objects] == [kind]
    assert "collide" in actions(structure["E"])


def test_who_turns_ahead_in_egos_direction_is_not_opposite(read) -> None:
    text = (
        "V2 was northbound and slowed to turn left. V1, northbound behind V2, tried to pass it and hit it as it turned."
    )
    structure = read(text)
    assert structure.objects[0].spec.placement.position == "ahead"


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("As it was turning left, V1 hit V2.", "turn_left"),
        ("As it was changing lanes to the left, the AV was struck by a van.", "lane_change"),
        ("While he was turning right, the driver of V1 struck V2.", "turn_right"),
    ],
)
def test_a_pronoun_before_the_name(read, text: str, act: str) -> None:
    assert actions(read(text)["E"])[0] == act


@pytest.mark.parametrize(
    ("text", "ego", "other"),
    [
        ("Vehicle 1 (2012 Toyota Sienna minivan) rear-ended Vehicle 2 (2008 Freightliner box truck).", "van", "truck"),
        ("Unit 1 (2014 Honda Civic sedan) changed lanes into Unit 2 (2016 Harley motorcycle).", "car", "motorcycle"),
    ],
)
def test_brackets_behind_a_label_say_what_it_is(read, text: str, ego: str, other: str) -> None:
    structure = read(text)
    assert (structure.ego.spec.type, [o.spec.type for o in structure.objects]) == (ego, [other])


@pytest.mark.parametrize(
    "text",
    [
        "U-1 was E/B. O-unit was N/B and went. O-unit front to U-1 right rear door.",
        "V1 N/B, V2 W/B. V2 front to V1 right side.",
        "U-1 was E/B. U-2 crossed the center line. Head-on impact.",
        "V2 was W/B in the E/B lanes and V1 E/B. Head-on, left lane.",
        "The left front corner of the Prius and the right door of the AV came into contact.",
        "The AV was braking with a gray SUV following. The driver of the following SUV hit the rear of the AV.",
        "I was stationary in the queue at the lights when a white Transit went into the back of me.",
    ],
)
def test_who_is_hit_in_few_words(read, text: str) -> None:
    structure = read(text)
    assert len(structure.objects) == 1
    hits = [p.target for p in structure.objects[0].spec.phases if p.action == "collide"]
    assert hits == ["ego"]


@pytest.mark.parametrize(
    ("text", "acts"),
    [
        ("A van ploughed through a line of cones and into the back of a stationary lorry.", ["collide"]),
        ("A car ran a red light and into the side of a bus.", ["run_red", "collide"]),
        ("V1 ran off the road and into a tree.", ["leave_road", "collide"]),
    ],
)
def test_a_verb_left_out_before_into(read, text: str, acts: list[str]) -> None:
    assert [p.action for p in read(text).ego.spec.phases] == acts


@pytest.mark.parametrize(
    "text",
    [
        "V2 riding bicycle westbound swerved left in front of V1.",
        "V2, riding a bicycle W/B, swerved left in front of V1.",
        "V2 was riding a bicycle northbound and swerved in front of V1.",
    ],
)
def test_a_direction_behind_a_noun_leaves_it_one(read, text: str) -> None:
    assert [o.spec.type for o in read(text).objects] == ["bicycle"]
