"""Where one is, in the many ways in which people say it: the same place, and the same road user as ego."""

import pytest

AHEAD = [
    "The van that is in front of ego brakes.",
    "The van up the road brakes.",
    "The van further along the road brakes.",
    "With a van in front of it that brakes, ego drives along.",
    "Ego has a van in front of it, which brakes.",
    "Our car has a van in front of it that brakes.",
]
BEHIND = [
    "A van in back of us brakes.",
    "The van on our tail brakes.",
    "The van at our back brakes.",
    "Ego has a van behind it that brakes.",
    "A van tailgating us brakes.",
]
LEFT = [
    "A van one lane over to the left brakes.",
    "A van one lane left of ego brakes.",
    "A van in the left neighbour lane brakes.",
    "A van in the lane to the left of ours brakes.",
    "On the left lane a van brakes.",
    "In the left adjacent lane, a van brakes.",
    "A van which is in the left lane brakes.",
    "A van occupying the left lane brakes.",
    "A van using the left lane brakes.",
]
ONCOMING = [
    "A van facing us brakes.",
    "A van driving in the opposite direction brakes.",
    "A van going the other way brakes.",
    "A van that comes the other way brakes.",
    "A van in the opposing lane brakes.",
    "A van on the other side of the road brakes.",
    "A van in the contraflow lane brakes.",
    "A van travelling opposite to ego brakes.",
]
SAME = {"ahead": AHEAD, "behind": BEHIND, "left_lane": LEFT, "oncoming_lane": ONCOMING}


@pytest.mark.parametrize(("position", "text"), [(p, t) for p, texts in SAME.items() for t in texts])
def test_the_same_place(read, position: str, text: str) -> None:
    s = read(text)
    assert [(o.spec.type, o.spec.placement.position) for o in s.objects] == [("van", position)]
    assert [p.action for p in s["O1"].spec.phases][-1] == "brake"
    assert s.ego.spec.type == "car" and not s.ego.spec.phases


@pytest.mark.parametrize(
    "text",
    [
        "Ego drives side by side with a van.",
        "Ego drives neck and neck with a van.",
        "Ego drives along; alongside it is a van.",
        "Ego has a van next to it.",
    ],
)
def test_beside(read, text: str) -> None:
    assert [o.spec.placement.position for o in read(text).objects] == ["beside"]


def test_it_beside_whom_one_has_is_the_holder(read) -> None:
    s = read("Ego has a van next to it and a truck behind it.")
    assert [(o.spec.placement.position, o.spec.placement.of) for o in s.objects] == [
        ("beside", "ego"),
        ("behind", "ego"),
    ]
    assert read("With a truck behind it, ego drives along.")["O1"].spec.placement.position == "behind"


@pytest.mark.parametrize("verb", ["rides", "cycles", "pedals along"])
def test_who_rides_in_front_does_not_cross(read, verb: str) -> None:
    cyclist = read(f"A cyclist {verb} in front of ego.")["O1"].spec
    assert (cyclist.placement.position, [p.action for p in cyclist.phases]) == ("ahead", ["move_along"])
    assert read("A cyclist suddenly rides in front of ego.")["O1"].spec.phases[0].action == "cross_road"


@pytest.mark.parametrize(
    "text",
    [
        "There is a van parked on the right side of the road.",
        "On the right there is a parked van.",
        "On the right-hand side a van is parked.",
    ],
)
def test_parked_on_the_right(read, text: str) -> None:
    van = read(text)["O1"].spec
    assert (van.type, van.placement.position, van.placement.side, van.speed) == ("van", "parked", "right", 0)


@pytest.mark.parametrize(
    "text",
    [
        "The road ahead is littered with debris.",
    ],
)
def test_what_lies_there(read, text: str) -> None:
    s = read(text)
    assert [o.spec.type for o in s.objects] == ["debris"] and s.ego.spec.speed


@pytest.mark.parametrize(
    "text", ["A van slightly ahead of us in the next lane brakes.", "A van slightly behind ego brakes."]
)
def test_slightly_ahead_is_not_slightly_braked(read, text: str) -> None:
    assert read(text)["O1"].spec.phases[-1].rate is None


@pytest.mark.parametrize(
    "place",
    [
        "facing us",
        "in the same lane 30 m ahead",
    ],
)
def test_that_after_a_place_is_who_is_there(read, place: str) -> None:
    told = read(f"Ego drives at 50 km/h. A van {place} suddenly brakes.")["O1"].spec
    shown = read(f"Ego drives at 50 km/h and notices a van {place} that brakes.")["O1"].spec
    assert [p.action for p in shown.phases][-1] == "brake"
    assert shown.placement.position == told.placement.position


@pytest.mark.parametrize(
    ("text", "type_", "count"),
    [
        ("A group of pedestrians crosses the road.", "pedestrian", 3),
        ("A group of people on the left pavement crosses the road.", "pedestrian", 3),
        ("A crowd of children runs across the road.", "child", 5),
    ],
)
def test_a_group_is_all_of_them(read, text: str, type_: str, count: int) -> None:
    assert [(o.spec.type, o.spec.count) for o in read(text).objects] == [(type_, count)]


@pytest.mark.parametrize(
    "text",
    [
        "A pedestrian is at the bus stop on the right and crosses the road.",
        "There is a pedestrian at the bus stop on the right. Suddenly he crosses the road.",
        "A cyclist 30 m ahead on the right crosses the road.",
        "A cyclist next to a parked van on the right crosses the road.",
    ],
)
def test_who_is_at_the_road_crosses_it(read, text: str) -> None:
    spec = next(o.spec for o in read(text).objects if o.spec.type in ("pedestrian", "bicycle"))
    assert (spec.placement.position, spec.placement.side) == ("roadside", "right")
    assert [p.action for p in spec.phases] == ["cross_road"]
