"""What drivers tell: who follows, is hit from behind by nobody named, gives up a pass, is overtaken on a side."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "As I pulled out to overtake a bus, an oncoming motorcycle appeared and I had to brake and drop back.",
        "The ego pulls out to overtake a tractor but drops back because of an oncoming car.",
        "I pulled out to pass a van, saw an oncoming lorry and tucked back in behind it.",
    ],
)
def test_who_drops_back_does_not_overtake(read, text: str) -> None:
    assert "overtake" not in actions(read(text)["E"])


@pytest.mark.parametrize(
    ("text", "own", "others"),
    [
        ("The bus I was following stopped without warning.", ["follow"], ["stop"]),
    ],
)
def test_a_relative_clause_without_a_pronoun(read, text: str, own: list[str], others: list[str]) -> None:
    structure = read(text)
    assert (actions(structure["E"]), actions(structure.objects[0])) == (own, others)


@pytest.mark.parametrize(
    "text",
    [
        "The ego brakes for a dog and is rear-ended.",
        "Somebody stepped off the kerb without looking, so I braked and was hit from behind.",
        "The car in front braked, ego braked too and was rear-ended.",
    ],
)
def test_nobody_named_hits_ego_from_behind(read, text: str) -> None:
    last = read(text).objects[-1].spec
    assert (last.placement.position, [p.action for p in last.phases]) == ("behind", ["collide"])


@pytest.mark.parametrize(
    "text",
    [
        "The ego vehicle is overtaken on the right by a motorcycle, which then swerves in front of it and brakes.",
        "Ego is passed on the right by a van, which then cuts in and brakes.",
        "The ego is passed by a motorcycle on the right which then cuts in and brakes.",
    ],
)
def test_who_overtakes_on_a_side_and_cuts_in(read, text: str) -> None:
    spec = read(text).objects[0].spec
    assert spec.placement.position == "right_lane"
    assert [p.action for p in spec.phases] == ["overtake", "cut_in", "brake"]


@pytest.mark.parametrize(
    ("text", "done"),
    [
        ("A deer ran out, the driver swerved, went off the road and hit a tree.", ["swerve", "leave_road", "collide"]),
        ("Ego is forced off the road by an overtaking truck.", ["leave_road"]),
    ],
)
def test_what_ego_does(read, text: str, done: list[str]) -> None:
    structure = read(text)
    assert actions(structure["E"]) == done
    assert structure.objects


def test_times_of_phases(read) -> None:
    s = read("At t=3 s the car in front brakes; at t=6 s it stops.")
    assert [(p.action, p.trigger.value) for p in s.objects[0].spec.phases] == [("brake", 3), ("stop", 6)]
