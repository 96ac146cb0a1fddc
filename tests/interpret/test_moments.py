"""Moments told in many words are the same trigger."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "A woman with a stroller steps off the right kerb in front of ego.",
    ],
)
def test_what_one_on_foot_pushes_is_nobody(read, text: str) -> None:
    (walker,) = read("Ego drives at 40 km/h. " + text).objects
    assert walker.spec.type in ("pedestrian", "child")
    assert [p.action for p in walker.spec.phases] == ["cross_road"]
