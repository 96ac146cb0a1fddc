"""Speeds by how much they change, and speeds by the posted limit."""

import pytest


def test_faster_than_another_is_no_change(read):
    structure = read("Ego drives at 72 km/h. A van behind it is 18 km/h faster. A truck ahead brakes to 36 km/h.")
    van, truck = (c.spec for c in structure.objects)
    assert van.speed == pytest.approx(25) and [p.speed for p in truck.phases] == [10]


@pytest.mark.parametrize(
    ("text", "speed"),
    [
        ("Ego drives exactly the limit of the road. The limit is 30 mph.", 30),
    ],
)
def test_egos_speed_by_the_limit(read, text, speed):
    assert read(text).ego.spec.speed == pytest.approx(speed * 0.44704, abs=0.02)


def test_under_and_over_of_places_are_no_speeds(read):
    structure = read("The speed limit is 50 km/h. The truck passes under a bridge at 36 km/h. Ego follows it.")
    assert structure.objects[0].spec.speed == 10


@pytest.mark.parametrize(
    "text",
    [
        "A van in the left lane drives at the same speed as ego, 72 km/h, and cuts in.",
        "A bus comes towards ego as fast as ego. Ego drives at 72 km/h.",
        "Ego drives at the same speed as the truck ahead. The truck drives at 72 km/h.",
    ],
)
def test_the_same_speed_as_another(read, text):
    structure = read(text)
    assert (structure.ego.spec.speed, structure.objects[0].spec.speed) == (20, 20)
