"""What typologies, test procedures and prompts say in ways of their own."""

from typing import Any

import pytest

from c2s_engine.structure.components import Structure


def spec(structure: Structure, cid: str) -> Any:
    return structure[cid].spec


def acts(structure: Structure, cid: str) -> list[str]:
    return [p.action for p in spec(structure, cid).phases]


def named(structure: Structure, name: str) -> Any:
    return next(c.spec for c in structure.objects if name in c.spec.name)  # type: ignore[union-attr]


@pytest.mark.parametrize(
    "text",
    [
        "Lead car brakes hard on a foggy freeway, ego must avoid a rear-end collision.",
        "The truck ahead brakes hard, ego has to avoid hitting it.",
        "A van ahead of the host brakes hard in the rain, the host must avoid it.",
    ],
)
def test_what_is_told_before_is_not_what_is_avoided(read, text: str) -> None:
    assert acts(read(text), "O1") == ["brake"]


@pytest.mark.parametrize(
    ("text", "first"),
    [
        ("Vehicle is backing out of a driveway and then strikes a car passing along the street.", "reverse"),
        ("Vehicle is pulling away from the right-hand curb and moves into the path of another vehicle.", "enter_road"),
        ("Vehicle is leaving a parked position and encroaches upon another vehicle in the same lane.", "enter_road"),
        ("Turning left at an intersection: vehicle crosses the path of an oncoming car.", "turn_left"),
    ],
)
def test_the_bare_vehicle_of_a_typology_is_ego(read, text: str, first: str) -> None:
    s = read(text)
    assert acts(s, "E")[0] == first
    assert len(s.objects) == 1


@pytest.mark.parametrize(
    "text",
    [
        "The VUT is put in reverse and rolls back. A child dummy stands motionless 6 m behind the rear bumper.",
        "Ego shifts into reverse and backs toward a pedestrian standing 6 m behind it.",
        "The SV selects reverse gear and moves backwards. A child stands 6 m behind the SV.",
    ],
)
def test_people_behind_one_that_reverses(read, text: str) -> None:
    s = read(text)
    assert acts(s, "E")[0] == "reverse"
    assert spec(s, "O1").placement.position == "behind"
    assert spec(s, "O1").placement.gap == 6


@pytest.mark.parametrize(
    ("text", "lane"),
    [
        ("Ego follows a truck at 80 km/h, both in the left lane of a motorway.", "leftmost"),
        ("Ego and a taxi drive one behind the other. Both are in the right lane.", "rightmost"),
        ("Ego v = 30 m/s, lead SUV v = 30 m/s, time headway 1.2 s, both in the left lane of a motorway.", "leftmost"),
    ],
)
def test_a_lane_that_ego_shares(read, text: str, lane: str) -> None:
    s = read(text)
    assert spec(s, "R").ego_lane == lane
    assert spec(s, "O1").placement.position == "ahead"


def test_both_cars_before_they_are_named(read) -> None:
    s = read("Both cars do 72 km/h. From its own lane the VUT drifts to the left towards the oncoming GVT.")
    assert [spec(s, c).speed for c in ("E", "O1")] == [20, 20]
    assert spec(s, "O1").placement.position == "oncoming_lane"


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("The VUT is steered by the robot across the lane marking to the left.", "left"),
        ("The SV is steered to the right towards the road edge at 0.3 m/s.", "right"),
    ],
)
def test_who_is_steered_over_a_line_drifts(read, text: str, side: str) -> None:
    phase = spec(read(text), "E").phases[0]
    assert (phase.action, phase.side) == ("drift", side)


@pytest.mark.parametrize(
    ("text", "gap"),
    [
        ("Ego drives at 60 km/h with a van right on its tail.", None),
        ("A pickup is glued to the ego's tail.", None),
    ],
)
def test_who_is_at_egos_tail(read, text: str, gap: float | None) -> None:
    placement = spec(read(text), "O1").placement
    assert (placement.position, placement.gap) == ("behind", gap)


@pytest.mark.parametrize(
    "text",
    [
        "Ego follows a bus. A motorcycle behind ego pulls out to the left and overtakes both.",
        "The host drives behind a tractor. A van following the host pulls out and goes past both.",
    ],
)
def test_who_overtakes_both(read, text: str) -> None:
    s = read(text)
    last = max(s.objects, key=lambda c: "overtake" in acts(s, c.id))
    assert last.spec.placement.position == "behind"  # type: ignore[union-attr]
    assert next(p for p in spec(s, last.id).phases if p.action == "overtake").target == "ego"


# type: ignore[union-attr]


@pytest.mark.parametrize(
    "text",
    [
        "A cyclist comes along the path from ego's right and is hidden until late by a van parked beside the exit.",
        "A child is concealed at first behind a parked truck and then runs onto the road.",
        "A pedestrian, out of sight behind a parked bus at first, walks from the right.",
        "In the right lane a truck has stopped; a pedestrian walks from the right and comes into ego's view only as "
        "she passes the truck's front end.",
    ],
)
def test_who_is_hidden_for_a_time(read, text: str) -> None:
    s = read(text)
    seen = next(c.spec for c in s.objects if c.spec.type in ("bicycle", "child", "pedestrian"))  # type: ignore[union-attr]
    assert spec(s, seen.placement.hidden_by).type in ("van", "truck", "bus")


@pytest.mark.parametrize(
    "text",
    [
        "Three pupils walk across. Ego waits even when every child is across.",
        "Two cyclists cross the road from the right. Each cyclist is hidden by a parked van.",
    ],
)
def test_every_one_of_several_is_no_new_one(read, text: str) -> None:
    s = read(text)
    assert sum(c.spec.type in ("child", "bicycle", "pedestrian") for c in s.objects) == 1  # type: ignore[union-attr]


@pytest.mark.parametrize(
    "text",
    [
        "A van is coming the other way, so ego stays behind the riders; with the van gone it overtakes the riders.",
        "Ego follows a cyclist because a van comes the other way; once the van has passed, it overtakes the cyclist.",
    ],
)
def test_who_is_gone_does_not_act_then(read, text: str) -> None:
    assert "overtake" in acts(read(text), "E")


def test_with_another_behind_it(read) -> None:
    s = read("There is a bus at 50 km/h ahead of ego with a motorcycle 10 m behind it.")
    bus, bike = named(s, "bus"), named(s, "motorcycle")
    assert bus.placement.gap is None
    assert (bike.placement.of, bike.placement.gap) == ("O1", 10)


def test_a_speed_in_egos_lane_is_not_egos(read) -> None:
    s = read("Four cyclists in a bunch, two abreast, in the ego's lane at 30 km/h.")
    assert spec(s, "O1").speed == pytest.approx(8.33)


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Ego drives on a motorway. Someone is going the wrong way, 300 m off.", "car"),
        ("Ego drives in the right lane when somebody in the left lane brakes hard.", "car"),
        ("Someone walks across the road ahead of ego.", "pedestrian"),
    ],
)
def test_somebody_at_the_wheel(read, text: str, kind: str) -> None:
    assert spec(read(text), "O1").type == kind


@pytest.mark.parametrize(
    "text",
    [
        "The challenger overtakes ego and cuts in. A truck in front of the challenger is not part of this scenario.",
        "A car cuts in ahead of ego. Pedestrians are not considered in this scenario.",
        "A car cuts in ahead of ego. Oncoming traffic is out of scope.",
    ],
)
def test_who_is_no_part_of_it(read, text: str) -> None:
    assert len(read(text).objects) == 1


@pytest.mark.parametrize(
    ("text", "action"),
    [
        ("An ambulance comes from behind on a country road. Ego makes room for it.", "swerve"),
    ],
)
def test_room_for_one_from_behind(read, text: str, action: str) -> None:
    s = read(text)
    assert spec(s, "O1").placement.position == "behind"
    assert action in acts(s, "E") or spec(s, "E").reaction == "yield"


def test_who_lets_another_cross_turns_then(read) -> None:
    s = read("At the junction ego must let the cyclist cross before it turns right.")
    assert acts(s, "E") == ["turn_right"]
    assert "turn_right" not in acts(s, "O1")


def test_lanes_that_are_filled(read) -> None:
    s = read("Ego runs in the leftmost of three lanes while the other two are filled with slower vehicles.")
    assert (spec(s, "O1").placement.position, spec(s, "O1").count) == ("right_lane", 2)


# type: ignore[union-attr]


@pytest.mark.parametrize(
    ("text", "distance"),
    [
        ("The ego starts 50 m from the intersection and drives at 40 km/h. A car runs the red light.", 50),
        ("Ego spawns 80 m before the crosswalk. A pedestrian crosses from the right.", 80),
        ("Ego stops 20 m before the crosswalk because a pedestrian crosses.", None),
        ("When ego is 30 m from the intersection, a car runs the red light from the left.", None),
    ],
)
def test_how_far_the_place_is(read, text: str, distance: float | None) -> None:
    assert spec(read(text), "R").distance == distance


@pytest.mark.parametrize(
    ("text", "who", "of"),
    [
        (
            "A van is parked on the right. When the cyclist is 10 m from the van, it swerves to the left.",
            "cyclist",
            "van",
        ),
        (
            "Ego drives behind a taxi. When the taxi is 12 m from the parked bus, it swerves to the left.",
            "taxi",
            "bus",
        ),
        ("A child runs onto the road when ego is 15 m away.", "child", None),
    ],
)
def test_to_whom_the_distance_of_a_trigger_is(read, text: str, who: str, of: str | None) -> None:
    s = read(text)
    trigger = next(p.trigger for p in named(s, who).phases if p.trigger is not None)
    assert (spec(s, trigger.of).name if trigger.of else None) == of


@pytest.mark.parametrize(
    "text",
    [
        "A parked car pulls out with 2 m/s2 as soon as the ego's TTC to it is under 3 s.",
        "A parked car pulls out as soon as the TTC of ego to it falls below 3 s.",
        "A parked car pulls out when the time to collision between ego and the car is 3 s.",
    ],
)
def test_a_time_to_collision_with_parties(read, text: str) -> None:
    trigger = spec(read(text), "O1").phases[0].trigger
    assert (trigger.kind, trigger.value) == ("ttc", 3)


@pytest.mark.parametrize(
    "text",
    [
        "Actors: (a) farm tractor ahead in the same lane, 25 km/h, gap 120 m; (b) oncoming motorcycle, 90 km/h.",
        "Objects: (1) a tractor ahead in the same lane at 25 km/h; (2) an oncoming motorcycle at 90 km/h.",
    ],
)
def test_lists_of_actors(read, text: str) -> None:
    s = read(text)
    assert [c.spec.type for c in s.objects] == ["truck", "motorcycle"]  # type: ignore[union-attr]
    assert [round(c.spec.speed, 1) for c in s.objects] == [6.9, 25.0]  # type: ignore[union-attr]


def test_at_the_same_speed_as_the_one_beside(read) -> None:
    s = read("Ego drives at 60 km/h. A bus drives at 50 km/h with a car 10 m behind it at the same speed.")
    assert named(s, "car").speed == named(s, "bus").speed == pytest.approx(13.89)


@pytest.mark.parametrize(
    "text",
    [
        "The lead vehicle decelerates suddenly to a speed of 2 m/s.",
        "The lead vehicle brakes down to a constant speed of 2 m/s.",
        "The lead vehicle slows to a velocity of 2 m/s.",
    ],
)
def test_a_speed_that_is_reached(read, text: str) -> None:
    lead = spec(read(text), "O1")
    assert lead.phases[0].speed == 2
    assert lead.speed > 5


@pytest.mark.parametrize(
    "text",
    [
        "The SV approaches a stationary POV; the test ends when the SV hits the POV.",
        "Ego follows a car that brakes. The run is over if ego hits the car.",
        "A pedestrian crosses ahead of ego. The scenario terminates once ego hits the pedestrian.",
    ],
)
def test_what_ends_the_test_does_not_happen_in_it(read, text: str) -> None:
    assert "collide" not in acts(read(text), "E")


def test_who_runs_on_after_a_clause_of_time(read) -> None:
    s = read("A pedestrian emerges from behind a bus stop when the ego is 15 meters away and runs across at 3 m/s.")
    walker = spec(s, "O1")
    assert (walker.speed, walker.phases[0].trigger.value) == (3, 15)


@pytest.mark.parametrize(
    "text",
    [
        "A car from the left has stopped at the line of the crossroads. Ego lets the car make its left turn.",
        "A child stands behind the SV, 4 m from it; the SV, a van, moves backwards.",
        "A ball rolls out between two parked cars on the left, followed by a child.",
    ],
)
def test_nobody_is_lost(read, text: str) -> None:
    assert read(text).objects


def test_a_ball_followed_by_a_child(read) -> None:
    s = read("A ball rolls out between two parked cars on the left followed by a child.")
    assert [p.action for p in named(s, "child").phases] == ["cross_road"]


# type: ignore[union-attr]


def test_ego_that_starts_in_a_lane(read) -> None:
    s = read("Three lanes. Ego starts in the right lane at 50 km/h and has to merge into the middle lane.")
    assert spec(s, "R").ego_lane == "rightmost"


def test_two_cars_that_collide_ahead(read) -> None:
    s = read("Two cars collide ahead of ego.")
    assert spec(s, "O1").placement.position == "ahead"
    assert acts(s, "O1") == ["stop"]


@pytest.mark.parametrize(
    "text",
    [
        "The ego vehicle should detect the broken down truck blocking its lane and pass it.",
        "The host should notice a van parked in its lane and overtake it.",
        "The ego shall see the child standing at the kerb and slow down.",
    ],
)
def test_what_ego_shall_see_and_do(read, text: str) -> None:
    s = read(text)
    assert not {"overtake", "brake"} & set(acts(s, "O1"))


@pytest.mark.parametrize(
    "text",
    [
        "Ego approaches a truck at 80 km/h, which is stationary.",
    ],
)
def test_which_is_the_noun_right_before(read, text: str) -> None:
    s = read(text)
    assert acts(s, "O1") == ["stationary"]
    assert not acts(s, "E")


def test_a_heading_is_nobody(read) -> None:
    s = read("T-junction. Actors: ego going straight at 50 km/h, car waiting on the minor road to turn left.")
    assert len(s.objects) == 1


def test_the_clause_of_time_behind_the_last_noun(read) -> None:
    s = read("The pedestrian starts crossing from the left when the ego is 40 m away.")
    assert spec(s, "O1").phases[0].trigger.value == 40
