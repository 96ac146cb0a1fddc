"""Who is pointed at in a turn: by his number in the program, or by a look that the text tells."""

import pytest

from c2s_engine.interpret.turn import route
from tests.interpret.demanded import changed

SCENE = (
    "Ego drives at 50 km/h on a road behind a white car. A red car overtakes ego and cuts in. "
    "A cyclist rides on the right ahead."
)


def test_a_new_one_with_a_look_is_new(read) -> None:
    s = changed(read(SCENE), "add a red car behind ego")
    assert s["O4"].spec.placement.position == "behind"


@pytest.mark.parametrize(("text", "speed"), [("the car 5 kph slower", 55), ("car 5 km/h slower", 55)])
def test_a_number_with_a_unit_is_nobodys(read, text: str, speed: float) -> None:
    s = changed(read("Ego drives at 60 km/h behind a car."), text)
    assert s["O1"].spec.speed * 3.6 == pytest.approx(speed, abs=0.1)


def test_a_number_that_nobody_has(read) -> None:
    assert not route("make NPC 7 slower", read(SCENE)).edits
