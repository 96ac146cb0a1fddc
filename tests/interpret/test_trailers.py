"""What is pulled and who pulls it are one road user, until the trailer comes loose."""

import pytest


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("A caravan towed by a car overtakes ego.", "car"),
        ("A horse trailer pulled by an estate car drives ahead of ego and brakes.", "car"),
        ("A trailer was being pulled by a pickup ahead of V1. V1 struck the rear of the trailer.", "truck"),
        ("Ego follows a van with a trailer. The van brakes hard and ego hits the trailer.", "van"),
        ("The SUV was hauling a camper. V1 struck the camper from behind.", "car"),
        ("A car is towing a caravan ahead of ego. The caravan starts to sway and the car brakes.", "car"),
        ("A pickup pulling a boat trailer pulls out of a driveway in front of ego.", "truck"),
        ("The trailer of the truck ahead swings into ego's lane.", "truck"),
        ("Ego follows a tractor that is pulling a hay wagon and overtakes it.", "truck"),
        ("Ego follows a truck and trailer at 60 km/h.", "truck"),
    ],
)
def test_a_trailer_and_who_pulls_it_are_one(read, text: str, kind: str) -> None:
    others = [o.spec for o in read(text).objects]
    assert [o.type for o in others] == [kind]
    assert all(p.target != "O2" for o in others for p in o.phases)


def test_it_hits_the_trailer_and_so_who_pulls_it(read) -> None:
    ego = read("Ego follows a car with a trailer. The car brakes hard and ego hits the trailer.").ego.spec
    assert [(p.action, p.target) for p in ego.phases] == [("follow", "O1"), ("collide", "O1")]


@pytest.mark.parametrize(
    "text",
    [
        "A utility trailer came loose from the pickup and stopped in ego's lane.",
        "An unattached trailer stands in ego's lane.",
        "A trailer has broken away from a van and lies across ego's lane.",
    ],
)
def test_one_that_came_loose_is_somebody_of_its_own(read, text: str) -> None:
    assert "trailer" in [o.spec.name for o in read(text).objects]
