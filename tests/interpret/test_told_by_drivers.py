"""What drivers tell of their own speed, doors that open, and people who step out in front of a vehicle."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "A boy ran into the path of a Tahoe. The driver told police he was doing 45 mph.",
        "A man stepped in front of a van. The van's driver said that he was travelling at 45 mph.",
    ],
)
def test_own_speed(read, text: str) -> None:
    scene = read(text)
    assert scene.ego.spec.speed == pytest.approx(20.12, abs=0.01)
    (person,) = (o.spec for o in scene.objects)
    assert person.speed < 3.0
    assert [p.action for p in person.phases] == ["cross_road"]


@pytest.mark.parametrize(
    ("text", "speed"),
    [
        ("Our driver in the right lane with the cruise control at 62. A van cuts in. (Speeds in mph.)", 27.72),
        ("I was on I-75 doing about 70 when a deer ran out.", 31.29),
        ("A tractor-trailer was westbound on Interstate 80 at about 60 behind an SUV. The SUV braked.", 26.82),
        ("Driver was sitting on 125 when a kangaroo hopped onto the road.", 34.72),
        ("I was in lane 1, 90 on the clock. A car cut in in front of me.", 25.0),
        ("I was sitting at 90 km/h in the middle lane when a van moved over on me.", 25.0),
    ],
)
def test_speeds_without_unit(read, text: str, speed: float) -> None:
    assert read(text).ego.spec.speed == pytest.approx(speed, abs=0.01)


@pytest.mark.parametrize("text", ["came over on me", "cut in on us"])
def test_over_on_me(read, text: str) -> None:
    (van,) = (o.spec for o in read(f"I was driving at 70 mph in the middle lane when a van {text}.").objects)
    assert [p.action for p in van.phases] == ["cut_in"]


def test_one_then_another(read) -> None:
    for text in (
        "A car comes by, then a van. When both have passed, the ego sets off from the kerb.",
        "The ego is parked. A car and a van come from behind. After both have passed, it sets off.",
    ):
        scene = read(text)
        assert [p.action for p in scene.ego.spec.phases] == ["enter_road"], text
        assert [[p.target for p in o.spec.phases] for o in scene.objects] == [["ego"], ["ego"]], text


def test_hands_and_the_hurt_are_nobody(read) -> None:
    scene = read("VUT drives at 80 km/h, driver hands resting. A van ahead brakes.")
    assert scene.ego.spec.phases == ()
    assert len(read("Two persons are light injured. A lorry hits the ego.").objects) == 1


@pytest.mark.parametrize(
    "text",
    [
        "The highway pilot shall bring the vehicle to a standstill behind a broken-down vehicle.",
        "The ADS brings the vehicle to a halt behind a broken-down vehicle.",
        "The autopilot brought the car to a stop behind a broken-down vehicle.",
    ],
)
def test_systems_bring_ego_to_a_stand(read, text: str) -> None:
    scene = read(text)
    assert [p.action for p in scene.ego.spec.phases] == ["stop"]
    assert len(scene.objects) == 1


def test_times_of_a_film(read) -> None:
    scene = read("0:22 red Mazda overtakes me, 0:26 stands on the brakes for nothing.")
    assert scene.settings.spec.time is None or scene.settings.spec.time != "night"
    assert [p.action for o in scene.objects for p in o.spec.phases] == ["overtake", "brake"]
    scene = read("0:05 a van is parked on the right; 0:08 a child runs out from behind it; 0:09 I brake hard.")
    assert scene.ego.spec.hard


def test_follows_again(read) -> None:
    text = "Ego follows a van. The van brakes to a full stop; it moves off after 4 s and the ego resumes following."
    assert [p.action for p in read(text).ego.spec.phases] == ["follow", "stop", "follow"]


def test_light_turns_green(read) -> None:
    text = (
        "The AV was first in line at a red light. When the light turned green the AV began to move, then stopped again."
    )
    assert [p.action for p in read(text).ego.spec.phases] == ["start", "stop"]


@pytest.mark.parametrize(
    "text",
    [
        "A man walked away unhurt when his pickup rolled over. The man was doing 50 mph when a deer ran out.",
        "I was riding my Honda when a deer ran out.",
        "V1, a 2019 Harley-Davidson touring motorcycle with rider and passenger, was westbound. A deer ran out.",
        "I was going down the hill when a deer ran out, and the car just carried on.",
    ],
)
def test_who_drives_is_nobody_else(read, text: str) -> None:
    scene = read(text)
    (deer,) = (o.spec for o in scene.objects)
    assert deer.type == "animal"
    wanted = "truck" if "pickup" in text else "car" if "car" in text else "motorcycle"
    assert scene.ego.spec.type == wanted


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("A lorry stands in our lane. As our nose draws level with the cab, a man walks out.", ["truck", "pedestrian"]),
        ("A motorcycle with its rider waits on the left. The ego brakes.", ["motorcycle"]),
    ],
)
def test_told_once(read, text: str, types: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == types


def test_turns_across_my_lane(read) -> None:
    for text in ("An estate turned left across my lane.", "A car turns left across the ego's path."):
        (car,) = (o.spec for o in read(text).objects)
        assert (car.placement.position, [p.action for p in car.phases]) == ("opposite_approach", ["turn_left"]), text
