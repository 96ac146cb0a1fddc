"""Titles told again, what is found after a crash, whose lights come on, animals that graze, bare speeds."""

import pytest


@pytest.mark.parametrize(
    ("text", "types"),
    [
        (
            "Oncoming vehicle drifting. VUT speed 72 km/h. An oncoming car slowly drifts across the centre line.",
            ["car"],
        ),
        ("Stopped lead truck. Ego drives at 60 km/h. A truck has stopped ahead of ego.", ["truck"]),
    ],
)
def test_a_title_names_nobody_else(read, text: str, types: list[str]) -> None:
    assert sorted(o.spec.type for o in read(text).objects) == types


def test_what_it_comes_to_rest_against_is_no_second_collision(read) -> None:
    (other,) = read("V2 was struck by V1 and came to rest against a pole on the corner.").objects
    assert other.spec.phases == ()
    ego = read("V1 left the road to the right and came to rest against a tree.").ego.spec
    assert "collide" in [p.action for p in ego.phases]


def test_whose_lights_come_on_goes_on(read) -> None:
    s = read(
        "V1 stopped behind a truck. The truck's reverse lights came on and it began to back up. Its lift gate hit V1."
    )
    (truck,) = s.objects
    assert (truck.spec.placement.position, [p.action for p in truck.spec.phases]) == ("ahead", ["reverse", "collide"])
    assert "reverse" not in [p.action for p in s.ego.spec.phases]


def test_an_animal_that_grazes_stands(read) -> None:
    (deer,) = read("Ego drives at 60 km/h. A deer is grazing on the right verge.").objects
    assert [p.action for p in deer.spec.phases] == ["stationary"]


@pytest.mark.parametrize(
    "text", ["Ego does 80. A van ahead of ego brakes.", "A van ahead brakes while ego is doing 80."]
)
def test_who_does_eighty_drives_so_fast(read, text: str) -> None:
    assert round(read(text).ego.spec.speed, 1) == 22.2
