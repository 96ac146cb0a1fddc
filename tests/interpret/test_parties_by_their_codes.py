"""Parties by a code of the text's own ("01 = lorry"), by their part in a suit, by a vehicle named in a head."""

import pytest

from c2s_engine.interpret.reading.spelling import Mended


def _types(s) -> list[str]:
    return [o.spec.type for o in s.objects]


def _acts(component) -> list[str]:
    return [p.action for p in component.spec.phases or ()]


def test_numbers_that_a_list_explains_are_vehicles(read) -> None:
    s = read(
        "01 = delivery van, going straight at 50 km/h. 02 = cyclist, comes from a side street on the right. "
        "01 hits 02 in the junction."
    )
    assert s.ego.spec.type == "van"
    assert _types(s) == ["bicycle"]
    assert [p.target for p in s.ego.spec.phases if p.action == "collide"] == ["O1"]


@pytest.mark.parametrize(("one", "two"), [("p1", "p2"), ("B1", "B2"), ("T1", "T2"), ("x1", "x2")])
@pytest.mark.parametrize("sign", [":", " ="])
def test_codes_beside_ego_are_other_road_users(read, one: str, two: str, sign: str) -> None:
    s = read(
        f"ego: right lane, 100 km/h | {one}{sign} truck, right lane, 60 m ahead, 80 km/h | "
        f"{two}{sign} van, left lane ahead of ego, 90 km/h, cuts in behind {one}"
    )
    assert _types(s) == ["truck", "van"]
    assert s.ego.spec.speed == pytest.approx(27.78, abs=0.1)
    assert [round(o.spec.speed, 1) for o in s.objects] == [22.2, 25.0]
    assert s.objects[1].spec.placement.position == "left_lane"


def test_what_is_told_of_two_codes_is_told_of_each(read) -> None:
    s = read(
        "# map: four-arm junction, no signals\n# host: northbound; halts at the junction, lets k1 and k2 through, then "
        "turns left\n# k1, k2: southbound vans one behind the other, 50 km/h, straight on"
    )
    assert _types(s) == ["van", "van"]
    assert "turn_left" in _acts(s.ego)
    assert {o.spec.placement.position for o in s.objects} == {"opposite_approach"}


@pytest.mark.parametrize(
    "text",
    [
        "S1: lorry, broken down, hard shoulder. S2: ego at 100 km/h.",
        "On the M1: lorry, right lane, 80 km/h. Ego: middle lane.",
        "V1: lorry, right lane, 80 km/h. V2: car, left lane.",
        "Step 2: van ahead brakes.",
    ],
)
def test_steps_roads_and_known_labels_are_no_codes(text: str) -> None:
    assert "VOI" not in Mended(text).text


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Host box truck, lane 1 of 2, 80 km/h. Car ahead brakes to a stop.", "truck"),
        ("Subject semi, right lane of two, 60 mph. Car ahead brakes to a stop.", "truck"),
        ("VEH 77 city bus / host at 30 km/h / car ahead brakes to a stop.", "bus"),
        ("I stayed behind the car in the van for a while. Then it braked.", "van"),
        ("I came up behind a car in the pickup. Then it braked.", "truck"),
    ],
)
def test_what_ego_is_told_beside_its_name(read, text: str, kind: str) -> None:
    s = read(text)
    assert s.ego.spec.type == kind
    assert _types(s) == ["car"]


def test_a_vehicle_of_the_works_behind_is_not_ego(read) -> None:
    s = read("It was the bloke in the works van behind that went into the back of me. I was doing 30 mph.")
    assert s.ego.spec.type == "car"
    assert _types(s) == ["van"]
    assert read("I was in the works van doing 40 mph when a dog ran out.").ego.spec.type == "van"


@pytest.mark.parametrize("party", ["respondent", "petitioner", "appellant", "defendant"])
def test_a_party_without_article_stays_one(read, party: str) -> None:
    s = read(
        f"The court finds that {party} was driving a truck at 40 mph; that a deer ran across the road; and that "
        f"{party}, who was eating, struck the deer."
    )
    assert s.ego.spec.type == "truck"
    assert _types(s) == ["animal"]
    assert "collide" in _acts(s.ego)


@pytest.mark.parametrize(
    "text",
    [
        "The defendant's van turned right into Mill Street. The claimant was crossing the mouth of it on foot. "
        "The van knocked her down.",
        "The defendants' van turned right. The claimant was then on the pedestrian crossing over the side road. "
        "The front corner of the van knocked him down.",
    ],
)
def test_a_claimant_on_foot_is_hit_by_the_defendant(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.type == "van"
    assert _types(s) == ["pedestrian"]
    assert s.objects[0].spec.count == 1
    assert _acts(s.ego)[-1] == "collide"


def test_the_name_of_a_house_is_no_animal(read) -> None:
    s = read(
        "Mrs Hale left the Red Lion on foot at 11 pm and walked along the left-hand edge of the lane. Mr Finn's van "
        "came up behind her at 40 mph. He did not see her and the front corner of the van struck her."
    )
    assert s.ego.spec.type == "van"
    assert _types(s) == ["pedestrian"]
    assert _acts(s.ego) == ["collide"]
    assert "animal" in _types(read("Ego drives at 40 km/h and a fox runs across the road from the left."))


@pytest.mark.parametrize(
    "text",
    [
        '"Look twice" is what I tell every pupil. I was going at 40 km/h when a bus in front of me braked.',
        "Assumption A1: children run no faster than 3 m/s. Ego follows a bus at 40 km/h. The bus brakes.",
        "A rule for every learner. I was going at 40 km/h when a bus in front of me braked.",
    ],
)
def test_all_of_a_kind_are_not_there(read, text: str) -> None:
    assert _types(read(text)) == ["bus"]


def test_another_beside_ego_is_whom_the_title_names(read) -> None:
    s = read(
        "Type 9. Vehicle leaving a parking space. The subject vehicle goes straight at 40 km/h. Another vehicle, "
        "parked at the right-hand kerb, pulls out in front of it."
    )
    assert len(s.objects) == 1
    assert len(read("A vehicle overtakes ego. Another vehicle follows.").objects) == 2


def test_who_runs_after_a_ball_crosses(read) -> None:
    s = read("A ball rolled out between the cars parked on the right. A child came running after it. Ego stopped.")
    assert s.objects[1].spec.placement.position != "partly_in_lane"
    assert _acts(s.objects[1])[-1] == "cross_road"


@pytest.mark.parametrize("where", ["onto the hard shoulder", "onto the grass verge"])
@pytest.mark.parametrize("verb", ["pulls over", "moves over", "draws"])
def test_over_to_a_side_onto_the_shoulder_is_off_the_road(read, verb: str, where: str) -> None:
    s = read(f"In fog the AV slows, {verb} to the right {where} and stops there.")
    assert [(p.action, p.side) for p in s.ego.spec.phases if p.side] == [("leave_road", "right")]


def test_traffic_that_had_backed_up_stands(read) -> None:
    s = read("The truck was going 65 mph. Traffic had backed up. The truck struck the last car in the queue.")
    assert "reverse" not in [a for o in s.objects for a in _acts(o)]
    assert "reverse" in _acts(read("The lorry ahead backed up and I braked.").objects[0])


@pytest.mark.parametrize(
    "text",
    [
        "Vehicle 01, a lorry, turned left there. Its driver overlooked the motorcycle (02) coming the other way."
        " 02 struck the side of 01.",
        "Participant 01 drove a lorry and turned left. He overlooked participant 02, a motorcycle coming the other way."
        " 02 struck the side of 01.",
    ],
)
def test_bare_numbers_of_participants_are_theirs(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.type == "truck"
    assert _types(s) == ["motorcycle"]
    assert _acts(s.objects[0])[-1] == "collide"
