"""Who goes left or right to avoid somebody swerves; who goes into a street turns."""

import pytest


@pytest.mark.parametrize(
    ("text", "acts"),
    [
        ("V1 swerved right to avoid a dog.", ["swerve"]),
        ("The VUT steered left to avoid the pedestrian.", ["swerve"]),
        ("The ego veers right to avoid a child.", ["swerve"]),
        ("V1 swerved to the left, and missed the dog.", ["swerve"]),
        ("V1 swung left into a side street behind a van.", ["turn_left"]),
        ("The ego turned right at the lights to avoid a queue.", ["turn_right"]),
    ],
)
def test_to_one_side(read, text: str, acts: list[str]) -> None:
    assert [p.action for p in read(text)["E"].spec.phases] == acts
