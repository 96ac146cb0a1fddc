"""One step of what somebody does is another, later, or left out; the other steps stay."""

from tests.interpret.demanded import changed

TRUCK = (
    "Ego drives at 90 km/h on a three-lane motorway. A truck ahead of ego changes to the left lane after 3 s. "
    "Then it changes to the right lane again after 6 s. A car follows ego."
)


def phases(s) -> list[str]:
    return [
        f"{p.action}{f' {p.side}' if p.side else ''}{f' {p.duration:g} s' if p.duration else ''}"
        f"{f' at {p.trigger.value:g}' if p.trigger else ''}"
        for p in s["O1"].spec.phases
    ]


FIRST, SECOND = "cut_out left at 3", "cut_in right at 6"


def test_a_wait_before_the_only_turn_is_a_wait(read) -> None:
    s = read("Ego approaches an intersection at 40 km/h and turns right. A bus comes from the left.")
    steps = changed(s, "ego should wait for 3 seconds before turning")["E"].spec.phases
    assert "wait" in [p.action for p in steps]


def test_a_lane_change_is_no_lane(read) -> None:
    s = changed(read(TRUCK), "two lanes")
    assert s["R"].spec.lanes == 2
    assert phases(s) == [FIRST, SECOND]
