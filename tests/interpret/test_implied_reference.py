"""Who is told by his place beside nobody is beside ego; the places of others are told from him."""

import pytest


@pytest.mark.parametrize(
    ("text", "places"),
    [
        ("A car is 30 m ahead.", [("ahead", "ego", 30.0)]),
        ("A motorcycle is behind.", [("behind", "ego", None)]),
        ("A car is 30 m ahead, a second car 20 m ahead of the first.", [("ahead", "ego", 30.0), ("ahead", "O1", 20.0)]),
        (
            "A car is 30 m ahead; a second car is 20 m ahead of the first.",
            [("ahead", "ego", 30.0), ("ahead", "O1", 20.0)],
        ),
        ("A van is 30 m ahead, a truck 20 m ahead of the van.", [("ahead", "ego", 30.0), ("ahead", "O1", 20.0)]),
        (
            "An oncoming car is 100 m away. A second oncoming car is 30 m behind the first.",
            [("oncoming_lane", "ego", 100.0), ("behind", "O1", 30.0)],
        ),
        ("A car is 20 m ahead of a bus. The bus brakes.", [("behind", "ego", 20.0)]),
    ],
)
def test_where(read, text: str, places: list[tuple[str, str, float | None]]) -> None:
    found = [o.spec.placement for o in read(text).objects]
    assert [(p.position, p.of, p.gap) for p in found] == places


@pytest.mark.parametrize(
    ("text", "spacing", "position"),
    [
        ("Two cars drive ahead of ego, the second 30 m behind the first.", 30.0, "ahead"),
        ("Two trucks come towards ego, one 25 m behind the other.", 25.0, "oncoming_lane"),
    ],
)
def test_how_far_apart(read, text: str, spacing: float, position: str) -> None:
    found = read(text).objects[0].spec
    assert (found.count, found.spacing, found.placement.position, found.placement.gap) == (2, spacing, position, None)
