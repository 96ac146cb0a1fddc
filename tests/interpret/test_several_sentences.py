"""Texts of several sentences: who is meant again, and what came first though it is told later."""
# ruff: noqa: E501  (tables of cases stay on one line)

import pytest


def told(read, text: str) -> dict[str, list[str]]:
    """What each one does, by its type."""
    s = read(text)
    return {o.spec.type: [p.action for p in o.spec.phases] for o in s.objects}


def of_ego(read, text: str) -> list[str]:
    return [p.action for p in read(text).ego.spec.phases]


@pytest.mark.parametrize(
    ("text", "acts"),
    [
        ("A van is ahead of ego. As ego approaches the intersection, it turns right.", ["turn_right"]),
    ],
)
def test_it_is_ego_that_answers(read, text: str, acts: list[str]) -> None:
    assert of_ego(read, text) == acts


@pytest.mark.parametrize(
    ("first", "kind"),
    [
        ("There is a bus in front of us.", "bus"),
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
        ("The latter brakes.", ([], ["brake"])),
        ("One brakes, the other accelerates.", (["brake"], ["accelerate"])),
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


def test_a_second_one_is_new(read) -> None:
    s = read("A pedestrian stands on the right. A second one crosses from the left.")
    assert [[p.action for p in o.spec.phases] for o in s.objects] == [["stationary"], ["cross_road"]]
    s = read("Two cars are ahead of ego. The first one brakes. The second one changes to the left lane.")
    assert [[p.action for p in o.spec.phases] for o in s.objects] == [["brake"], ["lane_change"]]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A dog runs across the road from the right. A man runs after it.", ["animal", "pedestrian"]),
    ],
)
def test_who_runs_after_one_who_crosses(read, text: str, expected: list[str]) -> None:
    s = read(text)
    assert sorted(o.spec.type for o in s.objects) == expected
    assert all([p.action for p in o.spec.phases] == ["cross_road"] for o in s.objects)


@pytest.mark.parametrize(
    "causes", ["This causes him to swerve left", "Because of it he swerves left", "He swerves left"]
)
def test_who_is_made_to_do_it(read, causes: str) -> None:
    found = told(read, f"A cyclist rides ahead of ego. A dog runs out from the right. {causes}.")
    assert found["bicycle"][-1] == "swerve" and found["animal"] == ["cross_road"]


@pytest.mark.parametrize(
    "waits",
    [
        "An oncoming car approaches. Ego waits for it to pass and then overtakes the tractor.",
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
        ("Ego drives between two vans.", "The front van brakes. The rear one stops."),
    ],
)
def test_which_of_two_vans(read, first: str, then: str) -> None:
    assert [[p.action for p in o.spec.phases] for o in read(f"{first} {then}").objects] == [["brake"], ["stop"]]


def test_a_target_is_a_thing(read) -> None:
    s = read("A pedestrian target is on the right pavement. It crosses the road. It stops in the path of the VUT.")
    assert [p.action for p in s["O1"].spec.phases] == ["cross_road", "stop"] and len(s.objects) == 1
