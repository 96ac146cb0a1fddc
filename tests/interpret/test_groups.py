"""Groups and their members, and drivers on the wrong side of things."""

from typing import Any

import pytest

from c2s_engine.structure.components import Structure


def spec(structure: Structure, cid: str) -> Any:
    return structure[cid].spec


def acts(structure: Structure, cid: str) -> list[str]:
    return [p.action for p in spec(structure, cid).phases]


@pytest.mark.parametrize(
    ("text", "rest", "own"),
    [
        ("Two cars drive ahead of the ego. The second one brakes hard.", 1, "brake"),
        ("Three cars are parked on the right. The second car pulls out in front of the ego.", 2, "enter_road"),
        ("Two motorcycles follow ego. The second overtakes it.", 1, "overtake"),
        ("Three trucks drive in the right lane. The last of them changes to the left lane ahead of ego.", 2, "cut_in"),
    ],
)
def test_a_member_with_acts_of_its_own_leaves_its_group(read, text: str, rest: int, own: str) -> None:
    s = read(text)
    assert len(s.objects) == 2
    told = next(c for c in s.objects if own in acts(s, c.id))
    other = next(c for c in s.objects if c is not told)
    assert (spec(s, told.id).count, spec(s, other.id).count) == (1, rest)


@pytest.mark.parametrize(
    "text",
    [
        "A vehicle travelling in the wrong direction approaches the ego in its lane on a motorway.",
        "A wrong-way driver comes towards ego on the freeway.",
        "A pickup going against the flow of traffic on the dual carriageway hits V1 head-on.",
        "A cyclist is riding against traffic in our lane. We brake.",
        "A car comes at us head-on in our lane on the motorway.",
    ],
)
def test_who_drives_the_wrong_way_faces_ego_in_its_lane(read, text: str) -> None:
    place = spec(read(text), "O1").placement
    assert (place.position, place.facing) == ("ahead", "against")


@pytest.mark.parametrize(
    ("text", "positions"),
    [
        (
            "The ego car merges onto the highway from an on-ramp between a truck and a sedan.",
            ["left_lane", "left_lane"],
        ),
        ("A bus is on its right, a car on its left. Ego drives in the middle lane.", ["right_lane", "left_lane"]),
        ("A car parked in the ego's lane blocks the way.", ["ahead"]),
        ("The right lane is blocked by a skip. Ego drives around it.", ["ahead"]),
        ("Ego waits to turn left, the oncoming lane is full of cars.", ["oncoming_lane"]),
        ("A truck reverses out of a yard on the left, ego brakes.", ["roadside"]),
        ("The ego turns right at a junction. A cyclist from behind on its right rides straight on.", ["roadside"]),
    ],
)
def test_where_others_are(read, text: str, positions: list[str]) -> None:
    s = read(text)
    assert [spec(s, c.id).placement.position for c in s.objects] == positions
