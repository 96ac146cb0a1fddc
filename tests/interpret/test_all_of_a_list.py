"""Lists of road users, other names in apposition, and ego by any name."""

import pytest


def types(s) -> list[tuple[str, int]]:
    return sorted((o.spec.type, o.spec.count) for o in s.objects)


@pytest.mark.parametrize(
    "text",
    [
        "A car, a van and a truck drive ahead of ego.",
    ],
)
def test_all_of_a_list_are_there(read, text: str) -> None:
    assert types(read(text)) == [("car", 1), ("truck", 1), ("van", 1)]


@pytest.mark.parametrize(
    "text",
    [
        "The vehicle ahead, a white van, brakes.",
        "The lead vehicle - a van - brakes.",
    ],
)
def test_another_name_is_the_same_one(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.type == "car"
    assert [(o.spec.type, [p.action for p in o.spec.phases]) for o in s.objects] == [("van", ["brake"])]


@pytest.mark.parametrize(
    "text",
    [
        "A car and a van are ahead of ego; the latter, a white Transit, brakes.",
    ],
)
def test_the_latter(read, text: str) -> None:
    brake = {o.spec.type: [p.action for p in o.spec.phases] for o in read(text).objects}
    assert brake == {"car": [], "van": ["brake"]}


@pytest.mark.parametrize(
    "text",
    [
        "One of two vans driving ahead of ego brakes.",
    ],
)
def test_one_of_several(read, text: str) -> None:
    braking = [o.spec.count for o in read(text).objects if o.spec.phases]
    assert braking == [1]


@pytest.mark.parametrize(
    "name",
    [
        "The bus we're testing",
        "The bus under test",
        "A bus equipped with AEB",
        "The bus that is tested",
        "The bus fitted with an emergency braking system",
        "The main bus",
    ],
)
def test_ego_by_any_name(read, name: str) -> None:
    s = read(f"{name} drives at 50 km/h. A van ahead brakes.")
    assert (s.ego.spec.type, round(s.ego.spec.speed, 1)) == ("bus", 13.9)
    assert types(s) == [("van", 1)]


@pytest.mark.parametrize(
    "text",
    [
        "A van leads a car. The van brakes.",
        "A van, followed by a car, brakes.",
        "A car follows a van. The van brakes.",
        "A truck is followed by a car. The truck brakes hard.",
    ],
)
def test_who_drives_behind_is_ego(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.type == "car"
    assert [(o.spec.placement.position, [p.action for p in o.spec.phases]) for o in s.objects] == [("ahead", ["brake"])]


@pytest.mark.parametrize(
    "text",
    [
        "A bus is in the right lane. A van in the left lane cuts in in front of it.",
    ],
)
def test_whose_way_is_taken_is_ego(read, text: str) -> None:
    assert [o.spec.type for o in read(text).objects] == ["van"]


@pytest.mark.parametrize(
    "text",
    [
        "A driver passes a parked van and a child runs out from behind it.",
        "A driver stops and a woman walks across the road.",
    ],
)
def test_a_driver_does_not_walk_because_another_does(read, text: str) -> None:
    assert len([o for o in read(text).objects if o.spec.type in ("pedestrian", "child")]) == 1
