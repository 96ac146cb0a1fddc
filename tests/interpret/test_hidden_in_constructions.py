"""That one is hidden, told in many constructions: the same place, the same blocker, and nobody else hidden."""

import pytest

HIDDEN = [
    "A child hidden by a parked van runs across the road.",
    "A child who is not visible behind a parked van runs across the road.",
    "A child shielded from view by a parked van runs across the road.",
    "A child in the blind area of a parked van runs across the road.",
    "Behind a parked van stands a child, who then runs across the road.",
    "Because of a parked van ego cannot see a child who runs across the road.",
    "A parked van masks a child running across the road.",
    "A parked van obscures a child running across the road.",
    "Ego passes a parked van. Behind it a child runs across the road.",
    "Ego passes a parked van from behind which a child runs across the road.",
    "With a parked van obscuring the view, a child runs across the road.",
    "Hidden behind a parked van, a child runs across the road.",
    "A child hidden by a parked van crosses the road at a run.",
]


@pytest.mark.parametrize("text", HIDDEN)
def test_the_child_is_hidden(read, text: str) -> None:
    van, child = (o.spec for o in read(text).objects)
    assert (van.type, van.placement.position) == ("van", "parked")
    assert (child.type, child.placement.hidden_by) == ("child", "O1")
    assert [p.action for p in child.phases] == ["cross_road"]


@pytest.mark.parametrize(
    "text",
    [
        "A van brakes for a dog that shot out from behind a hedge.",
        "A van ahead of ego brakes for a child who runs out from behind a parked truck.",
        "When a child runs out from behind a parked truck, the van ahead of ego brakes.",
        "A child runs out from behind a parked truck, and the van ahead of ego brakes.",
        "The van ahead has to brake because a cyclist comes out from behind a container.",
    ],
)
def test_only_who_comes_out_is_hidden(read, text: str) -> None:
    hidden = {o.spec.type: o.spec.placement.hidden_by is not None for o in read(text).objects}
    assert not hidden.pop("van")
    assert sorted(hidden.values()) == [False, True]


@pytest.mark.parametrize(
    "text",
    [
        "A car approaches from the right behind a hedge.",
    ],
)
def test_the_view_to_a_side(read, text: str) -> None:
    s = read(text)
    car = next(o for o in s.objects if o.spec.type == "car")
    assert car.spec.placement.hidden_by == next(o.id for o in s.objects if o is not car)


@pytest.mark.parametrize("what", ["steps out", "crosses the road", "walks across"])
def test_in_front_of_a_standing_bus(read, what: str) -> None:
    s = read(f"A pedestrian {what} in front of a stopped bus.")
    assert [(o.spec.type, o.spec.placement.hidden_by) for o in s.objects] == [("bus", None), ("pedestrian", "O1")]
