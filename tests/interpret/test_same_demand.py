"""One demand in many wordings, upon scenes with several of one type, too: each changes S as the plainest one does."""

import pytest

from c2s_engine.interpret.turn import route
from tests.interpret.demanded import LIGHTS, after, assert_same

STREET = "In heavy rain ego follows a car at 50 km/h. The car brakes and a pedestrian crosses from the right."
CARS = (
    "At an intersection with traffic lights ego goes straight on at 50 km/h. A car comes from the left and runs the "
    "red light. Another car comes from the right and stops. A third car follows ego."
)
PAIR = "Ego approaches a crosswalk at 30 km/h. An old woman crosses from the left and a man crosses from the right."
ROW = (
    "Ego drives at 30 km/h past three cars parked on the right. A child runs out from behind them. "
    "A bus comes the other way."
)


CELLS = [
    # several of one type are told apart
    (
        PAIR,
        "O1 starts when ego is 15 m away. O2 starts when ego is 15 m away",
        "both pedestrians start when ego is 15 m away | the two pedestrians start when ego is 15 m away",
    ),
    (CARS, "O3 is a van. O3 at 5 m", "make the follower a van, 5 m behind | the car behind ego is a van, 5 m away"),
    (CARS, "remove O2", "remove the car which stops | the one that stops can go"),
    # for whom, and by whom
    (ROW, "the parked cars are on the left", "move the row to the left | let the cars be parked on the left side"),
    # when
    (
        LIGHTS,
        "O2 turns right after 5 s",
        "after 5 s the motorcycle turns right | the motorcycle turns to the right after 5 seconds",
    ),
    # two or three at once
    (STREET, "the car at 30 km/h. no rain", "the car at 30 and no rain | no rain and the car at 30 km/h"),
    (LIGHTS, "at night. remove the motorcycle", "at night and no motorcycle | night, without the motorcycle"),
    (LIGHTS, "the truck slower. the motorcycle faster", "truck slower and motorcycle faster"),
    (ROW, "the parked cars are on the left. the child from the left", "row on the left, child as well"),
    # the sky
    # one thing for another
    (
        STREET,
        "the lead stops, waits 3 s and then starts",
        "the lead brakes, stands for 3 seconds and then drives off again",
    ),
]


@pytest.mark.parametrize(("scene", "plainest", "wordings"), CELLS, ids=[cell[1] for cell in CELLS])
def test_the_same_demand(read, scene: str, plainest: str, wordings: str) -> None:
    assert_same(read(scene), plainest, wordings)


def test_more_is_told_than_who_is_new(read) -> None:
    """Who is there does something besides: that is changed, too."""
    before = read("On a three-lane motorway ego drives at 120 km/h. A van 30 m ahead brakes.")
    now = after(before, "A broken truck stands in our lane 150 m ahead and the van swerves around it to the right.")
    assert now["O2"].type == "truck"  # type: ignore[attr-defined]
    assert [p.action for p in now["O1"].phases] != ["brake"]  # type: ignore[attr-defined]


# type: ignore[attr-defined]


# type: ignore[attr-defined]


@pytest.mark.parametrize(
    "text",
    [
        "ego turns right not left and a second motorcycle comes from the left",
        "the right lane is closed by a construction site 200 m ahead, ego has to stay in the middle",
        "how about making the truck a bus?",
    ],
)
def test_no_new_scenario_and_no_question(read, text: str) -> None:
    turn = route(text, read(LIGHTS))
    assert turn.kind == "edit" and turn.edits


@pytest.mark.parametrize(
    "text", ["A cyclist follows ego.", "Ego is followed by a cyclist.", "A cyclist follows the ego vehicle at 20 km/h."]
)
def test_a_cyclist_follows(read, text: str) -> None:
    spec = read(text)["O1"].spec
    assert (spec.placement.position, [p.action for p in spec.phases]) == ("behind", ["follow"])


@pytest.mark.parametrize(
    "text",
    [
        "Ego passes three parked cars. The second of the parked cars pulls out.",
        "Three vans are parked on the left. The last of the parked vans drives off.",
    ],
)
def test_one_of_the_parked_ones(read, text: str) -> None:
    assert [o.spec.count for o in read(text).objects] == [2, 1]
