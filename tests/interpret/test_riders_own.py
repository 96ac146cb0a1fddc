"""People and what they ride or drive as their own; cyclists who come before ego; automated cars that are not ego."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter

DOES = ["overtakes ego", "turns left in front of ego", "brakes hard ahead of ego", "crosses from the right"]
WHO = [
    ("a woman on her bike", "bike"),
    ("an old man riding his bicycle", "bicycle"),
    ("a student riding her moped", "moped"),
    ("a postman in his van", "van"),
    ("a farmer driving his tractor", "tractor"),
    ("a father driving his pickup", "pickup"),
]


def _others(text: str) -> list[tuple]:
    objects = EmbeddedInterpreter().interpret(text).structure.objects
    return [(o.spec.type, o.spec.placement.position, [p.action for p in o.spec.phases]) for o in objects]


@pytest.mark.parametrize("does", DOES)
@pytest.mark.parametrize(("who", "vehicle"), WHO)
def test_what_is_ones_own_is_not_egos(who: str, vehicle: str, does: str) -> None:
    before = "Ego drives at 40 km/h. "
    found = _others(f"{before}{who.capitalize()} {does}.")
    assert found == _others(f"{before}A {vehicle} {does}.") and len(found) == 1


@pytest.mark.parametrize(
    ("text", "position", "acts"),
    [
        ("A cyclist swerves into ego's lane.", "partly_in_lane", ["swerve"]),
        ("A cyclist on the right moves over in front of ego.", "partly_in_lane", ["swerve"]),
        ("A cyclist in the bike lane veers into ego's path.", "partly_in_lane", ["swerve"]),
        ("A cyclist cuts in in front of ego.", "right_lane", ["cut_in"]),
        ("A cyclist merges into the lane in front of ego.", "right_lane", ["cut_in"]),
        ("There is a cyclist in front of ego.", "ahead", []),
        ("A cyclist is on the road in front of ego.", "ahead", []),
        ("There is a woman riding a bicycle in front of ego.", "ahead", []),
        ("A cyclist appears in front of ego.", "roadside", ["cross_road"]),
    ],
)
def test_cyclists_before_ego(text: str, position: str, acts: list[str]) -> None:
    assert _others(text) == [("bicycle", position, acts)]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Ego follows a robotaxi that brakes.", "car"),
        ("Ego drives at 40 km/h. Another driverless car brakes ahead.", "car"),
        ("An autonomous truck ahead of ego brakes.", "truck"),
        ("Ego drives at 40 km/h. A company van ahead of ego brakes.", "van"),
    ],
)
def test_automated_cars_beside_ego(text: str, kind: str) -> None:
    assert _others(text) == [(kind, "ahead", ["brake"])]


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
