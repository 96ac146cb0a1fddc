"""Incident reports of many kinds: headlines before the story, damage, doors, plates, claims, witnesses, chains."""

import pytest


def actions(spec) -> list[str]:
    return [p.action for p in spec.phases]


def others(structure) -> list:
    return [o.spec for o in structure.objects]


@pytest.mark.parametrize(
    "text",
    [
        "The plaintiff was waiting at a crossing to let a woman cross when a van hit the rear of her vehicle.",
    ],
)
def test_the_vehicle_that_is_hit_is_not_that_of_one_on_foot(read, text: str) -> None:
    s = read(text)
    walker, van = others(s)
    assert (walker.type, van.type, s.ego.spec.speed) == ("pedestrian", "van", 0)
    assert (van.placement.position, van.placement.of) == ("behind", "ego")
    assert van.phases[-1].action == "collide" and van.phases[-1].target == "ego"


def test_a_vehicle_of_one_on_foot_stays_hers(read) -> None:
    s = read("A woman was hurt when her car left the road and hit a tree.")
    assert "pedestrian" not in [o.type for o in others(s)]


def test_a_first_sentence_with_articles_is_no_headline(read) -> None:
    s = read("A bus drives on a road. A car followed the bus. A second car overtook both.")
    assert len(others(s)) >= 2


def test_somebody_else_is_none_of_those_who_met(read) -> None:
    s = read("Two cars collided at the junction. A pedestrian stood on the sidewalk.")
    assert "pedestrian" in [o.type for o in others(s)]


def test_who_pulls_over_does_so(read) -> None:
    assert actions(read("The van ahead pulled over to the side of the road.").objects[0].spec) != ["stationary"]


@pytest.mark.parametrize(
    "text",
    [
        "My client's vehicle and a taxi registration KX12 ABC collided when the taxi emerged from a side road.",
        "Our client's car and a taxi, reg. no. SKA 1234, collided when the taxi emerged from a side road.",
        "My client's car and a taxi bearing licence plate 4-ABC-22 collided when the taxi came out of a side road.",
    ],
)
def test_plates_are_passed_over(read, text: str) -> None:
    s = read(text)
    assert [o.placement.position for o in others(s)] == ["crossing_left"] and "collide" in actions(s.ego.spec)


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("I hit a parked car because a child ran out in front of me and I had to swerve.", ["swerve", "collide"]),
        
        
        
    ],
)  # fmt: skip
def test_what_led_to_the_blow_comes_first(read, text: str, order: list[str]) -> None:
    assert actions(read(text).ego.spec) == order


def test_potholes_are_nobody(read) -> None:
    s = read("A motorcycle in front of me suddenly fell after hitting a pothole.")
    assert actions(others(s)[0]) == ["lose_control"]


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("V-1 was northbound. P-1 was walking across the street. V-1 struck P-1.", ["pedestrian"]),
    ],
)
def test_parties_by_their_letters(read, text: str, kinds: list[str]) -> None:
    assert [o.type for o in others(read(text))] == kinds


def test_witnesses_report(read) -> None:
    s = read("Witness 2 states that the black Mercedes overtook two cars on a solid line and met the school bus.")
    assert actions(s.ego.spec) == ["overtake"] and [o.count for o in others(s)] == [2, 1]


def test_stopped_ahead_in_notes_is_a_state(read) -> None:
    car = others(read("V1 NB in #2 lane, V2 stopped ahead, V1 struck rear of V2."))[0]
    assert (car.speed, actions(car)) == (0, ["stationary"])


def test_it_was_there_before_it_was_told(read) -> None:
    s = read("A child was hit as he crossed behind the ice-cream van. The car that hit him was doing 20 mph.")
    assert s.ego.spec.type == "car" and actions(s.ego.spec) == ["collide"]


@pytest.mark.parametrize(
    "name",
    [
        "Veh #",
    ],
)
def test_numbers_with_a_sign(read, name: str) -> None:
    s = read(
        f"{name}1 was northbound. {name}2 was southbound and turned left in front of {name}1. {name}1 hit {name}2."
    )
    assert actions(s.ego.spec) == ["collide"] and others(s)[0].placement.position == "opposite_approach"


def test_letters_at_the_end_and_corners(read) -> None:
    s = read("Vehicle A ran a red light. Vehicle B had a green light. The front right of B hit the rear left of A.")
    assert actions(others(s)[0])[-1] == "collide" and others(s)[0].phases[-1].target == "ego"


def test_a_participle_before_by_in_notes(read) -> None:
    s = read("Bus braked, pedestrian hit by front left corner.")
    assert (s.ego.spec.type, s.ego.spec.phases[-1].action) == ("bus", "collide")


@pytest.mark.parametrize("text", ["V1 follows V2. V2 braked to avoid a dog.", "V2 stopped to avoid a dog. V1 hit V2."])
def test_who_brakes_to_avoid_does_not_swerve(read, text: str) -> None:
    car, dog = others(read(text))
    assert len(car.phases) == 1 and car.phases[0].action in ("brake", "stop")
    assert (dog.type, dog.placement.of) == ("animal", "O1")


def test_who_swerves_to_avoid_swerves(read) -> None:
    car, cyclist = others(read("V1 follows V2. V2 swerved to avoid a cyclist."))
    assert actions(car) == ["swerve"] and cyclist.placement.of == "O1"


def test_ego_by_what_it_was_said_to_be(read) -> None:
    s = read(
        "The subject vehicle, a tow truck, was standing on the shoulder. A semi moved over. An SUV hit the tow truck."
    )
    assert others(s)[-1].phases[-1].target == "ego"
