"""What a text leaves open or tells in vain: choices, defaults that make the event possible, what no spec can say."""

from typing import Any

import pytest

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle


def spec(structure: Structure, cid: str) -> Any:
    return structure[cid].spec


def test_of_two_reactions_the_first_is_taken_and_said(read) -> None:
    s = read("A van stands ahead of ego in its lane. Ego brakes or steers around it.")
    assert spec(s, "E").reaction == "brake"
    assert any("“brakes” or “steers”" in a.reason for a in s.ego.assumed)


@pytest.mark.parametrize(
    ("text", "component", "said"),
    [
        ("The car ahead brakes and honks.", "O1", "honks"),
        ("A taxi ahead stops and its door opens.", "O1", "door opens"),
        ("Ego follows a van uphill and the van stops.", "R", "uphill"),
        ("Low sun. A child crosses from the left.", "G", "Low sun"),
        ("The car ahead brakes and the system warns the driver.", "E", "warns the driver"),
    ],
)
def test_what_no_spec_can_say_is_noted_with_its_component(read, text: str, component: str, said: str) -> None:
    notes = read(text)[component].unmet
    assert [text[n.span[0] : n.span[1]] for n in notes if n.span] == [said]
    assert all(n.reason for n in notes)


@pytest.mark.parametrize(
    ("text", "faster"),
    [
        ("Ego overtakes a van that is driving at 60 km/h.", "ego"),
        ("Ego closes in on a car ahead.", "ego"),
        ("A car at 90 km/h overtakes the ego on the left.", "other"),
        ("A motorbike comes from behind and overtakes ego.", "other"),
    ],
)
def test_speeds_that_are_left_open_let_the_event_happen(read, text: str, faster: str) -> None:
    s = read(text)
    ego, other = middle(spec(s, "E").speed), middle(spec(s, "O1").speed)
    assert (ego > other) == (faster == "ego")


# type: ignore[union-attr]
