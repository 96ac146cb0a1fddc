"""People called by their names, he and she, and who tells the story on foot or on a bicycle."""

import pytest


def acts(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "Mr. Hansen was driving his Golf along the A7 when a lorry pulled out in front of him. He swerved left.",
        "Julia Weber drove her Passat north. A lorry came out of a side street in front of her. She swerved left.",
        "Dave was doing 50 in his Transit. A lorry cut in ahead of him. Dave swerved left.",
        "Okafor, 34, was driving her van on the motorway when a lorry cut in. She swerved left.",
    ],
)
def test_who_is_named_is_at_the_wheel(read, text: str) -> None:
    s = read(text)
    assert "swerve" in acts(s.ego)
    assert [o.spec.type for o in s.objects] == ["truck"]


def test_names_of_both(read) -> None:
    s = read("Peter follows Anna on the motorway. Anna brakes hard because a deer crosses the road.")
    assert acts(s.ego)[0] == "follow" and "brake" in acts(s["O1"])
    s = read("Ms. Lopez, 34, was walking across Pine Street when she was struck by a sedan driven by Mr. Tan.")
    assert [o.spec.type for o in s.objects] == ["pedestrian"]
    assert "collide" in acts(s.ego)
    s = read("Sarah was riding her bicycle when a car turned right in front of her. She hit the car.")
    assert [(o.spec.type, o.spec.phases[-1].target) for o in s.objects] == [("bicycle", "ego")]


@pytest.mark.parametrize(
    "text",
    [
        "The ego drives along Martin Street near Charlotte. A car brakes.",
        "The ego drives towards St. Peter. A car brakes, says Officer Reed.",
        "The ego drives 200 ms later. A car brakes. Constable Marsh was informed.",
    ],
)
def test_names_of_places_and_witnesses_are_nobody(read, text: str) -> None:
    assert [o.spec.type for o in read(text).objects] == ["car"]


def test_he_and_she(read) -> None:
    s = read("A woman in a Corolla was driving south. A boy on a scooter came out from behind a van. She braked hard.")
    assert s.ego.spec.reaction == "brake"
    assert "bicycle" in [o.spec.type for o in s.objects]
    s = read(
        "The driver of a Honda Civic was going straight. The driver of a BMW turned left in front of him. He hit it."
    )
    assert "collide" in acts(s.ego)
    s = read("An SUV driven by a 25-year-old woman was going north. She changed lanes to the left.")
    assert acts(s.ego) == ["lane_change"] and not s.objects
    s = read("The driver of the ego saw a woman with a pram at the crossing. He stopped for her.")
    assert "stop" in acts(s.ego)


def test_the_driver_is_who_was_spoken_of(read) -> None:
    s = read("A truck overtook us on the motorway. The driver cut back in too early and we had to brake.")
    assert acts(s["O1"]) == ["overtake", "cut_in"]
    s = read("A truck was standing in the left lane. Truck driver had left. The ego hit the truck.")
    assert len(s.objects) == 1
    s = read(
        "A car was driving along a rural road. The 45-year-old driver lost control and left the road to the right."
    )
    assert not s.objects and "leave_road" in acts(s.ego)


@pytest.mark.parametrize(
    ("text", "kind", "act"),
    [
        ("I was cycling along the canal when a van overtook me and turned left.", "bicycle", "turn_left"),
        (
            "I was crossing the street on the crosswalk when a van turned right and nearly hit me.",
            "pedestrian",
            "turn_right",
        ),
        ("We were walking along the road when a truck came up behind us and stopped.", "pedestrian", "stop"),
    ],
)
def test_who_tells_it_on_foot_is_not_ego(read, text: str, kind: str, act: str) -> None:
    s = read(text)
    assert [o.spec.type for o in s.objects] == [kind]
    assert act in acts(s.ego)


def test_a_red_van_is_no_red_light(read) -> None:
    assert "run_red" not in acts(read("The driver was driving a red van. A dog crossed the road. He braked.").ego)
