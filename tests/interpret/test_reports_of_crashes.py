"""Reports of crashes: who was found standing, whose car drifted, who waited to turn, lanes by number, times past."""

import pytest


def _acts(component) -> list[str]:
    return [p.action for p in component.spec.phases or ()]


@pytest.mark.parametrize(
    "text",
    [
        "The oncoming van, which wanted to turn left, moved off and I could not stop.",
    ],
)
def test_who_waits_to_turn_and_goes_turns(read, text: str) -> None:
    s = read(text)
    assert s.objects[0].spec.placement.position in ("opposite_approach", "oncoming_lane")
    assert _acts(s.objects[0])[-1] == "turn_left"


@pytest.mark.parametrize(
    "text",
    [
        "V1 was eastbound on a two-lane road. V2 was westbound. The driver of V1 dozed off and allowed his vehicle to "
        "drift across the center line, and V1 struck V2.",
        "V1 was northbound on a two-lane road. V2 was southbound on the same road. V1 drifted left over the double "
        "yellow line. The left front of V1 struck the left front of V2 in the southbound lane.",
    ],
)
def test_the_drivers_own_car_drifts_into_one_who_comes_the_other_way(read, text: str) -> None:
    s = read(text)
    assert len(s.objects) == 1
    assert s.objects[0].spec.placement.position == "oncoming_lane"
    assert _acts(s.ego)[0] in ("oncoming", "drift")
    assert _acts(s.ego)[-1] == "collide"


@pytest.mark.parametrize(
    ("text", "lanes", "lane"),
    [
        ("The freeway has five lanes each way. V1 was in the second lane from the right.", 4, "middle"),
        ("V-1 was W/B in the #2 of three W/B lanes at 40 mph.", 3, "middle"),
        ("V1 was in the #2 lane of four northbound lanes.", 4, "middle"),
        ("Our vehicle was on southbound US-101, second lane from the left of four, at 12 mph.", 4, "middle"),
        ("V1 was on a ten-lane divided freeway in the right lane.", 4, "rightmost"),
    ],
)
def test_lanes_that_are_counted(read, text: str, lanes: int, lane: str) -> None:
    place = read(text).place.spec
    assert place.lanes >= lanes
    assert place.ego_lane == lane


@pytest.mark.parametrize(
    "text",
    [
        "It was dark and V1 slid, the road wet from rain earlier in the evening.",
        "V1 hit a deer on a dark evening.",
        "It was dark when V1 hit a deer; its driver had been to a party earlier that afternoon.",
    ],
)
def test_a_time_before_is_not_that_of_the_scene(read, text: str) -> None:
    assert read(text).settings.spec.time == "night"


@pytest.mark.parametrize(
    "text",
    [
        "V1 braked for the cars lined up at the light.",
        "The vehicles ahead were backed up in the left lane because of a crash.",
    ],
)
def test_cars_that_are_backed_up_stand(read, text: str) -> None:
    assert [_acts(o) for o in read(text).objects] == [["stationary"]]


@pytest.mark.parametrize(
    "text",
    [
        "V1 underrode the rear of V2, which was stopped.",
    ],
)
def test_who_ends_up_under_another_has_hit_it(read, text: str) -> None:
    assert _acts(read(text).ego) == ["collide"]


def test_how_far_behind_one_had_stopped(read) -> None:
    s = read(
        "The AV was stopped at a red light. A Civic had stopped about two meters behind it and rolled into the AV."
    )
    assert s.objects[0].spec.placement.gap == 2.0
    assert s.objects[0].spec.speed < 5.0


@pytest.mark.parametrize(
    "text",
    [
        "V1 was northbound and pulled out to pass a tractor. V2 was southbound. V1 sideswiped V2.",
        "A southbound Camry moved left to overtake a bus and collided with a northbound truck.",
        "V1 was eastbound. It swung out to overtake a lorry and struck V2, which was westbound.",
    ],
)
def test_who_pulls_out_and_meets_another_was_in_its_lane(read, text: str) -> None:
    s = read(text)
    assert _acts(s.ego)[0] == "oncoming"
    assert _acts(s.ego)[-1] == "collide"
    assert "oncoming_lane" in [o.spec.placement.position for o in s.objects]


@pytest.mark.parametrize(
    "text",
    [
        "A lady on a bicycle came along the road. A taxi came up from behind her, went past, and turned right.",
        "A cyclist rode along the street. A taxi came up behind him, passed and turned right in front of him.",
    ],
)
def test_who_comes_up_behind_another_passes_that_one(read, text: str) -> None:
    s = read(text)
    assert _acts(s.ego) == ["overtake", "turn_right"]
    assert [o.spec.type for o in s.objects] == ["bicycle"]


@pytest.mark.parametrize(
    "text",
    [
        "Case vehicle V1 was eastbound and struck V2, which was stopped.",
        "Subject vehicle V1 was eastbound and struck V2, which was stopped.",
        "The striking vehicle, V1, was eastbound and struck V2, which was stopped.",
    ],
)
def test_one_vehicle_by_two_names(read, text: str) -> None:
    s = read(text)
    assert _acts(s.ego) == ["collide"]
    assert [o.spec.speed for o in s.objects] == [0.0]


@pytest.mark.parametrize(
    "text",
    [
        "I opened the door of my parked car and a cyclist rode straight into it.",
    ],
)
def test_who_rides_into_a_door_hits_the_car(read, text: str) -> None:
    s = read(text)
    assert [(o.spec.type, _acts(o)) for o in s.objects] == [("bicycle", ["collide"])]


@pytest.mark.parametrize(
    "text",
    [
        "A witness saw a black van change lanes and hit a silver car.",
        "He saw a black van change lanes and hit a silver car.",
    ],
)
def test_what_somebody_saw_another_do(read, text: str) -> None:
    s = read(text)
    assert (s.ego.spec.type, _acts(s.ego)) == ("van", ["lane_change", "collide"])


@pytest.mark.parametrize(
    "text",
    [
        "Vehicle 1 (2013 Toyota Prius, belted 34-year-old female) was southbound. V2, a 2017 Dodge, was northbound and "
        "turned left in front of it.",
        "V1, a 2016 Honda CR-V driven by a 71-year-old man with two passengers, was eastbound. V2, a 2008 Acura, was "
        "westbound and turned left in front of V1.",
    ],
)
def test_who_comes_the_other_way_by_the_compass(read, text: str) -> None:
    s = read(text)
    assert [(o.spec.placement.position, _acts(o)) for o in s.objects] == [("opposite_approach", ["turn_left"])]


@pytest.mark.parametrize(
    "text",
    [
        "The AV was in the left turn lane, waiting on a red arrow. Traffic in the through lanes began to move on their "
        "green. The car behind rolled forward and hit the AV.",
        "V1 was stopped at a red light. The cross traffic had their green. V2 hit V1 from behind.",
    ],
)
def test_the_green_of_others_is_not_that_of_ego(read, text: str) -> None:
    assert read(text).settings.spec.light == "red"


@pytest.mark.parametrize(
    ("text", "limit"),
    [
        ("V1 was eastbound at 35 mph (posted 25) and struck a parked car.", 11.18),
        ("V-1 was W/B at 40 mph (posted 40). V-2 braked hard ahead of V-1.", 17.88),
        ("V1 was northbound at 70 km/h (limit 50) and struck a deer.", 13.89),
    ],
)
def test_a_limit_beside_a_speed(read, text: str, limit: float) -> None:
    assert read(text).place.spec.speed_limit == limit
