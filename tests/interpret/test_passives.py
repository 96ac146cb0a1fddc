"""Passives that do not say who did it."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "The woman crosses the road. The test car does not react, so she is struck.",
        "A dog runs onto the road and gets run over by the ego.",
        "The moped is knocked over by the ego on the zebra.",
    ],
)
def test_ego_hits(read, text: str) -> None:
    assert "collide" in [p.action for p in read(text)["E"].spec.phases]


def test_others_do_it_to_ego(read) -> None:
    s = read("The ego is overtaken and then the overtaking car brakes.")
    assert [p.action for p in s["O1"].spec.phases] == ["overtake", "brake"]
    s = read("The ego is tailgated by a lorry.")
    assert s["O1"].spec.placement.position == "behind"


def test_into_a_lane_is_no_contact(read) -> None:
    s = read("Ego went into the left lane behind a truck.")
    assert [p.action for p in s["E"].spec.phases] == ["lane_change"]
