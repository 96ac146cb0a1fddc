"""Verbs of the manner of going, past tenses that look like participles, other words for the same deed."""

import pytest

WAYS = {  # a place and way, told with a plain verb: subject -> what follows the verb
    "comes": [
        "out of a side street on the left",
        "through from the right",
        "past us on the left",
        "around the bend towards us",
        "off the road",
        "into the back of us",
        "out of a driveway on the right",
    ],
}
MANNERS = ["blasts", "thunders", "zips", "rockets", "hurtles", "charges", "screeches", "lumbers", "scoots", "powers"]
PAST = [
    ("a taxi", "sweeps past us on the left", "swept past us on the left"),
    ("an Audi", "spins in front of us", "spun in front of us"),
    ("a motorbike", "darts across in front of us", "darted across in front of us"),
    ("a van", "veers into our lane", "veered into our lane"),
    ("a scooter", "filters past us on the right", "filtered past us on the right"),
]


def told(read, text: str) -> list[tuple]:
    specs = (o.spec for o in read(text).objects)
    return [(s.type, s.placement.position, s.placement.side, [p.action for p in s.phases]) for s in specs]


@pytest.mark.parametrize("manner", MANNERS)
def test_a_manner_of_going_is_going(read, manner: str) -> None:
    for verb, ways in WAYS.items():
        for way in ways:
            plainly = told(read, f"We were driving along. A car {verb} {way}.")
            assert plainly and told(read, f"We were driving along. A car {manner} {way}.") == plainly, way


@pytest.mark.parametrize(("who", "now", "past"), PAST)
def test_a_past_tense_is_no_participle(read, who: str, now: str, past: str) -> None:
    capital = who[0].upper() + who[1:]
    plainly = told(read, f"{capital} {now}.")
    assert plainly
    assert told(read, f"{capital} {past}.") == plainly
    assert told(read, f"Out of nowhere {who} {past}.") == told(read, f"Out of nowhere {who} {now}.")


@pytest.mark.parametrize(
    "text",
    [
        "A truck crawls along ahead of us.",
        "The truck ahead rumbles along at 40 km/h.",
        "A bus glides along ahead of us.",
    ],
)
def test_who_goes_along_stays_ahead(read, text: str) -> None:
    assert [o.spec.placement.position for o in read(text).objects] == ["ahead"]
    assert not read(text).objects[0].spec.phases


@pytest.mark.parametrize(
    "verb", ["moves off", "sets off", "drives off", "noses out", "edges out", "rejoins the traffic"]
)
def test_who_stood_at_the_kerb_enters_the_road(read, verb: str) -> None:
    car = read(f"A parked car on the right {verb}. Ego brakes.").objects[0].spec
    assert [p.action for p in car.phases] == ["enter_road"]


@pytest.mark.parametrize("who", ["guy", "lady", "old man", "woman"])
def test_who_is_in_a_lane_drives(read, who: str) -> None:
    car = read(f"The {who} in the left lane suddenly moved into my lane.").objects[0].spec
    assert (car.type, car.placement.position, [p.action for p in car.phases]) == ("car", "left_lane", ["cut_in"])


@pytest.mark.parametrize(
    ("text", "kind", "acts"),
    [
        ("Someone in a white van cuts in in front of us from the left lane.", "van", ["cut_in"]),
        ("Something, probably a fox, ran out from the left.", "animal", ["cross_road"]),
        ("Something, I think a pickup, overtakes us.", "truck", ["overtake"]),
        ("Strips of truck tyre lie in our lane. The van ahead swerves around them.", "debris", []),
    ],
)
def test_who_is_only_guessed(read, text: str, kind: str, acts: list[str]) -> None:
    first = read(text).objects[0].spec
    assert (first.type, [p.action for p in first.phases]) == (kind, acts)


@pytest.mark.parametrize("verb", ["shows up", "appears", "turns up", "comes up"])
def test_who_turns_up_from_behind_is_there(read, verb: str) -> None:
    car = read(f"We are doing 100 km/h. A BMW {verb} from behind in the left lane, doing I'd say 160.").objects[0].spec
    assert (car.placement.position, car.placement.along, round(car.speed, 1)) == ("left_lane", "behind", 44.4)


@pytest.mark.parametrize(
    "text",
    [
        "Ego in the right lane, a van just behind it in the left lane. The van cuts in.",
    ],
)
def test_who_has_a_place_of_its_own_is_another(read, text: str) -> None:
    structure = read(text)
    other = structure.objects[0].spec
    assert (other.placement.position, [p.action for p in other.phases]) == ("left_lane", ["cut_in"])
    assert not structure.ego.spec.phases


def test_a_participle_without_a_subject_is_what_ego_does(read) -> None:
    structure = read("Following a truck at 80. It brakes hard.")
    assert structure.ego.spec.type == "car" and [p.action for p in structure.ego.spec.phases] == ["follow"]
    assert [p.action for p in structure.objects[0].spec.phases] == ["brake"]
