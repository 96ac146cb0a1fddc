"""Of alternatives one is chosen and that is said; whoever something is only tried upon stays in the scene."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "The lead vehicle either brakes or steers around the obstacle.",
        "Ego follows a van. The van either stops or swerves.",
        "A car ahead of ego brakes or changes lane.",
    ],
)
def test_one_of_two_is_chosen_and_said(read, text):
    lead = read(text).objects[0]
    assert len(lead.spec.phases) == 1 and "phases" in [a.field for a in lead.assumed]


def test_a_range_of_speeds_is_no_way_across(read):
    (rider,) = read("Ego drives. A cyclist rides between 15 and 20 km/h.").objects
    assert [p.action for p in rider.spec.phases] == ["move_along"]
