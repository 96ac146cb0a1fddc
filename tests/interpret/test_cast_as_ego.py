"""A vehicle that is cast as ego, in its phrase or in a sentence of its own, is ego and nobody else."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "I drive in the right lane (my Passat = ego) at 120 km/h and a van brakes ahead of me.",
        "Ego is behind a van at 120 km/h. The van brakes.",
        "Ego drives at 120 km/h. The van ahead of ego brakes.",
    ],
)
def test_who_only_stands_near_ego_is_not_cast(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.speed == pytest.approx(33.33, abs=0.01)
    assert [(o.spec.type, [p.action for p in o.spec.phases]) for o in s.objects] == [("van", ["brake"])]
