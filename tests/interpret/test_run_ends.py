"""When the run is over: what a text says of the test's end is a condition of T, and nothing that happens."""

import pytest


@pytest.mark.parametrize(
    ("text", "kinds", "duration"),
    [
        (
            "Ego drives at 60 km/h behind a lorry. The lorry brakes. The test ends when ego has come to a standstill "
            "or has hit the lorry.",
            {"collision", "stopped"},
            None,
        ),
    ],
)
def test_the_end_of_the_run(read, text: str, kinds: set[str], duration: float | None) -> None:
    s = read(text)
    end = s.restrictions.spec
    assert ({c.kind for c in end.terminate_when}, end.duration) == (kinds, duration)
    assert all(c.other == "O1" for c in end.terminate_when if c.kind == "collision")
    assert not {"collide", "stop"} & {p.action for p in s.ego.spec.phases}


@pytest.mark.parametrize(
    "text",
    [
        "The trip ends when a truck hits ego from behind at a red light.",
        "The lane ends after 200 m and ego has to merge into the left lane.",
        "Ego stops after 20 s because a child runs out.",
        "The test ends 2 s after the car has hit ego. A car runs a red light at a crossroads.",
    ],
)
def test_what_is_no_end_of_the_run(read, text: str) -> None:
    end = read(text).restrictions.spec
    assert (end.terminate_when, end.duration) == ((), None)


@pytest.mark.parametrize(
    "text",
    [
        "Ego passes if there is no contact. A child runs into the road from behind a van.",
        "Fail criterion: collision with the target. Ego drives at 50 km/h, the target at 20 km/h.",
    ],
)
def test_what_is_only_judged_does_not_happen(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.phases == () and s.restrictions.unmet


def test_what_is_passed_on_a_condition(read) -> None:
    s = read("Ego passes the lorry if there is no oncoming traffic.")
    assert [p.action for p in s.ego.spec.phases] == ["overtake"]
