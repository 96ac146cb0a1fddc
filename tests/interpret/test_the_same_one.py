"""Who is spoken of again: by age, by what is ridden, by colour, by its end of a group, in a quotation, as passenger."""

import pytest


def acts(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "A 45-year-old man drove his VW on the B3. A 20-year-old in a BMW overtook him. The 45-year-old braked hard.",
        "Ego drives. A BMW overtakes it. My wife was driving our car. She braked hard.",
        "The Swift was going south when a BMW overtook it. The driver of the Swift braked hard.",
    ],
)
def test_by_age_noun_or_make(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.reaction == "brake" or "brake" in acts(s.ego)
    assert len(s.objects) == 1 and "overtake" in acts(s["O1"])


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("I was a passenger in a taxi. The taxi driver ran a red light.", "car"),
        ("We were sitting in the back of a minibus. A car cut in.", "car"),
    ],
)
def test_what_carries_the_first_person(read, text: str, kind: str) -> None:
    assert read(text).ego.spec.type == kind


def test_the_driver_of_what(read) -> None:
    s = read("The ego overtakes a bus. While it passed, the bus driver himself moved out to the left.")
    assert len(s.objects) == 1
    s = read("According to the driver, a dog ran in front of his car, so he swerved left and hit a parked car.")
    assert acts(s.ego) == ["swerve", "collide"] and acts(s["O1"]) == ["cross_road"]
    told = "V1 was eastbound. V2 drifted left and, per the motorist who was trailing it, braked."
    s = read(f"{told} The trailing motorist stopped.")
    assert len(s.objects) == 2


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("A lady was reversing out of her driveway and did not see me. I swerved left.", "reverse"),
        ("I was driving north when the other party pulled out of a driveway on the right.", "enter_road"),
    ],
)
def test_who_does_what_only_vehicles_do(read, text: str, act: str) -> None:
    s = read(text)
    assert [o.spec.type for o in s.objects] == ["car"] and act in acts(s["O1"])


def test_former_and_latter(read) -> None:
    s = read("An SUV and the AV arrived at the four-way stop. The former went first, and the latter followed.")
    assert "follow" not in acts(s["O1"])
    s = read("A taxi and a bus were waiting at the light. The latter moved off, the former stayed.")
    assert s.ego.spec.type == "bus" and acts(s.ego) == ["start"] and acts(s["O1"]) == ["stationary"]


def test_a_makes_driver_and_its_short_name(read) -> None:
    s = read("The Volkswagen driver turned left. She failed to notice an oncoming motorcycle. It struck the VW.")
    assert [o.spec.type for o in s.objects] == ["motorcycle"]


def test_its_driver_is_not_he_who_is_spoken_of(read) -> None:
    s = read("A car and a motorcycle were involved. The rider was overtaking the car when its driver turned left.")
    assert acts(s.ego) == ["turn_left"] and acts(s["O1"]) == ["overtake"]
    s = read("Ego drives ahead of a taxi. While he was passing a bus, its driver braked.")
    assert "brake" in next(acts(o) for o in s.objects if o.spec.type == "bus")


@pytest.mark.parametrize(
    "text",
    [
        "A bus overtook a cyclist and pulled in right in front of her.",
        "Two cyclists were ahead of the bus. The bus driver overtook the first, then pulled in before the second.",
        "A van driver cut in ahead of a cyclist.",
    ],
)
def test_the_only_one_with_a_motor_is_ego(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.type in ("bus", "van") and {o.spec.type for o in s.objects} == {"bicycle"}
