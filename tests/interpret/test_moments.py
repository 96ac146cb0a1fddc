"""Moments told in many words are the same trigger."""

import pytest

MOMENTS = {
    ("distance", 20.0): [
        "when ego is 20 m away",
        "the moment ego is 20 meters away",
        "upon ego coming within 20 m",
        "if ego is less than 20 m away",
        "just as ego gets to within 20 m of it",
        "20 m before ego reaches it",
        "with ego 20 m away",
    ],
    ("ttc", 2.0): ["at a TTC of 2 s", "when the time to collision falls below 2 seconds", "with 2 s TTC"],
    ("time", 3.0): [
        "after 3 seconds",
        "when 3 seconds have passed",
        "after a delay of 3 s",
        "once 3 seconds have elapsed",
        "at time 3 s",
        "3 s from the beginning",
    ],
}
WAYS = [
    "A pedestrian crosses the road from the right {t}.",
    "Ego drives at 50 km/h. {T}, a pedestrian crosses the road from the right.",
    "A van 30 m ahead of ego brakes hard {t}.",
    "{T}, a van in the left lane cuts in in front of ego.",
]


@pytest.mark.parametrize("way", WAYS)
def test_a_moment_is_the_same_in_each(read, way: str) -> None:
    for (kind, value), words in MOMENTS.items():
        for told in words:
            text = way.format(t=told, T=told[0].upper() + told[1:])
            triggers = [p.trigger for o in read(text).objects for p in o.spec.phases if p.trigger is not None]
            assert [(t.kind, t.value) for t in triggers] == [(kind, value)], text


@pytest.mark.parametrize(
    "text",
    [
        "A man pushing a bike crosses the road from the right.",
        "A worker pushing a wheelbarrow crosses from the right.",
        "A woman with a stroller steps off the right kerb in front of ego.",
    ],
)
def test_what_one_on_foot_pushes_is_nobody(read, text: str) -> None:
    (walker,) = read("Ego drives at 40 km/h. " + text).objects
    assert walker.spec.type in ("pedestrian", "child")
    assert [p.action for p in walker.spec.phases] == ["cross_road"]
