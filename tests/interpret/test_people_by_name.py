"""People called by their names, he and she, and who tells the story on foot or on a bicycle."""

import pytest


def acts(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "Mr. Hansen was driving his Golf along the A7 when a lorry pulled out in front of him. He swerved left.",
        "Julia Weber drove her Passat north. A lorry came out of a side street in front of her. She swerved left.",
        "Okafor, 34, was driving her van on the motorway when a lorry cut in. She swerved left.",
    ],
)
def test_who_is_named_is_at_the_wheel(read, text: str) -> None:
    s = read(text)
    assert "swerve" in acts(s.ego)
    assert [o.spec.type for o in s.objects] == ["truck"]


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
