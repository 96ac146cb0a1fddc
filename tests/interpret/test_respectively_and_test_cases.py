"""Two told of together with "respectively", names of test cases with speeds, what is meant but not done, notes."""

import pytest


@pytest.mark.parametrize(
    ("text", "ego", "other"),
    [
        ("CMRs 40 km/h.", 11.11, 0.0),
        ("CCRs, VUT 50 km/h.", 13.89, 0.0),
    ],
)
def test_test_cases_with_speeds(read, text: str, ego: float, other: float) -> None:
    s = read(text)
    assert (s["E"].spec.speed, s["O1"].spec.speed) == (ego, other)
