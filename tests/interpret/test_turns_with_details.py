"""Turns that say more of whom they change, that leave a verb out, or that ask first and then demand."""

import pytest

from tests.interpret.demanded import LIGHTS, ROW, after, assert_same

CELLS = [
    (
        LIGHTS,
        "make the motorcycle a bicycle. it drives at 15 km/h. put it 5 m behind ego",
        "make the motorcycle a bicycle, 15 km/h, 5 m behind us | "
        "the motorcycle becomes a bicycle, at 15 km/h, 5 m behind ego",
    ),
    (
        LIGHTS,
        "make the truck a bus. the bus at 30 km/h",
        "turn the truck into a bus, going 30 km/h | the truck should be a bus, 30 km/h",
    ),
    (LIGHTS, "the light is red for ego", "just the light: red for ego | light: red for ego"),
    (
        LIGHTS,
        "ego at 50 km/h. ego starts 80 m before the junction",
        "ego 50 km/h, and let ego start 80 m before the junction",
    ),
    (ROW, "fog", "instead of the clear sky I would like to have fog"),
]


@pytest.mark.parametrize(("scene", "plain", "wordings"), CELLS, ids=[c[1] for c in CELLS])
def test_a_demand_is_the_same_in_other_words(read, scene: str, plain: str, wordings: str) -> None:
    assert_same(read(scene), plain, wordings)


def test_whom_it_is_about_starts_later(read) -> None:
    boy = after(read(ROW), "Make the boy a dog. Let it start when ego is 20 m away.")["O2"]
    assert (boy.type, boy.phases[0].trigger.value) == ("animal", 20.0)


@pytest.mark.parametrize(
    "text",
    [
        "I'd like a speed limit sign showing 60 on the right, 50 m ahead",
        "a speed limit sign of 60 at the right roadside",
    ],
)
def test_a_sign_needs_no_verb(read, text: str) -> None:
    sign = after(read(ROW), text)["O4"]
    assert (sign.type, round(sign.limit, 2), sign.placement.side) == ("speed_sign", 16.67, "right")
