"""Who meets ego, whom ego gives way to, who is driven behind together, and whose view is blocked."""

import pytest


def test_who_meets_ego_at_a_junction_comes_from_where_it_says(read) -> None:
    s = read("Ego and a cyclist meet at a crossroads, the cyclist coming from the right.")
    assert s["O1"].spec.placement.position == "crossing_right"


@pytest.mark.parametrize(
    ("text", "crosswalk"),
    [
        ("There is a pedestrian crossing 30 m ahead, where a woman walks over.", True),
    ],
)
def test_a_pedestrian_who_crosses_is_no_crosswalk(read, text: str, crosswalk: bool | None) -> None:
    assert read(text).place.spec.crosswalk is crosswalk
