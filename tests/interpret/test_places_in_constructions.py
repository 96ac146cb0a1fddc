"""The same place told in many words, in many constructions, is the same position."""

import pytest

PLACES = {
    "ahead": ["ahead of ego", "in ego's lane ahead", "directly in front of the ego vehicle", "ahead in the same lane"],
    "behind": ["behind ego", "to the rear of ego", "20 m behind", "behind it in the same lane"],
    "left_lane": [
        "in the left lane",
        "in the lane to the left of ego",
        "in the left adjacent lane",
        "left of ego",
        "in the lane immediately left of ego",
        "to ego's left",
    ],
    "right_lane": ["in the adjacent right lane", "in the right-hand lane", "in the lane right of ego"],
    "oncoming_lane": ["in the oncoming lane", "in the opposing lane", "in the lane for oncoming traffic"],
}
WAYS = [
    "There is a van {p}. Ego drives at 50 km/h.",
    "Ego drives at 50 km/h. A van is {p}.",
    "Ego drives at 50 km/h with a van {p}.",
    "Ego: 50 km/h. Van: {p}.",
    "A van {p} brakes while ego drives at 50 km/h.",
    "A van is positioned {p}. Ego drives at 50 km/h.",
    "A van starts {p}, and ego drives at 50 km/h.",
    "A van drives {p}. Ego drives at 50 km/h.",
]


@pytest.mark.parametrize("way", WAYS)
def test_a_place_is_the_same_in_each(read, way: str) -> None:
    for position, places in PLACES.items():
        for place in places:
            text = way.format(p=place)
            found = [(o.spec.type, o.spec.placement.position) for o in read(text).objects]
            assert found == [("van", position)], text


def test_where_somebody_starts_is_where_he_is(read) -> None:
    truck = read("The truck starts 40 m ahead of ego in the same lane at 60 km/h.").objects[0].spec
    assert (truck.placement.gap, round(truck.speed, 1), truck.phases) == (40.0, 16.7, ())
    walker = read("Ego drives at 40 km/h. A pedestrian starts at the left kerb and crosses.").objects[0].spec
    assert (walker.placement.side, [p.action for p in walker.phases]) == ("left", ["cross_road"])
    waiting = read("Ego waits. The lead vehicle starts from standstill when the light turns green.").objects[0].spec
    assert "start" in [p.action for p in waiting.phases]
