"""Time gaps as triggers, why somebody brakes, objects that drive, keys that tell a place, who comes between."""

import pytest


def ego(structure):
    return next(c.spec for c in structure.components if c.id == "E")


def objects(structure):
    return [o.spec for o in structure.objects]


def test_a_time_gap_that_is_kept_is_no_trigger(read) -> None:
    s = read("Ego follows the lead with a time gap of 2 s. The lead brakes.")
    assert objects(s)[0].phases[0].trigger is None
    assert objects(s)[0].placement.gap is not None


@pytest.mark.parametrize(
    "text",
    [
        "The car ahead brakes because of a child from the right.",
        "The car ahead brakes due to a cat from the left.",
        "Car in front: emergency braking due to cat from left. Ego 5 m behind.",
    ],
)
def test_why_somebody_brakes_tells_of_another_place(read, text: str) -> None:
    car, other = objects(read(text))
    assert (car.placement.position, car.phases[0].action) == ("ahead", "brake")
    assert other.placement.position == "roadside"


@pytest.mark.parametrize("text", ["An object lies on the road.", "Ego brakes for a stationary object."])
def test_an_object_that_lies_there_is_none(read, text: str) -> None:
    assert objects(read(text))[0].type == "obstacle"


def test_a_key_that_is_followed_by_a_kind(read) -> None:
    assert objects(read("Ego: car. Actor 1: white van, right lane. Actor 1 cuts in."))[0].type == "van"


def test_what_the_same_one_saw_before_is_hit(read) -> None:
    s = read("The car ahead swerves around a box in the lane and brakes. Ego sees the box too late and hits it.")
    hit = next(p.target for p in ego(s).phases if p.action == "collide")
    assert next(o.spec.type for o in s.objects if o.id == hit) == "box"


def test_one_after_another_names_nobody(read) -> None:
    cars = objects(read("Two of the four parked cars pull out in front of ego one after another."))
    assert [c.count for c in cars] == [2, 2]


def test_a_lateral_offset_is_no_lane(read) -> None:
    s = read(
        "The target vehicle stands at a lateral offset of 0.5 m to the right in the ego's lane; ego comes at 50 km/h."
    )
    assert objects(s)[0].placement.position == "ahead"


def test_what_was_meant_and_is_done_later(read) -> None:
    s = read("Ego follows a bus. The bus stops. Ego wants to pass it. Ego waits, then passes it.")
    assert [p.action for p in ego(s).phases][-2:] == ["wait", "overtake"]


def test_a_target_that_runs_from_behind_cars_crosses(read) -> None:
    s = read("The EPTc runs from behind two parked cars on the nearside at 5 km/h, VUT at 30 km/h.")
    child = next(o for o in objects(s) if o.type == "child")
    assert (child.placement.side, child.phases[0].action) == ("right", "cross_road")


def test_who_is_hidden_is_not_who_is_parked(read) -> None:
    s = read("A pedestrian is occluded by a van parked on the right and runs across.")
    van = next(o for o in objects(s) if o.type == "van")
    assert (van.placement.position, van.placement.side) == ("parked", "right")
