"""What somebody waits for begins what he does next: a distance that ends a wait, or what another has done."""

import pytest


@pytest.mark.parametrize(
    ("text", "action", "metres"),
    [
        ("Ego drives at 40 km/h. A man waits at the kerb until ego is 20 m away, then crosses.", "cross_road", 20),
        ("A cyclist waits until the distance to ego is below 15 m and then enters the road.", "cross_road", 15),
        ("A woman will cross in front of ego only when the distance to ego is less than 18 m.", "cross_road", 18),
    ],
)
def test_a_distance_ends_the_wait(read, text: str, action: str, metres: float) -> None:
    phases = read(text).objects[0].spec.phases
    assert [p.action for p in phases] == [action]
    assert phases[0].trigger.kind == "distance" and phases[0].trigger.value == metres


@pytest.mark.parametrize(
    ("text", "waits", "of", "awaited"),
    [
        ("Ego drives at 50 km/h. A car ahead brakes. Once the car has stopped, a man crosses.", "O2", "O1", "stop"),
        ("As soon as a child crosses, the bus in the oncoming lane stops. Ego brakes.", "O2", "O1", "cross_road"),
        ("A truck ahead of ego brakes after a woman has crossed.", "O1", "O2", "cross_road"),
    ],
)
def test_what_another_has_done(read, text: str, waits: str, of: str, awaited: str) -> None:
    trigger = read(text)[waits].spec.phases[-1].trigger
    assert (trigger.kind, trigger.of, trigger.action) == ("action", of, awaited)


def test_what_happens_beside_is_no_trigger(read) -> None:
    structure = read("Ego drives at 50 km/h. While a truck ahead brakes, a car on the left cuts in.")
    assert all(p.trigger is None for c in structure.objects for p in c.spec.phases)


@pytest.mark.parametrize(
    ("text", "phases"),
    [
        ("Ego drives at 50 km/h. The car ahead stops for 4 s and continues.", ["stop", "wait", "start"]),
        ("Ego drives at 50 km/h. The van ahead stops and sets off again after 5 s.", ["stop", "wait", "start"]),
        ("Ego drives at 50 km/h. The bus ahead stops and then drives on.", ["stop", "start"]),
        (
            "A taxi from the right stops at the sign for 2 s and then goes straight on.",
            ["stop", "wait", "go_straight"],
        ),
    ],
)
def test_who_stops_and_goes_on(read, text: str, phases: list[str]) -> None:
    found = read(text).objects[0].spec.phases
    assert [p.action for p in found] == phases
    told = [p.duration for p in found if p.action == "wait"]
    assert told in ([], [4.0], [5.0], [2.0]) and bool(told) == ("wait" in phases)
