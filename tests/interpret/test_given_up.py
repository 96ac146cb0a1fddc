"""What is begun and given up, waited for, missed or left to others; limits, slang and slips of the pen."""

from typing import Any

import pytest

from c2s_engine.structure.components import Structure


def spec(structure: Structure, cid: str) -> Any:
    return structure[cid].spec


def acts(structure: Structure, cid: str) -> list[str]:
    return [p.action for p in spec(structure, cid).phases]


@pytest.mark.parametrize(
    ("text", "component", "done"),
    [
        ("The ego starts a lane change to the left but goes back because a car comes from behind.", "E", ["swerve"]),
        ("Ego begins to overtake the truck but aborts and falls back behind it.", "E", ["follow"]),
        ("A van starts to change lanes into ego's lane and then moves back.", "O1", ["cut_in", "cut_out"]),
        ("The motorcyclist attempts to overtake but aborts because of oncoming traffic.", "O1", ["follow"]),
        ("V2 was stopped ahead of V1, waiting to turn left. V1 hit V2.", "O1", ["stationary"]),
        ("The ego brakes at the light. The car behind it does not stop in time.", "O1", ["collide"]),
        ("The lead vehicle takes the exit while ego stays on the motorway.", "O1", ["leave_road"]),
        
        ("A ball rolls onto the road, followed by a child from the left.", "O1", ["cross_road"]),
        ("A fire engine comes from behind; the ego moves to the right and stops to let it pass.", "E",
         ["lane_change", "stop"]),
        ("Ego goes straight and the opposing vehicle, having lost control, crosses into its lane.", "O1", ["oncoming"]),
    ],
)  # fmt: skip
def test_what_is_done_in_the_end(read, text: str, component: str, done: list[str]) -> None:
    assert acts(read(text), component) == done


def test_a_stop_before_contact_is_no_collision(read) -> None:
    s = read("The vehicle under test approaches a stationary car and shall come to a stop before contact.")
    assert acts(s, "E") == ["stop"] and spec(s, "E").reaction == "brake"


def test_who_is_let_in_is_who_comes_over(read) -> None:
    s = read("The ego has a truck to its right and a van to its left. The truck pulls into ego's lane; ego lets it in.")
    assert spec(s, "E").react_to == "O1" and spec(s, "O1").type == "truck"


@pytest.mark.parametrize(
    ("text", "limit"),
    [("Speed limit 30 zone. Ego at 50 km/h.", 30), ("In a 30-zone ego follows a bus.", 30), ("Limit 80, ego 60.", 80)],
)
def test_a_bare_number_is_a_limit_where_it_is_called_so(read, text: str, limit: float) -> None:
    assert spec(read(text), "R").speed_limit == pytest.approx(limit / 3.6, abs=0.01)


@pytest.mark.parametrize(
    ("text", "kind", "done"),
    [
        ("a truk ovrtakes teh ego on the lefft and cuts in", "truck", "cut_in"),
        ("pedstrian crosing form teh rigth at nigth, ego 50 kmh", "pedestrian", "cross_road"),
        ("teh car infornt of me brakd sudenly adn i had to swrve to the lft", "car", "brake"),
        ("a dude on a bike comin outta nowhere from the left", "bicycle", None),
    ],
)
def test_slips_and_slang_are_read_as_meant(read, text: str, kind: str, done: str | None) -> None:
    s = read(text)
    assert spec(s, "O1").type == kind
    assert done is None or done in acts(s, "O1")
