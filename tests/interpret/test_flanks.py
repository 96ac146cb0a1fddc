"""Whose flank was struck at a junction tells from which side the other came."""

import pytest


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("A van runs a red light and hits ego from the right.", "right"),
        ("A van runs a red light and hits the passenger side of ego.", "right"),
        ("V1 was struck on its left side by a van that ran the stop sign.", "left"),
        ("At a crossroads a truck crashes into the driver's side of ego.", "left"),
        ("V2 ran the red light and its front struck the left side of V1.", "left"),
        ("V2's front impacted V1's right side doors in the intersection.", "right"),
        ("V1 went through the intersection and struck the right side of V2, which had run the stop sign.", "left"),
        ("The front of V1 contacted the left rear door of V2 at the intersection; V2 had run the red light.", "right"),
    ],
)
def test_one_comes_from_the_side_that_is_struck(read, text: str, side: str) -> None:
    (other,) = read(text).objects
    assert other.spec.placement.position == f"crossing_{side}"
