"""Speeds by how much they change, and speeds by the posted limit."""

import pytest


@pytest.mark.parametrize(
    ("text", "before", "after"),
    [
        ("Ego drives at 72 km/h. The car ahead of it slows down by 30 percent.", 20, 14),
        ("Ego follows a truck at 72 km/h. The truck drops to half its speed.", 20, 10),
        ("The lead car, which drives at 72 km/h, brakes to three quarters of its speed within 3 s.", 20, 15),
        ("Ego drives at 72 km/h. The van ahead slows by 18 km/h.", 20, 15),
        ("The lead vehicle decelerates to 50% of its initial speed of 72 km/h.", 20, 10),
        ("Ego drives at 72 km/h behind a bus. The bus halves its speed.", 20, 10),
        ("The limit is 72 km/h. Ego drives at 72 km/h. The car in front brakes to a quarter of the limit.", 20, 5),
    ],
)
def test_the_speed_after_a_change(read, text, before, after):
    spec = read(text).objects[0].spec
    assert spec.speed == pytest.approx(before, abs=0.02)
    assert [p.speed for p in spec.phases if p.action == "brake"] == [pytest.approx(after, abs=0.02)]


def test_what_ego_changes_its_speed_by(read):
    spec = read("Ego reduces its speed by 18 km/h from 72 km/h when a pedestrian steps onto the crosswalk.").ego.spec
    assert spec.speed == 20 and [p.speed for p in spec.phases] == [15]


def test_faster_than_another_is_no_change(read):
    structure = read("Ego drives at 72 km/h. A van behind it is 18 km/h faster. A truck ahead brakes to 36 km/h.")
    van, truck = (c.spec for c in structure.objects)
    assert van.speed == pytest.approx(25) and [p.speed for p in truck.phases] == [10]


@pytest.mark.parametrize(
    ("text", "speed"),
    [
        ("Posted limit 35 mph. Ego follows a bus and travels no more than 5 mph below it.", 30),
        ("The limit is 50 mph; the ego drives 12 under.", 38),
        ("V1 was going 10 over the limit of 55 mph when a deer crossed.", 65),
        ("Ego drives at 5 mph below the limit, which is 40 mph here. A cyclist rides ahead.", 35),
        ("Speed limit 50 mph. The ego exceeds it by 10 mph. A police car follows.", 60),
        ("Ego drives exactly the limit of the road. The limit is 30 mph.", 30),
    ],
)
def test_egos_speed_by_the_limit(read, text, speed):
    assert read(text).ego.spec.speed == pytest.approx(speed * 0.44704, abs=0.02)


def test_who_overtakes_is_over_the_limit(read):
    spec = read("The limit here is 70 km/h. A sports car overtakes ego at 30 km/h over.").objects[0].spec
    assert spec.speed == pytest.approx(100 / 3.6, abs=0.02)


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
