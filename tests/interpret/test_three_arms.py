"""Junctions with three arms: who comes by the side road turns."""

import pytest

from c2s_engine.interpret.embedded import EmbeddedInterpreter

FROM_THE_SIDE_ROAD = [
    "At a T-intersection, a car comes from the left and ego has to brake.",
    "V1 approached a T-junction. V2 was crossing from the right and struck V1.",
    "Three-legged intersection: ego drives at 40 km/h, a truck crosses from the left.",
]


@pytest.mark.parametrize("text", FROM_THE_SIDE_ROAD)
def test_who_comes_out_of_the_side_road_turns(text):
    found = EmbeddedInterpreter().interpret(text).structure
    assert found.place.spec.arms == 3
    actions = [p.action for p in found["O1"].spec.phases]
    assert "turn_left" in actions and "go_straight" not in actions
    assert any("side road" in a.reason for a in found["O1"].assumed)


@pytest.mark.parametrize(
    "text",
    [
        "Ego turns left at a T-junction while a car from the right goes straight.",
        "At a four-way intersection, a car comes from the left and goes straight, and ego has to brake.",
    ],
)
def test_who_has_a_road_ahead_goes_straight(text):
    found = EmbeddedInterpreter().interpret(text).structure
    assert [p.action for p in found["O1"].spec.phases] == ["go_straight"]
