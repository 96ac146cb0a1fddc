"""Who tells from off the road is nobody on it; ego is the first whom the tale is about."""

import pytest


@pytest.mark.parametrize(
    ("text", "ego", "others"),
    [
        ("I was at the bus stop in my taxi when a van pulled out in front of me.", "car", ["van"]),
        ("I was sitting at the lights. A car ran into me.", "car", ["car"]),
    ],
)
def test_bystander(read, text: str, ego: str, others: list[str]) -> None:
    s = read(text)
    assert (s.ego.spec.type, [o.spec.type for o in s.objects]) == (ego, others)
