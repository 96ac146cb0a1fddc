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
    (
        MOTORWAY,
        "set the speed of the van to 60 km/h",
        "I'd rather see the van at 60 | what I'd rather see is the van at 60 km/h | I want 60 km/h for the van | "
        "120 is far too much for the van, 60 will do | the van shouldn't drive 120 but 60 | 60 for the van please | "
        "drop the van to 60 km/h | could the van do 60 instead? | the van needs to go 60 km/h | "
        "the speed of the van has to be reduced to 60 km/h | whoever is in front of ego should go 60 km/h",
    ),
    (
        MOTORWAY,
        "replace the van by a bus",
        "the van is to be replaced by a bus | can the van be replaced with a bus | the van needs to be a bus | "
        "I'd rather have a bus than a van | the van is too small, a bus would be better | not a van but a bus | "
        "turn the van into a bus | substitute a bus for the van | set the type of the van to bus | "
        "we need a bus, not a van | a bus where the van is | a bus would be better than a van | no van, a bus",
    ),
    (
        MOTORWAY,
        "remove the van",
        "the van has to be removed | have the van removed | can the van be removed? | same scene without the van | "
        "try it without the van | let the van disappear | only the car should stay | keep only the car | "
        "nobody ahead of ego | the van is one too many | I would like the van to go away",
    ),
    (MOTORWAY, "remove everything but ego", "remove all | ego alone | both can go | an empty road | nobody but ego"),
    # as fast as another, by so much
    (
        MOTORWAY,
        "ego as fast as the car",
        "ego has the speed of the car | match ego's speed to the car | same speed for ego and the car | "
        "ego's speed = the car's speed | give ego the car's speed | ego and the car at equal speeds",
    ),
    (
        MOTORWAY,
        "the van 10 km/h slower than ego",
        "the van 10 slower than ego | the van's speed is 10 km/h below ego's | the van at ego's speed minus 10 km/h | "
        "the van with 10 km/h less than ego",
    ),
    # how far
    (
        MOTORWAY,
        "the van at 60 m",
        "60 m instead of 30 m to the van | change the distance to the van from 30 to 60 m | make it 60 m to the van | "
        "30 m further away for the van | the van is 30 m too close | twice the distance to the van | "
        "place the van at a distance of 60 m | the van should be placed 60 m ahead of ego",
    ),
    # what somebody does, by a noun, and what he does not
    (
        MOTORWAY,
        "the van should change lanes to the left",
        "lane change to the left by the van | a lane change of the van to the left | lane change left for the van | "
        "the van should not brake but change lanes to the left | can the van change lanes to the left? | "
        "instead of braking, the van changes lanes to the left",
    ),
    (
        MOTORWAY,
        "the van should not brake",
        "I don't want the van to brake | don't let the van brake | no braking by the van | remove the van's braking | "
        "the van no longer brakes | the van without braking | cancel the braking | the van just drives on | "
        "the van keeps its speed | the van isn't supposed to brake | remove the braking of the van",
    ),
    (STREET, "the woman stands still", "the woman just stands there | make her stand still"),
    # when
    (
        STREET,
        "the woman crosses when ego is 20 m away",
        "the woman starts at 20 m | trigger the crossing at 20 m | at 20 m the woman crosses | she starts at 20 m | "
        "the woman waits until ego is within 20 m | ego at 20 m: the woman crosses | release the woman at 20 m | "
        "once ego is closer than 20 m, the woman starts | the crossing should be triggered when ego is 20 m away | "
        "when ego gets within 20 m of the woman, she crosses | the woman must wait until ego is 20 m away",
    ),
    (
        STREET,
        "the woman crosses after 3 s",
        "the woman waits for 3 seconds before crossing | delay the woman by 3 s | 3 s later the woman crosses | "
        "the woman should wait 3 s | a delay of 3 s for the woman | 3 seconds into the scene the woman crosses",
    ),
    (
        STREET,
        "the woman crosses when the ttc is 2 s",
        "ttc 2 s for the woman | at a ttc of 2 s the woman crosses | the woman crosses 2 s before ego reaches her | "
        "the woman starts when ego is 2 s away | when ttc < 2 s the woman crosses | the woman waits until ttc 2 s",
    ),
    (
        STREET,
        "the woman crosses when the taxi brakes",
        "when the taxi brakes the woman should cross | the woman waits until the taxi brakes | "
        "the woman waits for the taxi to brake | after the taxi has braked the woman crosses",
    ),
    (
        MOTORWAY,
        "the van brakes after 4 s",
        "braking after 4 s | the braking is to start at 4 s | the van must not brake before 4 s",
    ),
    # two demands in one
    (
        MOTORWAY,
        "the van at 80 km/h. the van 50 m ahead",
        "the van at 80 km/h and 50 m ahead | the van 50 m ahead at 80 km/h | the van should be 50 m away and go 80",
    ),
    # where
    (
        STREET,
        "the woman comes from the left",
        "switch the side of the woman | the woman is on the wrong side | not right but left | could she come from the "
        "left? | the woman's side: left | woman left",
    ),
    # how many
    (
        ROW,
        "five parked cars",
        "there should be five parked cars | not three but five parked cars | the number of parked cars is 5 | "
        "two more parked cars | extend the row to five cars | increase the number of parked cars to five | "
        "three are not enough, five parked cars | ego passes a row of five parked cars | parked cars: 5",
    ),
    (
        ROW,
        "only two parked cars",
        "one parked car less | remove one of the parked cars | one car less in the row | reduce the row to two cars",
    ),
    (ROW, "the boy is not hidden", "don't hide the boy | nothing hides the boy | ego sees the boy | no occlusion"),
    # two who swap
    (
        MOTORWAY,
        "swap the van and the car",
        "the van and the car should swap places | swap the positions of the car and the van | exchange van and car",
    ),
    # ego, and the place
    (
        JUNCTION,
        "ego turns right",
        "I turn right | turn right instead of left | let me turn right | right turn for ego | ego right",
    ),
    (
        STREET,
        "ego does not react",
        "ego does nothing | ego just drives on | remove ego's reaction | no reaction of ego",
    ),
    (STREET, "make ego a bus", "I'm in a bus | a bus as ego | my car should be a bus | we drive a bus | ego in a bus"),
    # who is named besides, or meant by "the other two"
    (
        MOTORWAY,
        "swap the van and the car",
        "swap the other two | the other two swap places | the two others should swap places",
    ),
    (
        MOTORWAY,
        "both at 90 km/h",
        "the other two should drive 90 | the van and the car at 90 | the van and the car should both drive 90 km/h",
    ),
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
    (
        JUNCTION,
        "the motorcycle is too close",
        "the motorcycle rides too close to us | the motorcycle follows much too close | motorcycle: too close",
    ),
    # where it all happens, and who is nobody in particular
    (
        MOTORWAY,
        "at night",
        "it all happens at night | the whole scene takes place at night | everything should take place at night",
    ),
    (
        MOTORWAY,
        "on a rural road",
        "it all happens on a country road | a rural road instead of the motorway | not a motorway but a country road | "
        "replace the motorway by a city street",
    ),
    (
        MOTORWAY,
        "let a vehicle tailgate ego",
        "somebody should tailgate us | someone has to tailgate ego | somebody must tailgate me",
    ),
    (
        STREET,
        "the woman is hidden by two parked cars",
        "the woman comes out from behind parked cars | the woman comes from between parked cars",
    ),
    # not at once, but at that moment
    (
        MOTORWAY,
        "the van brakes after 4 s",
        "the van doesn't brake immediately but after 4 s | the van must not brake at once, only after 4 s | "
        "the van brakes later, namely after 4 s | the van should not brake right away, it brakes after 4 s",
    ),
    (
        STREET,
        "the woman crosses when the taxi brakes",
        "the woman doesn't cross at once, only when the taxi brakes | the woman should not cross the road yet but when "
        "the taxi brakes | she must not start straight away, only when the taxi brakes",
    ),
    (STREET, "the woman crosses later", "the woman should not cross so early | the woman doesn't start right away"),
    (
        JUNCTION,
        "the lorry runs the red light",
        "the lorry drives over red | the lorry goes through the red light | the lorry jumps the light",
    ),
    (JUNCTION, "the lorry stops at the red light", "the lorry obeys its red light | the lorry respects the light"),
    (
        STREET,
        "ego does not react",
        "ego doesn't care about the woman | we pay no attention to the woman | ego takes no notice of anybody",
    ),
    (MOTORWAY, "the van keeps on going", "the van just keeps on driving at 108 km/h | the van drives on at 108 km/h"),
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
    (
        STREET,
        "the woman crosses when the taxi brakes",
        "the woman doesn't just stand there: when the taxi brakes she crosses | the woman should not wait there. When "
        "the taxi brakes, she crosses the road | when the taxi brakes the woman panics and crosses the road",
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
    (
        ROW,
        "the boy is visible from the start",
        "we want to see the boy from the beginning | I want to see the boy from the start, don't hide him | "
        "we should be able to see the boy clearly",
    ),
    (MOTORWAY, "make it two lanes", "number of lanes: 2 | reduce the lanes to two | not three lanes but two"),
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


@pytest.mark.parametrize(
    "text", ["remove all other vehicles", "the tram should be slower", "not that", "30 is a lot for a van"]
)
def test_what_is_not_understood_changes_nothing(read, text: str) -> None:
    assert not route(text, read(MOTORWAY)).edits
