"""What judges and coroners say, who drives what beside a party, passengers of automated vehicles, where one steers."""

import pytest


def _types(s) -> list[str]:
    return [o.spec.type for o in s.objects]


def _acts(component) -> list[str]:
    return [p.action for p in component.spec.phases or ()]


@pytest.mark.parametrize(
    "says",
    [
        "I am satisfied that the lights of the van were on.",
    ],
)
def test_who_judges_is_not_at_the_wheel(read, says: str) -> None:
    s = read(f"The van hit a man who was walking along the right edge of the lane at night. {says}")
    assert s.ego.spec.type == "van"
    assert _types(s) == ["pedestrian"]
    assert _acts(s.ego) == ["collide"]


def test_who_drives_and_finds_fault_is_ego(read) -> None:
    s = read(
        "I was driving home at 40 mph when a van pulled out. I do not accept that I was too fast. I braked but hit it."
    )
    assert s.ego.spec.type == "car"
    assert _types(s) == ["van"]


@pytest.mark.parametrize(
    ("who", "kind", "speed"),
    [
        ("A man, driving his van at 40 mph,", "van", 17.88),
    ],
)
def test_who_drives_something_of_his_own_is_another(read, who: str, kind: str, speed: float) -> None:
    s = read(f"A lorry was turning right out of Mill Lane. {who} came from the left and was struck by the lorry.")
    assert s.ego.spec.type == "truck"
    assert _types(s) == [kind]
    assert s.objects[0].spec.speed == pytest.approx(speed, abs=0.1)


def test_the_wheel_to_the_wrong_side(read) -> None:
    s = read(
        "Our bus was at 60 kmph. The driver cut the steering to the wrong side and hit a van coming from the front."
    )
    assert _acts(s.ego) == ["oncoming", "collide"]


def test_two_that_meet_face_to_face_collide(read) -> None:
    s = read("I was on my scooter at 40 kmph. A van was coming from the front on the wrong side. We met face to face.")
    assert "collide" in _acts(s.ego) + _acts(s.objects[0])
    s = read("I came face to face with a van on the wrong side and braked.")
    assert "collide" not in _acts(s.ego) + [a for o in s.objects for a in _acts(o)]


def test_on_to_the_verge_is_off_the_road(read) -> None:
    s = read(
        "V2 was overtaking a lorry coming the other way. V1 steered on to the verge. The lorry remained at the scene."
    )
    assert _acts(s.ego) == ["leave_road"]
    assert "stationary" not in _acts(s.objects[1])


def test_a_verb_after_a_relative_clause_with_a_lane(read) -> None:
    s = read(
        "The bus that had approached from behind in the left lane strayed gradually over the line and brushed the AV."
    )
    assert _acts(s.objects[0]) == ["drift", "collide"]


def test_whoever_uses_that_lane_is_in_it(read) -> None:
    s = read(
        "In the right of two lanes the AV changes to the left lane. A van using that lane is forced into hard braking."
    )
    assert s.objects[0].spec.placement.position == "left_lane"
    assert _acts(s.objects[0]) == ["brake"]
    assert not s.ego.spec.hard


def test_across_both_lanes_from_the_kerb(read) -> None:
    s = read(
        "The claimant was driving at 30 mph and the defendant's van was parked at the kerb. The van swung out from the "
        "kerb and across both lanes of the two-way road and the claimant ran into it."
    )
    assert s.objects[0].spec.placement.position == "parked"
    assert _acts(s.objects[0]) == ["enter_road"]
