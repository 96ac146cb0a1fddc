"""Reports by drivers, operators and officers: whose vehicle is told of, what only says when, what was over before."""

import pytest


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Fleet note. Van 12, A4 westbound, 50 mph. A car ahead of me stopped dead and I hit it.", "van"),
    ],
)
def test_the_writers_own_vehicle(read, text: str, kind: str) -> None:
    s = read(text)
    assert s.ego.spec.type == kind
    assert all(o.spec.type != kind for o in s.objects)


@pytest.mark.parametrize(
    "text",
    [
        "White van, no indicators, pulled straight out in front of me. I braked hard.",
        "I was driving home. Truck ahead of me lost its load. I swerved.",
        "Lorry in front of me braked suddenly. I stopped in time.",
    ],
)
def test_another_vehicle_without_an_article(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.type == "car" and s.objects[0].spec.type in ("truck", "van")


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("A 46-year-old man escaped with bruises when his pickup struck a cow.", "truck"),
        ("A teenager died when his motorcycle collided with a van.", "motorcycle"),
        ("A woman was hurt when her car left the road and hit a tree.", "car"),
    ],
)
def test_a_person_and_his_vehicle_are_one(read, text: str, kind: str) -> None:
    s = read(text)
    assert s.ego.spec.type == kind and len(s.objects) == 1


def test_a_man_beside_his_van_is_not_in_it(read) -> None:
    assert read("A man loading his van was hit by a car.")["O1"].spec.type == "pedestrian"


@pytest.mark.parametrize(
    "when",
    ["On May 14 at 2:37 PM", "On March 6 at 5:12 PM PT", "At 6:05 p.m.", "On June 3, 2022 at approximately 10:15 AM"],
)
def test_a_date_is_no_subject(read, when: str) -> None:
    s = read(f"{when} a Lumeno AV was stopped at a red light behind a white sedan when a pickup struck it.")
    assert [p.action for p in s.ego.spec.phases] == ["stationary"]
    assert s["O1"].spec.speed == 0.0 and [p.target for p in s["O2"].spec.phases] == ["ego"]


@pytest.mark.parametrize(
    "text",
    [
        "V1 was northbound on Oak, V2 eastbound on Kell. V1 ran the stop sign and struck V2. I checked the sign.",
        "Unit 1 rear-ended Unit 2. I spoke with D1 at the scene.",
        "Vehicle 1 followed Vehicle 2. Vehicle 1 hit its rear, I found no skid marks.",
    ],
)
def test_the_officer_is_nobody_on_the_road(read, text: str) -> None:
    s = read(text)
    assert len(s.objects) == 1 and s.ego.spec.phases[-1].target == "O1"


def test_what_the_writer_did_at_last(read) -> None:
    s = read("A red car cut in from the left. A bus was next to me on the right. Stood on the brakes.")
    assert s.ego.spec.hard and all(p.action != "brake" for o in s.objects for p in o.spec.phases)


@pytest.mark.parametrize(
    "text",
    [
        "V1 crossed the centerline and struck the front of a northbound pickup head-on.",
        "A pickup going south crossed the center line and hit a minivan head-on.",
        "The van crossed the centre line and hit a lorry head-on.",
    ],
)
def test_hit_head_on(read, text: str) -> None:
    s = read(text)
    assert [p.action for p in s.ego.spec.phases] == ["oncoming", "collide"]
    assert s["O1"].spec.placement.position == "oncoming_lane"


def test_past_and_across_the_bows(read) -> None:
    s = read("A silver compact came past me on the left and cut directly across my front.")
    assert [p.action for p in s["O1"].spec.phases] == ["overtake", "cut_in"]


def test_no_room_is_no_giving_way(read) -> None:
    s = read("A car cut in front of me. I could not go left because there was a bus next to me. I braked.")
    assert "turn_left" not in [p.action for p in s.ego.spec.phases] and s.ego.spec.reaction == "brake"


def test_a_lane_by_its_number_is_nobody(read) -> None:
    s = read("V1 was northbound. V2, a Jeep, was southbound in the second through lane. V1 turned left and V2 hit it.")
    assert len(s.objects) == 1


def test_a_light_that_went_yellow(read) -> None:
    s = read("The AV was 40 m from the stop line when the light went yellow. The AV stopped.")
    assert s.settings.spec.light == "yellow" and s.place.spec.control == "signal"
