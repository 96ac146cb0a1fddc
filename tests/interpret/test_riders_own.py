"""People and what they ride or drive as their own; cyclists who come before ego; automated cars that are not ego."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter


def _others(text: str) -> list[tuple]:
    objects = EmbeddedInterpreter().interpret(text).structure.objects
    return [(o.spec.type, o.spec.placement.position, [p.action for p in o.spec.phases]) for o in objects]


@pytest.mark.parametrize(
    ("text", "position", "acts"),
    [
        ("A cyclist swerves into ego's lane.", "partly_in_lane", ["swerve"]),
        ("A cyclist on the right moves over in front of ego.", "partly_in_lane", ["swerve"]),
        ("A cyclist in the bike lane veers into ego's path.", "partly_in_lane", ["swerve"]),
        ("There is a cyclist in front of ego.", "ahead", []),
        ("A cyclist is on the road in front of ego.", "ahead", []),
        ("There is a woman riding a bicycle in front of ego.", "ahead", []),
        ("A cyclist appears in front of ego.", "roadside", ["cross_road"]),
    ],
)
def test_cyclists_before_ego(text: str, position: str, acts: list[str]) -> None:
    assert _others(text) == [("bicycle", position, acts)]


@pytest.mark.parametrize(
    "text",
    [
        "Ego, an autonomous truck, follows a car that brakes.",
        "An automated vehicle (ego) follows a car that brakes.",
        "The ego vehicle is a self-driving shuttle and follows a car that brakes.",
        "An autonomous vehicle drives behind a car. The car brakes and the ego vehicle stops.",
    ],
)
def test_egos_other_names(text: str) -> None:
    assert _others(text) == [("car", "ahead", ["brake"])]
