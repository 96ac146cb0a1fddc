"""Who is told of in one go: two that do the same, the next of a list, both who are passed."""

import pytest


def seen(structure):
    return [(o.spec.type, o.spec.placement.position, [p.action for p in o.spec.phases]) for o in structure.objects]


@pytest.mark.parametrize("verb", ["approach the crossroads", "approach an intersection"])
def test_two_from_one_side_are_both_others(read, verb: str) -> None:
    s = read(f"A car and a bicycle {verb} from the right. The former stops, the latter goes straight on.")
    assert [(kind, where) for kind, where, _ in seen(s)] == [("car", "crossing_right"), ("bicycle", "crossing_right")]
    assert s.objects[0].spec.phases[0].action == "stop" and "stop" not in seen(s)[1][2]


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("Both the van in the left lane and the truck in the right lane drift toward the ego.", "drift"),
        ("The van in the left lane and the truck ahead of ego brake.", "brake"),
        ("The car ahead and the truck behind brake hard.", "brake"),
        ("A van and a motorcycle cut in in front of ego.", "cut_in"),
    ],
)
def test_two_do_the_same(read, text: str, act: str) -> None:
    assert [acts for _, _, acts in seen(read(text))] == [[act], [act]]


def test_one_of_a_group_is_no_new_one(read) -> None:
    assert len(read("Two cyclists ride ahead of ego, and one swerves to the left.").objects) == 2


@pytest.mark.parametrize("both", ["ego and the van", "ego and then the van"])
def test_who_passes_two_passes_each(read, both: str) -> None:
    s = read(f"A van drives ahead of ego. A motorcycle comes from behind and overtakes {both}.")
    passed = [(p.action, p.target) for p in s.objects[1].spec.phases]
    assert passed == [("overtake", "ego"), ("overtake", s.objects[0].id)]


def test_a_clause_that_follows_is_not_passed(read) -> None:
    s = read("Ego overtakes a truck and a car behind it brakes.")
    ego = next(c.spec for c in s.components if c.id == "E")
    assert [p.action for p in ego.phases].count("overtake") == 1


def test_the_second_one_does_it(read) -> None:
    s = read("Two motorcycles come toward ego. The first stays in its lane, the second one swerves into ego's lane.")
    assert [acts for _, _, acts in seen(s)] == [["keep_lane"], ["oncoming"]]


def test_two_that_crash_into_each_other_in_front_of_ego(read) -> None:
    s = read("A car comes toward ego. The car and a bus crash into each other in front of ego.")
    hits = [p.target for o in s.objects for p in o.spec.phases if p.action == "collide"]
    assert hits and "ego" not in hits


@pytest.mark.parametrize("title", ["Lead vehicle braking", "Lead vehicle decelerating"])
def test_a_title_names_nobody_besides(read, title: str) -> None:
    assert len(read(f"{title}: An SUV in front of the ego brakes at 3 m/s2 from 60 km/h.").objects) == 1


def test_a_note_before_a_colon_is_no_title(read) -> None:
    s = read("Car in front: emergency braking. Ego 5 m behind.")
    assert [acts for _, _, acts in seen(s)] == [["brake"]]


@pytest.mark.parametrize(
    ("text", "speeds"),
    [
        ("Ego at 60 km/h is overtaken by a van at 90 km/h.", (16.67, 25.0)),
        ("The ego vehicle at 60 km/h is followed by a truck at 80 km/h.", (16.67, 22.22)),
    ],
)
def test_each_has_its_own_speed(read, text: str, speeds: tuple[float, float]) -> None:
    s = read(text)
    ego = next(c.spec for c in s.components if c.id == "E")
    assert (ego.speed, s.objects[0].spec.speed) == speeds


@pytest.mark.parametrize(
    ("text", "sides"),
    [
        ("On the left side of the street pedestrians are walking.", ["left"]),
    ],
)
def test_a_place_before_who_is_there(read, text: str, sides: list[str]) -> None:
    assert [o.spec.placement.side for o in read(text).objects] == sides


def test_the_moment_before_who_it_is(read) -> None:
    s = read("The SUT drives at 60 km/h. At t = 2 s a bus 40 m ahead brakes to 20 km/h. At t = 8 s it accelerates.")
    assert [(p.action, p.trigger.value) for p in s.objects[0].spec.phases] == [("brake", 2.0), ("accelerate", 8.0)]
