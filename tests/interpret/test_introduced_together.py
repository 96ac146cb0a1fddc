"""Road users introduced together and told apart then; labels of people and of parties."""

import pytest


def acts(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("P-1 was crossing the street in the crosswalk. V-1 was turning left and struck P-1.", "pedestrian"),
        ("Ped 1 ran across the road from the left in front of V1.", "pedestrian"),
        ("B1 was riding east in the bike lane. V1 turned right across the path of B1.", "bicycle"),
        ("Vehicle 1 was driving along the B1 when a deer crossed.", "animal"),
    ],
)
def test_labels_of_people(read, text: str, kind: str) -> None:
    assert [o.spec.type for o in read(text).objects] == [kind]


def test_numbered_actors(read) -> None:
    s = read("NPC1 drives ahead of ego. NPC2 overtakes NPC1.")
    assert len(s.objects) == 2 and s["O2"].spec.phases[0].target == "O1"
    s = read("Actor 1 is a truck ahead of the ego. Actor 2 is a pedestrian that crosses the road. Actor 1 brakes.")
    assert [(o.spec.type, acts(o)) for o in s.objects] == [("truck", ["brake"]), ("pedestrian", ["cross_road"])]


def test_who_is_let_by_was_not_behind(read) -> None:
    s = read("We were approaching a roundabout when a cyclist came from the left. We let him pass.")
    assert "overtake" not in acts(s["O1"]) and s["O1"].spec.placement.position == "crossing_left"
    s = read("A faster car approaches from behind. The ego lets it pass.")
    assert "overtake" in acts(s["O1"])
