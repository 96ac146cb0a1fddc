"""What ego does not do, what it waits for, and titles."""

import pytest


@pytest.mark.parametrize(
    "text", ["A fox runs across the road; the ego doesn't brake.", "A woman crosses. The test car does not react."]
)
def test_no_reaction(read, text: str) -> None:
    assert read(text)["E"].spec.reaction == "none"


def test_pulls_up_and_waits(read) -> None:
    s = read("A cow stands on the road. The camera car pulls up and waits.")
    assert s["E"].spec.reaction == "brake" and s["E"].spec.speed > 0


@pytest.mark.parametrize(
    "text",
    [
        "The ego emergency brakes.",
    ],
)
def test_slams_on(read, text: str) -> None:
    assert read(f"A tractor pulls out of a field. {text}")["E"].spec.hard


def test_a_title_about_merging(read) -> None:
    s = read(
        "Cooperative merging test. A van comes down the on-ramp. The ego in the right lane slows down for the van."
    )
    assert not any(p.action == "lane_change" for p in s["E"].spec.phases)


def test_either_of_two(read) -> None:
    s = read("Ego is stuck behind a tractor or a coach on a bendy road.")
    assert [o.spec.type for o in s.objects] == ["truck"] and s["R"].spec.kind == "curve"


def test_the_title_names_the_driver(read) -> None:
    s = read("Ghost driver, late at night. A pickup comes the wrong way in the ego's lane of the motorway. Ego brakes.")
    assert [o.spec.type for o in s.objects] == ["truck"]
