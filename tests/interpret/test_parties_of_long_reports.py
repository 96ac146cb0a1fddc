"""Long reports of crashes: who drives those who tell it, whose part strikes, what is only believed or nearly done."""

import pytest


def _acts(component) -> list[str]:
    return [p.action for p in component.spec.phases or ()]


def _targets(component, action: str = "collide") -> list[str | None]:
    return [p.target for p in component.spec.phases or () if p.action == action]


def test_who_drives_somebody_off_the_road_or_walks_with_him_does_not_carry_him(read) -> None:
    assert "leave_road" in _acts(read("A van drove us off the road.").ego)
    s = read("A man crosses the road with his dog. My car hits the man.")
    assert s.objects[0].spec.type == "pedestrian"


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("The claimant's motorcycle was struck from behind by a bus.", "motorcycle"),
        ("Our insured's BMW was struck from behind by a bus.", "car"),
        ("The plaintiff's van was struck from behind by a bus.", "van"),
        ("Our policyholder was driving his Mazda. A bus collided with the rear of the Mazda.", "car"),
        ("The insured's vehicle was struck in the rear by the third party's vehicle, a coach.", "car"),
    ],
)
def test_what_a_party_of_a_claim_owns_is_that_party(read, text: str, kind: str) -> None:
    s = read(text)
    assert s.ego.spec.type == kind
    assert [o.spec.type for o in s.objects] == ["bus"]
    assert _targets(s.objects[0]) == ["ego"]


def test_the_third_party_is_what_is_named_beside_it(read) -> None:
    s = read(
        "Our insured was stationary at the lights when she was struck from behind by the third "
        "party's vehicle, a white "
        "Transit van. The third party had been following her for some time."
    )
    assert [o.spec.type for o in s.objects] == ["van"]
    assert _targets(s.objects[0]) == ["ego"]


def test_what_one_thinks_or_sees_now_is_done(read) -> None:
    assert "turn_left" in _acts(read("Ego drives at 50 km/h. I think the van ahead was turning left.").objects[0])
    s = read("V1 saw that V2 was turning left and braked.")
    assert "turn_left" in _acts(s.objects[0])


def test_what_one_nearly_does_is_not_done(read) -> None:
    s = read("V1 swerved right and nearly got around V2, but struck its rear.")
    assert "overtake" not in _acts(s.ego)
    assert "collide" in _acts(s.ego)
    assert "overtake" in _acts(read("V1 swerved right and got around V2.").ego)


def test_who_merges_and_then_brakes_is_one(read) -> None:
    s = read("Ego drives in the right lane when a black SUV merges directly in front of it and then brakes hard.")
    assert _acts(s.objects[0]) == ["cut_in", "brake"]


def test_a_move_within_the_lane_is_no_lane_change(read) -> None:
    s = read(
        "Ego is in the right lane when a van drifts towards it. Ego brakes and moves to the right within its lane."
    )
    assert "lane_change" not in _acts(s.ego)
    assert "lane_change" in _acts(read("Ego brakes and moves to the right lane.").ego)


@pytest.mark.parametrize(
    "text",
    [
        "V2 turned left across the path of V1, northbound at 40 mph.",
        "V2 turned left in front of V1, travelling north at about 40 mph.",
        "V2 turned left into the path of V1, who was heading eastbound at 40 mph.",
    ],
)
def test_the_speed_is_of_whose_heading_is_told(read, text: str) -> None:
    assert read(text).ego.spec.speed == pytest.approx(17.88, abs=0.01)
    s = read("V2 was southbound at 20 mph. " + text)
    assert [s.ego.spec.speed, s.objects[0].spec.speed] == [
        pytest.approx(17.88, abs=0.01),
        pytest.approx(8.94, abs=0.01),
    ]


def test_steering_aside_at_a_junction_is_no_turn(read) -> None:
    s = read(
        "V1 was northbound. At the intersection V2 turned left in front of V1. V1 braked and steered right but hit V2."
    )
    assert s.place.spec.manoeuvre != "right"
    assert "swerve" in _acts(s.ego)


def test_the_third_is_of_its_own_kind(read) -> None:
    s = read(
        "The first vehicle, a Vauxhall Corsa, had slowed. The second vehicle, a Volvo lorry, slowed "
        "behind it. The third, "
        "a Nissan Qashqai, ran into the back of the lorry."
    )
    assert [o.spec.type for o in s.objects] == ["truck", "car"]
    assert _targets(s.objects[1]) == ["O1"]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Ms Lee's Kia Picanto came up behind a cyclist. The Picanto struck the bicycle.", "car"),
    ],
)
def test_a_vehicle_is_called_by_its_model_alone(read, text: str, kind: str) -> None:
    s = read(text)
    assert s.ego.spec.type == kind
    assert [o.spec.type for o in s.objects] == ["bicycle"]
    assert _targets(s.ego) == ["O1"]


def test_who_comes_flying(read) -> None:
    s = read("I was starting across the intersection when this white van came flying through from the right at 50 mph.")
    assert s.objects[0].spec.speed == pytest.approx(22.35, abs=0.01)
    assert s.objects[0].spec.placement.position == "crossing_right"


def test_what_had_not_been_moving_did_not_stop_for_it(read) -> None:
    s = read("V1 was backing out. Driver 2 said that V1 had not been moving when he began to back up.")
    assert _acts(s.ego) == ["reverse"]


def test_the_wrong_way_onto_a_highway(read) -> None:
    s = read("Vehicle 1 entered the highway in the wrong direction and met Vehicle 2, which was in the left lane.")
    assert "oncoming" in _acts(s.ego)


def test_each_of_those_joined_has_the_speed(read) -> None:
    s = read("V1 was going east. V2 came towards V1. V3 was behind V1. V1 and V3 each about 30 mph.")
    assert s.ego.spec.speed == s.objects[1].spec.speed == pytest.approx(13.41, abs=0.01)


def test_one_stops_behind_who_slowed_not_behind_who_is_parked(read) -> None:
    s = read(
        "V1 was ahead of V2. V1 slowed for a pedestrian who had stepped out from behind a parked "
        "truck. V2 stopped behind it."
    )
    assert s.objects[0].spec.placement.of == "ego"


def test_codes_of_targets(read) -> None:
    s = read("TGT1 was ahead of VUT. VOI2 cut in in front of VUT. TGT1 braked.")
    assert [_acts(o) for o in s.objects] == [["brake"], ["cut_in"]]


def test_whose_relative_is_in_the_way_of_who_drives(read) -> None:
    s = read("I was driving home in my car and my wife was driving behind me. A van cut in.")
    assert s.ego.spec.type == "car"


def test_who_moves_in_a_lane_does_not_drift(read) -> None:
    s = read("The pickup moving slowly in the lane to the left of ego turned right across ego's lane.")
    assert "drift" not in _acts(s.objects[0])
    assert "drift" in _acts(read("The van ahead slowly drifts to the left over the line.").objects[0])


def test_who_has_stopped_with_an_apostrophe_stands(read) -> None:
    s = read("I'd stopped outside the school when a van hit me from behind.")
    assert s.ego.spec.speed == 0.0


def test_who_is_only_named_behind_is_not_struck(read) -> None:
    assert _targets(read("V1 hit V2 and V3 braked.").ego) == ["O1"]
    assert _targets(read("Ego hits the car between a van and a bus.").ego) == ["O1"]


def test_he_is_not_ego_after_the_others_insured(read) -> None:
    s = read(
        "I edged forward. A lorry was parked there. A pickup came past the lorry. Your insured says "
        "he was doing 30 mph."
    )
    assert s.ego.spec.speed != pytest.approx(13.41, abs=0.01)
