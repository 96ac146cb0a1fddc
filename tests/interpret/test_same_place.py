"""Where one is, in the many ways in which people say it: the same place, and the same road user as ego."""

import pytest

AHEAD = [
    "The van that is in front of ego brakes.",
    "The van up the road brakes.",
    "The van further along the road brakes.",
    "The van ego is behind brakes.",
    "The van that ego has in front brakes.",
    "With a van in front of it that brakes, ego drives along.",
    "Ego has a van ahead of it. The van brakes.",
    "Ego has a van in front of it, which brakes.",
    "Our car has a van in front of it that brakes.",
]
BEHIND = [
    "A van in back of us brakes.",
    "The van on our tail brakes.",
    "The van at our back brakes.",
    "The van ego is ahead of brakes.",
    "Ego has a van behind it that brakes.",
    "Ego leads a van, which brakes.",
    "A van following ego brakes.",
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
    "A van front-left of ego brakes.",
    "A van ahead and to the left of ego brakes.",
    "A van left ahead of ego brakes.",
    "The van to our left brakes.",
]
ONCOMING = [
    "A van facing us brakes.",
    "A van heading our way brakes.",
    "A van driving in the opposite direction brakes.",
    "A van going the other way brakes.",
    "A van that comes the other way brakes.",
    "A van in the opposing lane brakes.",
    "A van on the other side of the road brakes.",
    "A van in the contraflow lane brakes.",
    "A van in oncoming traffic brakes.",
    "A van travelling opposite to ego brakes.",
    "A van approaching ego head-on brakes.",
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
        "The van two cars up brakes.",
        "A van two cars ahead of ego brakes.",
        "A van a couple of cars in front of us brakes.",
        "Two cars up, a van brakes.",
        "The van that is two vehicles ahead brakes.",
    ],
)
def test_one_that_drives_between(read, text: str) -> None:
    car, van = (o.spec for o in read(text).objects)
    assert (car.type, car.count, car.phases) == ("car", 1, ())
    assert (van.type, van.placement.of, [p.action for p in van.phases]) == ("van", "O1", ["brake"])


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
        "Somebody has parked a van on the right.",
    ],
)
def test_parked_on_the_right(read, text: str) -> None:
    van = read(text)["O1"].spec
    assert (van.type, van.placement.position, van.placement.side, van.speed) == ("van", "parked", "right", 0)


@pytest.mark.parametrize(
    "text",
    ["Ego's lane is strewn with debris.", "The road ahead is littered with debris.", "Debris litters ego's lane."],
)
def test_what_lies_there(read, text: str) -> None:
    s = read(text)
    assert [o.spec.type for o in s.objects] == ["debris"] and s.ego.spec.speed


@pytest.mark.parametrize(
    "text", ["A van slightly ahead of us in the next lane brakes.", "A van slightly behind ego brakes."]
)
def test_slightly_ahead_is_not_slightly_braked(read, text: str) -> None:
    assert read(text)["O1"].spec.phases[-1].rate is None
