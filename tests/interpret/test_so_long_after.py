"""What comes "2 s later" counts from what was told before, not from the start."""

import pytest

LEAD = "The car ahead brakes"
VAN = "a van in the left lane cuts in in front of ego"


@pytest.mark.parametrize(
    "text",
    [
        f"{LEAD}. 2 s later {VAN}.",
        f"{LEAD}, and 2 s later {VAN}.",
        f"{LEAD}. Two seconds after that, {VAN}.",
    ],
)
def test_so_long_after_another(read, text: str) -> None:
    objects = {o.spec.type: (o.id, o.spec.phases) for o in read(text).objects}
    lead = next(i for i, phases in objects.values() if any(p.action == "brake" for p in phases))
    pause, cut_in = objects["van"][1]
    assert (pause.action, pause.duration, pause.trigger.kind, pause.trigger.of) == ("keep_lane", 2.0, "action", lead)
    assert (cut_in.action, cut_in.trigger) == ("cut_in", None)


def test_who_is_on_foot_comes_after_the_other(read) -> None:
    objects = read("A child runs across from the right. Half a second later a dog runs across the road.").objects
    assert [(p.action, p.trigger.of) for p in objects[1].spec.phases] == [("cross_road", objects[0].id)]


@pytest.mark.parametrize(
    "text", ["Ego drives at 50 km/h. 2 s later the car ahead brakes.", "The car ahead brakes after 2 s."]
)
def test_from_the_start_where_nothing_went_before(read, text: str) -> None:
    phases = read(text).objects[0].spec.phases
    assert [(p.action, p.trigger.kind, p.trigger.value) for p in phases] == [("brake", "time", 2.0)]
