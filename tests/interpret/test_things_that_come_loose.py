"""Wheels and loads that come off, doors that open, who does not come onto the road, and who makes way."""

import pytest


def _objects(structure) -> dict:
    return {o.spec.type: o.spec for o in structure.objects}


@pytest.mark.parametrize(
    "text", ["The right wheel of the van ahead hits the kerb.", "The rear door of the van is green."]
)
def test_a_part_that_stays_is_none(read, text: str) -> None:
    assert "debris" not in _objects(read(text))


def test_where_a_thing_falls(read) -> None:
    assert read("A tree falls onto the road 50 m ahead of ego.")["O1"].spec.placement.gap == 50
    objects = _objects(read("Boxes fall off a truck into the right lane. Ego is in the left lane."))
    assert objects["box"].placement.position == "right_lane"


def test_a_vehicle_in_a_queue_is_not_parked_by_its_door(read) -> None:
    text = "A van stops at the red light ahead of ego and its passenger opens the door."
    assert _objects(read(text))["van"].placement.position == "ahead"


@pytest.mark.parametrize("text", ["No pedestrian crosses the road.", "Pedestrians do not cross the motorway."])
def test_nobody_stands_where_nobody_is_meant(read, text: str) -> None:
    assert not read(f"Ego follows a van at 50 km/h. {text}").objects[1:]
