"""What a collision says of places and parties."""

import pytest


def test_a_chain(read) -> None:
    s = read("V1 was slowing for a queue. V2 struck the rear of V1 and V3 then struck the rear of V2.")
    told = [(o.spec.placement.position, o.spec.placement.of, o.spec.phases[-1].target) for o in s.objects]
    assert told == [("behind", "ego", "ego"), ("behind", "O1", "O1")]


def test_in_that_order(read) -> None:
    s = read("Vehicles 1, 2 and 3 were westbound in one lane, in that order. Vehicle 3 ran into Vehicle 2.")
    assert [(o.spec.placement.position, o.spec.placement.of) for o in s.objects] == [
        ("behind", "ego"),
        ("behind", "O1"),
    ]


def test_pushed_into_another(read) -> None:
    s = read("V1 stopped for a red light. V3 struck the rear of V2, which was pushed into V1.")
    hits = {(o.spec.name, p.target) for o in s.objects for p in o.spec.phases if p.action == "collide"}
    assert len(hits) == 2 and ("v2", "ego") in hits


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("Unit 1 departed the roadway to the right and struck a utility pole.", "right"),
        ("The garden wall was hit by V1, which had left the road on the left.", "left"),
        ("The ego veered off the road to the left and hit the guardrail.", "left"),
        ("The car ran off the road and into a fence on the right.", "right"),
    ],
)
def test_beside_the_road(read, text: str, side: str) -> None:
    s = read(text)
    at = s.objects[0].spec.placement
    assert (at.position, at.side) == ("roadside", side)
    assert [p.action for p in s.ego.spec.phases][-1] == "collide"


def test_a_wall_in_passing_is_nothing(read) -> None:
    assert not read("The ego drives along a wall.").objects


def test_one_that_brakes_in_the_next_lane_is_ahead(read) -> None:
    s = read("The ego changed to the right lane and hit a truck that was braking.")
    assert (s["O1"].spec.placement.position, s["O1"].spec.placement.along) == ("right_lane", "ahead")
