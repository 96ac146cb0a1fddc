"""Notes that open with what happens, and only then name who is there."""

import pytest


@pytest.mark.parametrize(
    ("text", "position", "gap"),
    [
        ("cutin L->R @ 15 m, ego 100 km/h, target 80 km/h", "left_lane", 15),
        ("Cut-in from the right, ego 100 km/h, target 80 km/h.", "right_lane", None),
        ("Cut-in scenario with ego at 100 km/h and a truck at 80 km/h.", "left_lane", None),
        ("Late cut-in on a motorway. Ego 110 km/h, a van 90 km/h.", "left_lane", None),
    ],
)
def test_who_cuts_in(read, text: str, position: str, gap: float | None) -> None:
    s = read(text)
    assert len(s.objects) == 1
    other = s.objects[0].spec
    assert [p.action for p in other.phases] == ["cut_in"]
    assert (other.placement.position, other.placement.gap) == (position, gap)


def test_who_cuts_out(read) -> None:
    s = read("cutout R->L @ 30 m, ego 80, lead 80, stopped car ahead")
    assert [[p.action for p in o.spec.phases] for o in s.objects] == [["cut_out"], ["stationary"]]


@pytest.mark.parametrize(
    "text", ["Cut-in. A car cuts in ahead of ego from the left.", "Cut-ins are frequent. Ego drives behind a bus."]
)
def test_what_is_told_again_or_of_nobody(read, text: str) -> None:
    s = read(text)
    assert len(s.objects) == 1 and sum(p.action == "cut_in" for p in s.objects[0].spec.phases) == ("A car" in text)


@pytest.mark.parametrize(
    "text",
    [
        "A car leads, ego follows at 60 km/h. A pickup behind ego overtakes both.",
        "Ego drives behind a tractor. A motorbike behind ego overtakes both of them.",
        "Ego drives behind a tractor. A motorbike comes from behind and passes them both.",
    ],
)
def test_who_overtakes_ego_and_the_one_ahead(read, text: str) -> None:
    s = read(text)
    passes = s.objects[1].spec.phases
    assert [(p.action, p.target) for p in passes] == [("overtake", "ego"), ("overtake", "O1")]
