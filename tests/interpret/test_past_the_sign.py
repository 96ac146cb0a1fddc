"""Who goes past a stop sign, a landmark or onto the shoulder; whom ego waves through."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "The car went past the stop sign without stopping.",
    ],
)
def test_who_goes_past_a_stop_sign_runs_it(read, text: str) -> None:
    structure = read(text)
    assert actions(structure["E"])[0] == "run_stop"
    assert all("overtake" not in actions(o) for o in structure.objects)


@pytest.mark.parametrize(
    "text",
    [
        "The van went past the bus stop and hit a pedestrian.",
        "The van drove past the school and hit a pedestrian.",
        "The van came by the church and hit a pedestrian.",
    ],
)
def test_who_goes_past_a_landmark_overtakes_nobody(read, text: str) -> None:
    assert all("overtake" not in actions(c) for c in (read(text)["E"], *read(text).objects))


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("The van behind me shot out to the right onto the hard shoulder.", "right"),
        ("A van ahead swerved to the left into the ditch.", "left"),
        ("A van behind us veered right onto the verge and came to rest next to us.", "right"),
    ],
)
def test_who_swerves_onto_the_shoulder_leaves_the_road(read, text: str, side: str) -> None:
    phase = read(text).objects[0].spec.phases[0]
    assert (phase.action, phase.side) == ("leave_road", side)


def test_whom_ego_waves_through_it_lets_go_first(read) -> None:
    spec = read("Ego waves the car from the right through and then goes on.")["E"].spec
    assert (spec.reaction, spec.react_to) == ("yield", "O1")
