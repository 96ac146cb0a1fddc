"""Demands of two, of moments, of ends and of reasons in many wordings: each changes S as the plainest one does."""

import pytest

from c2s_engine.interpret.turn import route
from tests.interpret.demanded import LIGHTS, MOTORWAY, assert_same

STREET = "In heavy rain ego follows a car at 50 km/h. The car brakes hard and a pedestrian crosses from the right."
ROW = (
    "Ego drives at 30 km/h past three cars that are parked on the right. A child runs out from behind them. "
    "A bus comes the other way."
)


CELLS = [
    # how far from the place; two in one; who goes of several
    (
        LIGHTS,
        "ego starts 60 m before the intersection",
        "let ego start 60 metres away from the junction | the intersection is 60 m ahead of ego | "
        "the distance to the junction should be 60 m | ego should begin 60 m short of the crossroads",
    ),
    # what one does when he has done what he does
    # from both sides
    # whom something new hides
    (
        STREET,
        "add a parked van on the right that hides the pedestrian",
        "ego must not see him at first, so put a parked van on the right which covers him | "
        "put a parked van on the right, hiding the pedestrian from ego | "
        "add a van parked on the right which is hiding the pedestrian",
    ),
    # moments
    # how long one stops
    # reasons, and what is wrong
    # lights and signs
    # who follows, who comes into the lane, who goes first
    (MOTORWAY, "add a car that follows ego", "ego is followed by another car | let another car follow ego"),
    # the road
    (STREET, "less rain", "the rain should be light | the rain is too heavy | reduce the rain"),
    # what is supposed
    # who stands, who is parked, where he is
    (
        LIGHTS,
        "the motorcycle is 20 m behind ego",
        "the motorcycle follows ego at 20 m | keep the motorcycle 20 m behind us",
    ),
    # what follows for ego
    (
        ROW,
        "the child crosses, then it stops. ego brakes hard",
        "the child runs into the road and then stops there, so ego has to do an emergency brake | the child crosses, "
        "then it gets scared and stops there, and because of this ego must brake hard",
    ),
    # ego does nothing
]


@pytest.mark.parametrize(("scene", "plain", "wordings"), CELLS, ids=[c[1] for c in CELLS])
def test_a_demand_is_the_same_in_other_words(read, scene: str, plain: str, wordings: str) -> None:
    assert_same(read(scene), plain, wordings)


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("redo what i have just undone", "redo"),
        ("bring back what I took back", "redo"),
        ("repeat what was undone", "redo"),
        ("undo what i have just changed", "undo"),
        ("please revert what was changed last", "undo"),
        ("make that change undone", "undo"),
    ],
)
def test_back_and_forth(read, text: str, kind: str) -> None:
    assert route(text, read(STREET)).kind == kind


@pytest.mark.parametrize(
    "text",
    [
        "the pedestrian should wait 3 s",
    ],
)
def test_nobody_else_changes_for_one_who_is_not_there(read, text: str) -> None:
    assert not route(text, read(MOTORWAY)).edits
