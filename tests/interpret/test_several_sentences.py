"""Texts of several sentences: who is meant again, and what came first though it is told later."""
# ruff: noqa: E501  (tables of cases stay on one line)

import pytest


def told(read, text: str) -> dict[str, list[str]]:
    """What each one does, by its type."""
    s = read(text)
    return {o.spec.type: [p.action for p in o.spec.phases] for o in s.objects}


def of_ego(read, text: str) -> list[str]:
    return [p.action for p in read(text).ego.spec.phases]


NEARS = [
    "As ego gets close",
    "When ego is 20 m away",
    "Once the ego vehicle is within 30 m",
    "As the ego vehicle closes in on it",
    "As ego approaches",
    "By the time ego gets there",
    "When ego has come within 20 m of it",
]


@pytest.mark.parametrize("nears", NEARS)
@pytest.mark.parametrize(
    ("first", "kind", "does", "act"),
    [
        ("A deer stands on the verge.", "animal", "it bolts across the road", "cross_road"),
        ("There is a dog on the left pavement.", "animal", "it runs into the road", "cross_road"),
        ("A van is parked on the right.", "van", "it pulls out", "enter_road"),
        ("A tractor is ahead of ego at 20 km/h.", "truck", "it turns left into a field", "turn_left"),
        ("A bus is ahead of ego.", "bus", "it suddenly brakes hard", "brake"),
    ],
)
def test_it_is_who_ego_comes_near(read, nears: str, first: str, kind: str, does: str, act: str) -> None:
    for text in (f"{first} {nears}, {does}.", f"{first[:-1]}; {nears[0].lower()}{nears[1:]}, {does}."):
        assert told(read, text)[kind] == [act], text
        assert of_ego(read, text) == [], text


@pytest.mark.parametrize(
    ("text", "acts"),
    [
        ("A van is ahead of ego. As ego approaches the intersection, it turns right.", ["turn_right"]),
    ],
)
def test_it_is_ego_that_answers(read, text: str, acts: list[str]) -> None:
    assert of_ego(read, text) == acts


@pytest.mark.parametrize(
    "back",
    [
        "Before that, it cut in from the left lane",
        "It had cut in from the left lane shortly before",
        "It had previously cut in from the left lane",
        "It has just cut in from the left lane",
        "Moments earlier it had cut in from the left lane",
        "Three seconds earlier, the van cut in from the left lane",
        "Prior to this it cut in from the left lane",
        "The van had cut in from the left lane",
    ],
)
def test_what_came_first(read, back: str) -> None:
    assert told(read, f"A van brakes hard in front of ego. {back}.")["van"] == ["cut_in", "brake"]
    both = told(read, f"A van brakes hard in front of ego and turns right. {back}. Ego drives on.")["van"]
    assert both == ["cut_in", "brake", "turn_right"]


def test_what_comes_by_then_is_no_earlier(read) -> None:
    text = "A van pulls out of a driveway on the right. By the time ego gets there, it has stopped in the lane."
    assert told(read, text)["van"] == ["enter_road", "stop"]
    text = "A man crosses the road from the right. Ego brakes. By then he had stopped in the middle of the road."
    assert told(read, text)["pedestrian"] == ["cross_road", "wait"]


@pytest.mark.parametrize(
    ("first", "kind"),
    [
        ("An articulated lorry is ahead of ego.", "truck"),
        ("There is a bus in front of us.", "bus"),
        ("A delivery van drives ahead of the AV.", "van"),
    ],
)
def test_the_vehicle_is_who_was_told_of(read, first: str, kind: str) -> None:
    assert told(read, f"{first} The vehicle brakes hard.") == {kind: ["brake"]}


def test_the_vehicle_may_be_ego(read) -> None:
    s = read("A lorry is parked ahead of ego. The vehicle changes to the left lane to pass it.")
    assert [p.action for o in s.objects for p in o.spec.phases] == ["stationary"]


@pytest.mark.parametrize(
    ("who", "acts"),
    [
        ("The one ahead brakes.", (["brake"], [])),
        ("The one in front brakes.", (["brake"], [])),
        ("The car ahead brakes.", (["brake"], [])),
        ("The vehicle in front brakes.", (["brake"], [])),
        ("The leading car brakes.", (["brake"], [])),
        ("The one on the left brakes.", ([], ["brake"])),
        ("The one in the left lane brakes.", ([], ["brake"])),
        ("The car on the left brakes.", ([], ["brake"])),
        ("The vehicle in the left lane brakes.", ([], ["brake"])),
        ("The first one brakes.", (["brake"], [])),
        ("The second one brakes.", ([], ["brake"])),
        ("The latter brakes.", ([], ["brake"])),
        ("One brakes, the other accelerates.", (["brake"], ["accelerate"])),
        ("The one ahead brakes. The other one accelerates.", (["brake"], ["accelerate"])),
        ("The second brakes. The other accelerates.", (["accelerate"], ["brake"])),
    ],
)
def test_who_is_told_apart(read, who: str, acts: tuple[list[str], list[str]]) -> None:
    for first in (
        "A car is ahead of ego and a car is in the left lane.",
        "A car is ahead of ego. Another car is driving in the left lane.",
        "Ahead of ego there is a car. In the left lane there is another one.",
    ):
        found = [[p.action for p in o.spec.phases] for o in read(f"{first} {who}").objects]
        assert tuple(found) == acts, (first, who)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A van drives behind ego. The following vehicle brakes.", {"van": "brake"}),
        ("A van is ahead of ego and a bus is behind ego. The one behind brakes.", {"van": "", "bus": "brake"}),
        ("A truck and a van are ahead of ego. The first brakes, the second swerves.", {"truck": "brake", "van": "swerve"}),
        ("A car is parked on the right. A bus is ahead of ego. The parked one pulls out.", {"car": "enter_road", "bus": ""}),
        ("A car is parked on the right. A bus is ahead of ego. The moving vehicle brakes.", {"car": "stationary", "bus": "brake"}),
    ],
)  # fmt: skip
def test_who_is_told_apart_among_kinds(read, text: str, expected: dict[str, str]) -> None:
    found = {kind: acts[-1] if acts else "" for kind, acts in told(read, text).items()}
    assert {k: v.replace("follow", "") for k, v in found.items()} == expected


def test_a_second_one_is_new(read) -> None:
    s = read("A pedestrian stands on the right. A second one crosses from the left.")
    assert [[p.action for p in o.spec.phases] for o in s.objects] == [["stationary"], ["cross_road"]]
    s = read("Two cars are ahead of ego. The first one brakes. The second one changes to the left lane.")
    assert [[p.action for p in o.spec.phases] for o in s.objects] == [["brake"], ["lane_change"]]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A boy runs onto the road from the right. His mother runs after him.", ["child", "pedestrian"]),
        ("A child runs across the street. Its mother follows.", ["child", "pedestrian"]),
        ("A dog runs across the road from the right. A man runs after it.", ["animal", "pedestrian"]),
    ],
)
def test_who_runs_after_one_who_crosses(read, text: str, expected: list[str]) -> None:
    s = read(text)
    assert sorted(o.spec.type for o in s.objects) == expected
    assert all([p.action for p in o.spec.phases] == ["cross_road"] for o in s.objects)


@pytest.mark.parametrize(
    "text",
    [
        "A woman walks her dog on the right pavement. It breaks free and runs across the road.",
        "Ego drives at 50 km/h. A woman walks her dog on the right pavement. It runs across the road.",
    ],
)
def test_it_is_the_dog(read, text: str) -> None:
    found = told(read, text)
    assert found["animal"] == ["cross_road"] and found["pedestrian"] != ["cross_road"] and len(found) == 2


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("A delivery driver gets out of his van, which is parked on the right, and steps into the road.", "van"),
        ("A car stands with a flat tyre on the right shoulder. Its driver walks around it into ego's lane.", "car"),
        ("A van is parked on the right. The van driver gets out and crosses the road.", "van"),
    ],
)
def test_drivers_who_walk_are_on_foot(read, text: str, kind: str) -> None:
    found = told(read, text)
    assert found[kind] == ["stationary"] and "cross_road" in found["pedestrian"]


@pytest.mark.parametrize(
    "causes", ["This causes him to swerve left", "Because of it he swerves left", "He swerves left"]
)
def test_who_is_made_to_do_it(read, causes: str) -> None:
    found = told(read, f"A cyclist rides ahead of ego. A dog runs out from the right. {causes}.")
    assert found["bicycle"][-1] == "swerve" and found["animal"] == ["cross_road"]


@pytest.mark.parametrize(
    "waits",
    [
        "A car is coming the other way. Ego waits until it has gone by and overtakes the tractor.",
        "An oncoming car approaches. Ego waits for it to pass and then overtakes the tractor.",
        "A car is coming. Once it has gone by, ego overtakes the tractor.",
    ],
)
def test_who_waits_goes_on(read, waits: str) -> None:
    s = read(f"Ego follows a tractor on a country road with one lane each way. {waits}")
    assert "overtake" in [p.action for p in s.ego.spec.phases]
    assert not [p for o in s.objects for p in o.spec.phases if p.action == "overtake"]


@pytest.mark.parametrize(
    ("first", "then"),
    [
        (
            "Ego drives behind a white van. A black van is in the left lane.",
            "The white van brakes. The black van stops.",
        ),
        ("Ego drives behind a van. Another van is in the left lane.", "The van ahead brakes. The other van stops."),
        ("Ego drives between two vans.", "The front van brakes. The rear one stops."),
    ],
)
def test_which_of_two_vans(read, first: str, then: str) -> None:
    assert [[p.action for p in o.spec.phases] for o in read(f"{first} {then}").objects] == [["brake"], ["stop"]]


def test_a_target_is_a_thing(read) -> None:
    s = read("A pedestrian target is on the right pavement. It crosses the road. It stops in the path of the VUT.")
    assert [p.action for p in s["O1"].spec.phases] == ["cross_road", "stop"] and len(s.objects) == 1


@pytest.mark.parametrize(
    "text",
    [
        "A bus has stopped at a bus stop on the right. A child crosses the road in front of it.",
        "A bus stops at the bus stop on the right. A passenger gets out and crosses the road in front of it.",
        "A coach is at the stop. A man runs across the road from behind it.",
    ],
)
def test_a_bus_at_its_stop_is_passed(read, text: str) -> None:
    s = read(text)
    assert s["O1"].spec.type == "bus" and s.ego.spec.type == "car" and len(s.objects) == 2
