""" "Right in front of" tells how near, not a side; who comes back in has passed; goods on a vehicle; who watches."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "verb", ["pulls out", "swerves", "cuts in", "moves over", "changes lanes", "merges", "came across", "pulled in"]
)
def test_right_in_front_tells_no_side(read, verb: str) -> None:
    right, near = (read(f"A van {verb} {how} in front of us.").objects[0].spec for how in ("right", "directly"))
    assert right == near
    assert right.phases[0].action == "cut_in"


def test_a_turn_has_its_side(read) -> None:
    phases = read("A car turned right in front of me at the junction.").objects[0].spec.phases
    assert [p.action for p in phases] == ["turn_right"]


@pytest.mark.parametrize(
    "text",
    [
        "The adversarial vehicle overtakes ego, moves back in right in front of its bumper and brakes.",
        "A pickup goes past us. A hatchback is coming the other way, so he dives back in before our nose.",
        "A van passed me, then a bus came towards us so it squeezed back in.",
    ],
)
def test_who_comes_back_in_has_passed(read, text: str) -> None:
    structure = read(text)
    assert actions(structure.objects[0])[:2] == ["overtake", "cut_in"]
    assert all("cut_in" not in actions(o) and "oncoming" not in actions(o) for o in structure.objects[1:])


@pytest.mark.parametrize(
    "text",
    [
        "Ahead of ego is a flatbed truck laden with hay, moving at 60 km/h.",
    ],
)
def test_what_a_vehicle_is_loaded_with_is_on_it(read, text: str) -> None:
    (only,) = read(text).objects
    assert (only.spec.type, round(only.spec.speed * 3.6), actions(only)) == ("truck", 60, [])


@pytest.mark.parametrize(
    "text",
    [
        "A boy ran out from behind the bus and a car hit him.",
        "A girl came out from behind the bus and a Kia struck her.",
    ],
)
def test_who_only_hides_somebody_is_not_ego(read, text: str) -> None:
    structure = read(text)
    assert structure["E"].spec.type == "car"
    assert [o.spec.type for o in structure.objects] == ["bus", "child"]
