"""The many ways in which a demand is put: each changes S as its plainest wording does."""

import pytest

from c2s_engine.interpret.turn import route
from tests.interpret.demanded import MOTORWAY, ROW, assert_same

STREET = "Ego follows a taxi at 50 km/h. The taxi brakes hard and a woman crosses from the right."
JUNCTION = (
    "Ego approaches a signalised intersection at 40 km/h and turns left. An oncoming lorry goes straight on. "
    "A motorcycle follows ego."
)


CELLS = [
    # wishes, remarks, requests, passives
    # as fast as another, by so much
    # how far
    # what somebody does, by a noun, and what he does not
    (
        MOTORWAY,
        "the van should change lanes to the left",
        "lane change to the left by the van | a lane change of the van to the left | lane change left for the van | "
        "the van should not brake but change lanes to the left | can the van change lanes to the left? | "
        "instead of braking, the van changes lanes to the left",
    ),
    # when
    # two demands in one
    # where
    # how many
    # two who swap
    # ego, and the place
    (
        STREET,
        "ego does not react",
        "ego does nothing | ego just drives on | remove ego's reaction | no reaction of ego",
    ),
    # who is named besides, or meant by "the other two"
    (
        ROW,
        "a dog crosses the road from the right",
        "together with the boy a dog crosses the road from the right | besides the boy, a dog crosses the road from "
        "the right | along with the boy a dog crosses the road from the right",
    ),
    # ego does no longer what it did
    (
        STREET,
        "ego should not follow",
        "ego no longer follows the taxi | ego doesnt follow the taxi any more | ego stops following it",
    ),
    # too slow, too fast
    (
        MOTORWAY,
        "the van is too slow",
        "that van is far too slow | the van is too slow for our test | the van drives much too slowly | "
        "van is too slow | our van goes really too slow",
    ),
    # where it all happens, and who is nobody in particular
    (
        MOTORWAY,
        "at night",
        "it all happens at night | the whole scene takes place at night | everything should take place at night",
    ),
    (
        STREET,
        "the woman is hidden by two parked cars",
        "the woman comes out from behind parked cars | the woman comes from between parked cars",
    ),
    # not at once, but at that moment
    (STREET, "the woman crosses later", "the woman should not cross so early | the woman doesn't start right away"),
    # one after the other, and the moment behind it
    (
        MOTORWAY,
        "the van should stop after 5 s",
        "the van should stop, and that after 5 s | the van has to stop, 5 seconds after the start | "
        "the van must stop, and this 5 s after the start",
    ),
    (
        MOTORWAY,
        "first the van changes lanes to the left, then it brakes",
        "the van first changes lanes to the left and only after that brakes | "
        "the van should change lanes to the left and only then brake",
    ),
    # the whole scene, behind what one does
    (
        MOTORWAY,
        "ego should evade. at night",
        "ego should evade, and the whole thing at night | when the van slows ego should not brake but evade, and it "
        "is night | ego evades, and everything at night | ego evades and the scene is at night",
    ),
    # what the junction is controlled by
    (
        JUNCTION,
        "the junction has stop signs",
        "replace the traffic lights by stop signs | stop signs instead of traffic lights | no lights but stop signs | "
        "change the signals to stop signs",
    ),
    (JUNCTION, "ego has a green light", "we have green | I get a green light | we have a green signal"),
    (
        MOTORWAY,
        "add a 60 sign on the right",
        "put up a speed limit sign 60 on the right side of the road | there should be a speed sign 60 | "
        "put a sign with a limit of 60 at the right side of the road | add a sign that says 60 on the right",
    ),
]


@pytest.mark.parametrize(("scene", "plain", "wordings"), CELLS, ids=[plain for _, plain, _ in CELLS])
def test_each_wording_is_the_plain_demand(read, scene: str, plain: str, wordings: str) -> None:
    assert_same(read(scene), plain, wordings)


@pytest.mark.parametrize(
    "text",
    [
        "can ego still stop in time?",
        "could the van see ego?",
        "is the van faster than ego?",
        "who is hidden behind whom",
        "can the car be seen from the start?",
        "how far away is the van when it brakes?",
    ],
)
def test_a_question_stays_one(read, text: str) -> None:
    assert route(text, read(MOTORWAY)).kind == "question"


@pytest.mark.parametrize("text", ["not that", "30 is a lot for a van"])
def test_what_is_not_understood_changes_nothing(read, text: str) -> None:
    assert not route(text, read(MOTORWAY)).edits
