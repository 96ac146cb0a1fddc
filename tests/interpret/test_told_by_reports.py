"""Reports of crashes: clauses joined by "and", sides by the compass, owners, what is left untold."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "V1 crossed the center line and the front of V1 hit the front of V2, a northbound van.",
        "V1 was southbound. It drifted over the centreline and its left side struck V2, which was northbound.",
    ],
)
def test_a_subject_behind_and_is_no_object(read, text: str) -> None:
    s = read(text)
    assert "collide" in actions(s["E"])
    assert s.objects[0].spec.placement.position == "oncoming_lane"


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("V1 was eastbound and left the road on the north side and hit a tree.", "left"),
        ("V1, northbound, ran off the west edge of the road and struck a fence.", "left"),
        ("V1 was heading south and went off the west side of the road into a pole.", "right"),
    ],
)
def test_off_the_road_by_the_compass(read, text: str, side: str) -> None:
    s = read(text)
    assert [(p.action, p.side) for p in s["E"].spec.phases][0] == ("leave_road", side)
    assert s.objects[0].spec.placement.side == side


@pytest.mark.parametrize(
    "text",
    [
        "V1 was westbound in the left lane. V2 was eastbound in the second lane and crossed the centerline.",
        "V1 was southbound in lane 1. V2 was northbound in lane 2 and crossed the median and hit V1 head-on.",
        "V1 was eastbound in the left lane. V2 was westbound in the left lane, lost control and hit V1.",
    ],
)
def test_lanes_of_the_other_direction(read, text: str) -> None:
    assert read(text).objects[0].spec.placement.position == "oncoming_lane"


@pytest.mark.parametrize(
    "text",
    [
        "V1 was stopped in the left turn lane. V2 turned left from the cross street and struck V1.",
    ],
)
def test_who_is_struck_waiting_never_turns(read, text: str) -> None:
    assert not {"turn_left", "turn_right"} & set(actions(read(text)["E"]))


@pytest.mark.parametrize(
    "text",
    [
        "The AV was stopped at a red light. The light turned green and the AV started to move forward.",
        "V1 was stopped at a stop sign and then moved forward into the intersection.",
        "I was stopped at the lights, they changed and I began to pull forward.",
    ],
)
def test_from_a_stand(read, text: str) -> None:
    assert {"start", "go_straight"} & set(actions(read(text)["E"]))


@pytest.mark.parametrize(
    "text",
    [
        "The Polo of a woman from Leeds had to stop for a schoolboy. A van behind her ran into the Polo.",
        "The car of a pensioner stopped for a boy at a crossing. A van which followed him ran into the car.",
    ],
)
def test_an_owner_is_nobody_else(read, text: str) -> None:
    assert {o.spec.type for o in read(text).objects} == {"child", "van"}


@pytest.mark.parametrize(
    "text",
    [
        "V1, a pickup also eastbound, turned right in front of a cyclist.",
        "V1, a van also northbound, made a right turn in front of a bicyclist.",
    ],
)
def test_between_commas_behind_a_label(read, text: str) -> None:
    s = read(text)
    assert [o.spec.type for o in s.objects] == ["bicycle"]
    assert actions(s["E"]) == ["turn_right"]


@pytest.mark.parametrize(
    "text",
    [
        "A van that had just overtaken a cyclist turned right and hit him.",
        "The bus that had just passed a cyclist turned right and struck her.",
    ],
)
def test_what_had_happened_comes_first(read, text: str) -> None:
    assert actions(read(text)["E"])[:2] == ["overtake", "turn_right"]


@pytest.mark.parametrize(
    "text",
    [
        "V2 was making a left turn from a private driveway. V1 was westbound and hit V2.",
        "V1 was northbound when V2 came out of the Dunkin Donuts. V1 struck V2.",
        "V2 turned right out of a parking lot in front of V1, and V1 hit V2.",
    ],
)
def test_out_of_a_drive(read, text: str) -> None:
    assert actions(read(text).objects[0])[0] == "enter_road"


def test_an_undivided_road_is_no_motorway(read) -> None:
    assert read("V1 was northbound on a two-lane undivided roadway and braked.")["R"].spec.kind == "road"
    assert read("V1 was northbound on a four-lane divided roadway and braked.")["R"].spec.kind == "motorway"


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("The AV was turning left from Pine onto Bush when a van behind it hit it.", ["van"]),
        ("A bus transporting pupils hit a parked car.", ["car"]),
        ("She was standing at the bus stop when she saw the red car hit the motorcycle.", ["motorcycle"]),
    ],
)
def test_who_is_only_named(read, text: str, types: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == types


@pytest.mark.parametrize(
    "text",
    [
        "Vehicle 2 was disabled in the left lane. Vehicle 1 swerved to the right, hitting Vehicle 3 in the right lane.",
        "V2 was stopped in the left lane. V1 swerved right into V3, which was passing in the right lane.",
    ],
)
def test_who_dodges_was_in_that_lane(read, text: str) -> None:
    s = read(text)
    assert s["R"].spec.ego_lane == "leftmost"
    assert [o.spec.placement.position for o in s.objects] == ["ahead", "right_lane"]


@pytest.mark.parametrize(
    "text",
    [
        "V1 was westbound when V2 came across the center line into its lane and hit it.",
        "Operator 2 drifted over the centre line into operator 1's lane and struck operator 1.",
        "I was driving west when a van came over the centre line into my lane and hit me.",
    ],
)
def test_over_the_centre_line_into_the_lane(read, text: str) -> None:
    spec = read(text).objects[0].spec
    assert (spec.placement.position, [p.action for p in spec.phases]) == ("oncoming_lane", ["oncoming", "collide"])


@pytest.mark.parametrize(
    "text",
    [
        "V1 hit V2. Two persons are lightly injured.",
        "V1 hit V2. Ambulance 43 on scene.",
        "V1 hit V2. An ambulance took the driver to hospital. Residents have long called for better lighting.",
        "V1 hit V2. One lady spilled her coffee.",
    ],
)
def test_who_comes_afterwards_is_not_there(read, text: str) -> None:
    assert [o.spec.name for o in read(text).objects] == ["v2"]


@pytest.mark.parametrize(
    ("text", "time"),
    [
        ("On 14.01 at about 2340 hrs V1 was northbound and braked.", "night"),
        ("At approx. 0150, V1 ran off the road.", "night"),
        ("The sun had just gone down when V1 hit a deer.", "dusk"),
    ],
)
def test_the_clock_of_reports(read, text: str, time: str) -> None:
    assert read(text)["G"].spec.time == time


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("I hit my neighbour's Fiesta, which was parked at the kerb.", ["car"]),
        ("A disabled Honda CR-V was in front of a tow truck. V1 struck the tow truck.", ["car", "truck"]),
        ("A woman was hurt. Two cows stood on the road when the woman's Polo struck them.", ["animal"]),
    ],
)
def test_each_is_there_once(read, text: str, types: list[str]) -> None:
    assert sorted(o.spec.type for o in read(text).objects) == sorted(types)


@pytest.mark.parametrize(
    "text",
    [
        "V2 turned left in front of V1 and V1 was unable to avoid a collision.",
        "TP emerged into the path of PH. PH could not avoid collision.",
    ],
)
def test_what_could_not_be_avoided_was_hit(read, text: str) -> None:
    s = read(text)
    assert actions(s["E"])[-1] == "collide"
    assert len(s.objects) == 1


@pytest.mark.parametrize(
    "text",
    [
        "V1 hit V3, which was stopped facing west at the intersection.",
        "V3 was stopped facing the light and V1 ran into it.",
        "V1 ran into V3, which was stopped waiting to turn left.",
    ],
)
def test_stopped_facing_somewhere(read, text: str) -> None:
    assert actions(read(text).objects[0]) == ["stationary"]


@pytest.mark.parametrize(
    "text",
    [
        "V2 braked for a car leaving the lot and V1 swerved left and hit V2.",
    ],
)
def test_a_subject_behind_a_participle(read, text: str) -> None:
    assert actions(read(text)["E"]) == ["swerve", "collide"]
