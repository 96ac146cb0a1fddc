"""Members of a group that are only placed, and those who fill the lanes side by side."""

import pytest


def places(structure) -> list[tuple]:
    return [(o.spec.placement.position, o.spec.placement.side, o.spec.placement.of) for o in structure.objects]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Two pedestrians cross, one from the left and one from the right.",
         [("roadside", "left", "ego"), ("roadside", "right", "ego")]),
        ("Two cars approach the intersection, one from the left, the other from the right. Ego goes straight.",
         [("crossing_left", None, "ego"), ("crossing_right", None, "ego")]),
        ("Ego drives in the middle lane. Two trucks drive ahead of it, one in the left lane and one in the right lane.",
         [("left_lane", None, "ego"), ("right_lane", None, "ego")]),
        ("Two vehicles are near ego: one 20 m ahead and one 10 m behind.",
         [("ahead", None, "ego"), ("behind", None, "ego")]),
        
        ("There are three cars around ego, one ahead, one behind and one in the left lane.",
         [("ahead", None, "ego"), ("behind", None, "ego"), ("left_lane", None, "ego")]),
        ("Two cars (one in front, one behind) drive at the same speed as ego.",
         [("ahead", None, "ego"), ("behind", None, "ego")]),
    ],
)  # fmt: skip
def test_one_and_the_other_are_placed(read, text: str, expected: list) -> None:
    assert places(read(text)) == expected


def test_what_follows_stays_with_both(read) -> None:
    s = read("Two children run onto the road, one from the left and the other from the right, 30 m ahead of ego.")
    assert [o.spec.phases[0].trigger.value for o in s.objects] == [30.0, 30.0]


@pytest.mark.parametrize(
    "text",
    [
        "Two cyclists ride ahead, one behind the other. Ego overtakes them.",
        "Three trucks drive in a row, one behind the other, in the right lane.",
    ],
)
def test_a_row_stays_one(read, text: str) -> None:
    assert len(read(text).objects) == 1
