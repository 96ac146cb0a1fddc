"""Speeds by comparison."""

import pytest


@pytest.mark.parametrize(
    ("text", "kmh"),
    [
        ("The car ahead is 20 km/h slower than the ego, which drives at 100 km/h.", 80),
        ("Ego drives at 100 km/h. In the left lane there is a coach which is slightly faster.", 108),
        ("A car in the left lane, 20 km/h faster than the ego, overtakes. The ego does 80 km/h.", 100),
        ("Ego drives at 100 km/h. Ahead of it a lorry is a lot slower than the ego.", 60),
    ],
)
def test_faster_and_slower(read, text: str, kmh: float) -> None:
    assert read(text)["O1"].spec.speed == pytest.approx(kmh / 3.6, abs=0.5)
