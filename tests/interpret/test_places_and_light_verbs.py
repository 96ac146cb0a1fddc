"""A place is the same whichever verb tells that somebody is there: stands, is located, can be seen, is put."""

import pytest

BEING = (
    "Ego drives at 50 km/h. {a} stands {at}.",
    "Ego drives at 50 km/h. {a} is located {at}.",
    "Ego drives at 50 km/h. {a} can be seen standing {at}.",
    "Ego drives at 50 km/h. There is {b} {at}.",
    "Ego drives at 50 km/h. Place {b} {at}.",
    "With {b} {at}, ego drives at 50 km/h.",
)


@pytest.mark.parametrize("being", BEING)
def test_a_car_beside_the_road(read, being: str) -> None:
    (one,) = read(being.format(a="A car", b="a car", at="next to the road")).objects
    assert one.spec.placement.position in ("parked", "roadside")


@pytest.mark.parametrize(
    "text",
    [
        "Ego drives at 50 km/h. A pedestrian stands at the crosswalk.",
        "Ego drives at 30 km/h. A child is waiting at the zebra crossing.",
        "Ego approaches a crosswalk. A man waits at the crosswalk and looks at his phone.",
    ],
)
def test_who_waits_at_a_crosswalk_is_on_the_sidewalk(read, text: str) -> None:
    (one,) = read(text).objects
    assert one.spec.placement.position == "sidewalk"
    assert [p.action for p in one.spec.phases] in (["stationary"], ["wait"])
