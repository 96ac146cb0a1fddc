"""Turns as they are typed in a hurry: letters and articles left out, two changes in one, quantities by another's."""

import pytest

from c2s_engine.interpret.turn import route
from tests.interpret.demanded import assert_same

MOTORWAY = (
    "Ego drives at 100 km/h in the middle lane of a three-lane motorway in light rain. A motorcycle overtakes on the "
    "left at 130 km/h. A truck ahead at 80 km/h, 60 m away, changes to the left lane."
)
JUNCTION = (
    "Ego drives straight through an intersection without traffic lights at 40 km/h. A van comes from the right. "
    "A scooter follows ego at 10 metres."
)
CHILD = (
    "A school bus stands at the roadside with kids around it. Ego approaches at 50 km/h. "
    "One child runs across the road 30 m ahead of ego."
)


@pytest.mark.parametrize(
    ("scene", "plain", "wordings"),
    [
        (MOTORWAY, "the truck is slower", "truck shud be slowr | mak the truck slower | Truck: slower"),
        (MOTORWAY, "remove the motorcycle", "delet the motorcycle | plz delet motorcyle"),
        (MOTORWAY, "reduce the truck's speed by a quarter", "cut the truck's speed by a quarter"),
        (MOTORWAY, "the motorcycle at 50 km/h", "motorbike half the speed of ego"),
        (JUNCTION, "the junction has traffic lights", "add traffic lights | put traffic lights there"),
        (JUNCTION, "the scooter brakes when the van comes", "scooter brakes when van comes"),
        (CHILD, "ego brakes only when o3 is 10 m away", "ego brakes only when child is 10 m away"),
    ],
)
def test_as_the_plain_one(read, scene: str, plain: str, wordings: str) -> None:
    assert_same(read(scene), plain, wordings)


# fmt: skip


def test_never_mind_takes_back(read) -> None:
    assert route("never mind, keep it as it was", read(MOTORWAY)).kind == "undo"
