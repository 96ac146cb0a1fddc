"""What people of many sorts type upon a scene: one of a row, ends of the run, limits, who gives up, who is meant."""

from typing import Any

import pytest

from c2s_engine.interpret.turn import route
from tests.interpret.demanded import after, assert_same, specs

STREET = (
    "Ego drives at 30 km/h along a street with three parked cars on the right. A child runs out from between the "
    "parked cars. A car follows ego."
)
LIGHTS = (
    "Ego approaches an intersection with traffic lights at 40 km/h and turns right. Two pedestrians cross the road "
    "that ego turns into. A bus comes from the left."
)
MOTORWAY = (
    "Ego drives at 110 km/h in the middle lane of a three-lane motorway. A van in the right lane 30 m ahead cuts in in "
    "front of ego when ego is 20 m behind it. A car follows ego."
)
TRACTOR = (
    "On a rural road ego drives at 80 km/h behind a tractor that drives at 30 km/h. An oncoming car approaches at "
    "90 km/h."
)
OVERTAKER = (
    "On a two-lane motorway ego drives in the right lane at 100 km/h behind a truck at 80 km/h. A car overtakes ego on "
    "the left and then cuts in between ego and the truck. A motorcycle follows ego 20 m behind."
)
BUS_LANE = "On a two-lane road ego drives at 70 km/h. A bus drives in the right lane next to ego at 60 km/h."
CLOSER = "On a city street ego drives at 50 km/h in the rain behind a van. A woman waits on the right sidewalk."

SAME = [
    # one of those who are told of together
    # a speed by the limit of the road
    # an end of the run
    # one for another
    (OVERTAKER, "the gap to the motorcycle is 10 m", "gap between ego and motorcycle 10 m"),
    # who gives up what he does
    # sideways without a meeting of roads
    # a condition that no comma ends
]


@pytest.mark.parametrize(("scene", "plain", "wordings"), SAME, ids=[plain for _, plain, _ in SAME])
def test_each_wording_is_the_plain_demand(read, scene: str, plain: str, wordings: str) -> None:
    assert_same(read(scene), plain, wordings)


FIELDS: list[tuple[str, str, dict[str, Any]]] = [
    # one who is counted out of his row keeps his place
    (STREET, "one of the parked cars is a van", {"O1.count": 2, "O4.type": "van", "O4.placement.position": "parked"}),
    (LIGHTS, "make one of them a child", {"O1.count": 1, "O3.type": "child", "O2.type": "bus"}),
    (
        LIGHTS,
        "only one of the pedestrians crosses, the other waits",
        {"O1.phases.0.action": "stationary", "O3.speed": 1.4},
    ),
    # who is behind the intersection can be told of, and stays there
    (LIGHTS, "the bus stops", {"O2.phases.-1.action": "stop"}),
    (LIGHTS, "pedestrians should run", {"O1.speed": 2.8, "O1.placement.position": "intersection_exit"}),
    (LIGHTS, "a car in front of ego also turns right", {"E.phases.0.action": "turn_right", "O3.type": "car"}),
    # a stop keeps its time, and ego its way
    (LIGHTS, "ego stops for 2 s and then turns", {"E.phases.1.duration": 2.0, "R.manoeuvre": "right"}),
    (LIGHTS, "ego should wait for 3 seconds before turning", {"E.phases.1.duration": 3.0, "E.reaction": "none"}),
    # the moment of an act that is told again among others
    (
        MOTORWAY,
        "van first cuts in, then brakes to 80",
        {"O1.phases.0.trigger.value": 20.0, "O1.phases.1.action": "brake"},
    ),
    (MOTORWAY, "the cutter-in should brake right after cutting in", {"O1.phases.0.trigger.value": 20.0}),
    # who comes from the other lane cuts in from there
    (
        MOTORWAY,
        "what if the van came from the left",
        {"O1.placement.position": "left_lane", "O1.phases.0.side": "right"},
    ),
    # ends of the run
    (TRACTOR, "end the run when ego is 5 m from the tractor", {"T.terminate_when.0.maximum": 5.0}),
    (OVERTAKER, "end the run when the car cuts in", {"T.terminate_when.0.action": "cut_in"}),
    (TRACTOR, "stop the simulation after 20 seconds", {"T.duration": 20.0}),
    # what is said of those who were told of before
    (
        LIGHTS,
        "pedestrians walk twice as fast and come 2 seconds later",
        {"O1.phases.0.trigger.value": 2.0, "O1.speed": 2.8},
    ),
    (BUS_LANE, "the bus should be a car and 10 slower than ego", {"O1.type": "car"}),
    (BUS_LANE, "the bus changes to a truck", {"O1.type": "truck"}),
    (TRACTOR, "the tractor should be as fast as the oncoming car", {"O1.type": "truck", "O1.speed": 25.0}),
    (TRACTOR, "everybody slower except ego", {"E.speed": 22.22}),
    (OVERTAKER, "when the car cuts in ego has to brake with 5 m/s2", {"E.phases.0.trigger.action": "cut_in"}),
    (CLOSER, "first the woman crosses, then the van brakes", {"O2.phases.0.action": "cross_road"}),
    (OVERTAKER, "the vehicle that cuts in should brake hard afterwards", {"O2.phases.2.action": "brake"}),
]


@pytest.mark.parametrize(
    ("scene", "text", "others"),
    [
        (STREET, "one of the parked cars is a van", "E O2 O3"),
        (LIGHTS, "ego stops for 2 s and then turns", "R O1 O2"),
        (TRACTOR, "terminate when ego hits the tractor", "E R O1 O2"),
        (OVERTAKER, "the overtaker cancels and drops back", "E R O1 O3"),
        (BUS_LANE, "ego goes to the right", "O1"),
    ],
)
def test_nothing_else_changes(read, scene: str, text: str, others: str) -> None:
    structure = read(scene)
    turn = route(text, structure)
    now = after(structure, text) if turn.edits else specs(structure)
    assert {cid: now.get(cid) for cid in others.split()} == {cid: specs(structure)[cid] for cid in others.split()}


@pytest.mark.parametrize(
    ("scene", "text", "kind"),
    [
        (MOTORWAY, "lets do it at night", "edit"),
        (LIGHTS, "why does the bus come from the left?", "question"),
        (LIGHTS, "a pedestrian is crossing the side road while ego waits", "edit"),
        (LIGHTS, "does it rain?", "question"),
    ],
)
def test_what_a_turn_is(read, scene: str, text: str, kind: str) -> None:
    assert route(text, read(scene)).kind == kind
