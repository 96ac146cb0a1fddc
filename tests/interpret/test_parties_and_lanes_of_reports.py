"""Reports: vehicles told apart by who hit whom, who turns or runs a light across whose way, numbered lanes, queues."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    ("text", "does"),
    [
        ("The bullet vehicle crossed the centerline and met the target vehicle head-on.", ["oncoming", "collide"]),
        ("The striking car drifted over the line and sideswiped the struck truck.", ["drift", "collide"]),
        ("The at-fault driver ran the stop sign and hit the other vehicle.", ["run_stop", "collide"]),
    ],
)
def test_who_struck_and_who_was_struck(read, text: str, does: list[str]) -> None:
    s = read(text)
    assert actions(s["E"]) == does
    assert [p.target for p in s["E"].spec.phases][-1] == "O1" and len(s.objects) == 1


@pytest.mark.parametrize(
    "text",
    [
        "The car ran a red light and struck the other car.",
        "A truck changed lanes and sideswiped the other vehicle.",
        "The pickup crossed the centre line and collided head-on with the other vehicle.",
    ],
)
def test_the_other_is_not_who_does_it(read, text: str) -> None:
    s = read(text)
    assert actions(s["E"])[-1] == "collide" and len(s.objects) == 1


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("V1 ran the red light and rear-ended V2.", None),
    ],
)
def test_across_whose_way(read, text: str, position: str | None) -> None:
    placement = read(text).objects[0].spec.placement
    assert (placement.position if position else None) == position


@pytest.mark.parametrize(
    "text",
    [
        "The VUT approaches the GVT from behind at 60 km/h.",
        "The ego comes up on a truck from behind.",
        "Ego, approaching a slow car from behind, brakes.",
    ],
)
def test_who_nears_from_behind_is_behind(read, text: str) -> None:
    assert read(text).objects[0].spec.placement.position == "ahead"


@pytest.mark.parametrize(
    "text",
    [
        "The ego brakes for traffic backed up at the off-ramp.",
        "V1 stopped for traffic that was backed up from the exit.",
        "I came upon stopped traffic backed up to the lights.",
    ],
)
def test_traffic_backed_up_stands(read, text: str) -> None:
    assert actions(read(text).objects[0]) == ["stationary"]


@pytest.mark.parametrize(
    "text",
    [
        "The van came up behind a slow lorry. Its driver pulled out and overtook the lorry.",
        "V1 came up behind V2. Its driver changed lanes and overtook V2.",
        "A car follows a truck. It pulls out and overtakes the truck.",
    ],
)
def test_nobody_overtakes_itself(read, text: str) -> None:
    assert actions(read(text)["E"])[-1] == "overtake"


@pytest.mark.parametrize(
    "text",
    [
        "A van stands on the shoulder. When we are 40 m or so away it moves off into our lane.",
    ],
)
def test_who_pulls_out_when_ego_is_near(read, text: str) -> None:
    assert actions(read(text).objects[0]) == ["enter_road"]


@pytest.mark.parametrize(
    "text",
    [
        "I was driving at 30 mph. A taxi pulls out in front of me. Bus was waiting behind me.",
        "I was going straight on. A car hit my door. City bus was sitting at the next entry.",
        "I was in the left lane. Truck was right behind me and hit me.",
    ],
)
def test_a_bus_told_of_beside_the_driver(read, text: str) -> None:
    assert read(text)["E"].spec.type == "car"


@pytest.mark.parametrize(
    "text",
    [
        "V2 pulled into V1's path.",
        "I was driving at 50 and a van wandered into my lane.",
    ],
)
def test_into_the_lane_of_ego(read, text: str) -> None:
    other = read(text).objects[0].spec
    assert [(p.action, p.target) for p in other.phases] == [("cut_in", "ego")]


def test_over_from_the_oncoming_lane(read) -> None:
    assert actions(read("A van coming the other way drifted into my lane.").objects[0]) == ["oncoming"]


@pytest.mark.parametrize(
    "text",
    [
        "A car reversed out of a drive into my door.",
        "A van backed out of a driveway into the side of the ego.",
        "The other driver reversed out of a parking space into my passenger side.",
    ],
)
def test_out_of_a_place_into_ego(read, text: str) -> None:
    assert actions(read(text).objects[0]) == ["reverse", "collide"]


@pytest.mark.parametrize(
    "text",
    [
        "A cyclist passes on the nearside; the vehicle turns right.",
        "A bicycle dummy moves parallel to the vehicle; the vehicle turns right at 10 km/h.",
    ],
)
def test_the_vehicle_is_no_bicycle(read, text: str) -> None:
    assert "turn_right" in actions(read(text)["E"])


def test_a_make_that_is_a_verb(read) -> None:
    assert len(read("truck loses a ladder in front of us, we dodge it to the left").objects) == 1
