"""Shares of a group: the first two, the rest, each of them, one of two, the former; rows from front to back."""

import pytest


def test_a_part_is_counted_and_the_rest_stays(read) -> None:
    s = read(
        "Six deer stand on the verge on the left; two of them run across the road and the rest stay where they are."
    )
    assert sorted((o.spec.count, o.spec.phases[0].action) for o in s.objects) == [(2, "cross_road"), (4, "stationary")]


def test_the_second_of_two_is_the_farther(read) -> None:
    first, second = read("Two cars are ahead of ego. The second one brakes.").objects
    assert second.spec.phases[0].action == "brake" and second.spec.placement.of == first.id


@pytest.mark.parametrize(
    "text",
    ["Ego passes the first two intersections; a van is behind it.", "A van is ahead of ego in one of the two lanes."],
)
def test_no_share_of_places(read, text: str) -> None:
    assert len(read(text).objects) == 1


def test_all_three_may_have_ego_among_them(read) -> None:
    s = read(
        "A truck is ahead of ego, an SUV is behind ego. A worker stands at the kerb. All three drive past the worker."
    )
    assert "overtake" not in [p.action for o in s.objects for p in o.spec.phases]
