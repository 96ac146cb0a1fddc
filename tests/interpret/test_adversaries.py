"""Those set against ego, under whatever name, and the speeds and ways of those who cross."""

import pytest


@pytest.mark.parametrize(
    ("text", "phases"),
    [
        ("The attacker approaches ego from behind and rams it.", ["collide"]),
        ("The BV in the adjacent lane cuts in front of the AV.", ["cut_in"]),
        ("A hostile driver tailgates the ego.", ["follow"]),
        ("Adversary vehicle overtakes the ego. The adversary then brakes hard.", ["overtake", "brake"]),
        ("The ego car goes straight. The hostile car waits opposite and turns left across its path.", ["turn_left"]),
    ],
)
def test_an_adversary_is_not_ego(read, text: str, phases: list[str]) -> None:
    s = read(text)
    assert len(s.objects) == 1 and [p.action for p in s.objects[0].spec.phases] == phases
    assert not {p.action for p in s["E"].spec.phases} & {*phases}


@pytest.mark.parametrize(
    ("text", "speed"),
    [
        ("A pedestrian steps into the path of the ego at 1.5 m/s.", 1.5),
        ("A moped crosses the trajectory of the host vehicle at 36 km/h from the right.", 10.0),
        ("A van turns left across the path of the AV at 18 km/h.", 5.0),
        ("A tractor drives in front of the VUT at 18 km/h.", 5.0),
        ("A dog dashes out in front of the subject vehicle at 5 m/s.", 5.0),
    ],
)
def test_the_speed_of_one_who_crosses(read, text: str, speed: float) -> None:
    assert read(text).objects[0].spec.speed == pytest.approx(speed, abs=0.1)


def test_the_speed_of_ego_where_one_stands(read) -> None:
    s = read("A child runs out in front of the ego at 54 km/h.")
    assert s["E"].spec.speed == pytest.approx(15, abs=0.1)


@pytest.mark.parametrize("verb", ["crosses in front of", "crosses right ahead of", "crosses before"])
@pytest.mark.parametrize("who", ["A truck", "A car", "A cyclist"])
def test_crossing_in_front_is_no_cut_in(read, who: str, verb: str) -> None:
    actions = [p.action for p in read(f"{who} {verb} the ego.").objects[0].spec.phases]
    assert actions in (["go_straight"], ["cross_road"])


def test_crossing_lanes_is(read) -> None:
    s = read("A car in the right lane crosses in front of the ego into the left lane.")
    assert [p.action for p in s.objects[0].spec.phases] == ["cut_in"]


@pytest.mark.parametrize("text", ["An ambulance at high speed approaches from the rear.", "A van comes from the left."])
def test_who_comes_from_somewhere_comes_towards_ego(read, text):
    assert len(read(text).objects) == 1


def test_it_stops_for_a_purpose(read):
    (bus,) = read("Ego follows a bus, which stops to let passengers off.").objects
    assert [p.action for p in bus.spec.phases] == ["stop"]
