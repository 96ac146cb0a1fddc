"""Whom a headline announces, clear distances, junctions at which a road ends, and marks of a log."""

import pytest


def _types(s) -> list[str]:
    return [o.spec.type for o in s.objects]


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("Ego at 30 km/h: a boy stands on the left and a girl crosses from the right.", ["child", "child"]),
    ],
)
def test_who_is_in_a_headline_is_told_of_once_more(read, text: str, kinds: list[str]) -> None:
    assert _types(read(text)) == kinds


@pytest.mark.parametrize(
    ("text", "gap"),
    [
        ("VUT: 50 km/h. GVT: 50 km/h, same lane, 12 m clear distance to the VUT. The GVT brakes.", 12),
    ],
)
def test_clear_distances_are_gaps(read, text: str, gap: float) -> None:
    assert read(text).objects[0].spec.placement.gap == gap


@pytest.mark.parametrize(
    "text",
    [
        "Pell Street comes in from the south and ends at Harmon. V1 was on Harmon Road and turned left onto Pell.",
        "The side road ends at the A12. Ego is on the A12 at 80 km/h when a tractor turns out of the side road.",
        "The minor road comes in from the right and ends at the main road. Ego on the main road lets a tractor out.",
    ],
)
def test_where_a_road_ends_three_arms_meet(read, text: str) -> None:
    assert read(text).place.spec.arms == 3


def test_a_lane_that_ends_is_no_junction(read) -> None:
    assert read("The right lane ends at a taper. Ego at 80 km/h merges to the left.").place.spec.arms is None


def test_marks_of_a_log_are_nobody(read) -> None:
    assert _types(read("EVT 101 / AV log: ego follows a bus at 58 km/h. The bus brakes.")) == ["bus"]
