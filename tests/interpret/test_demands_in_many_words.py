"""Demands of two, of moments, of ends and of reasons in many wordings: each changes S as the plainest one does."""

import pytest

from c2s_engine.interpret.turn import route
from tests.interpret.demanded import LIGHTS, MOTORWAY, assert_same

STREET = "In heavy rain ego follows a car at 50 km/h. The car brakes hard and a pedestrian crosses from the right."
ROW = (
    "Ego drives at 30 km/h past three cars that are parked on the right. A child runs out from behind them. "
    "A bus comes the other way."
)


CELLS = [
    # how far from the place; two in one; who goes of several
    (
        LIGHTS,
        "ego starts 60 m before the intersection",
        "let ego start 60 metres away from the junction | the intersection is 60 m ahead of ego | "
        "the distance to the junction should be 60 m | ego should begin 60 m short of the crossroads",
    ),
    (
        ROW,
        "put the parked cars on the left. put the child on the left",
        "could the parked cars and the child be on the left side, please | move cars and child to the left | "
        "both the parked cars and the child on the left | the child and the parked cars must start on the left",
    ),
    (ROW, "two parked cars", "remove the last one | without the last parked car | the last of the cars can go"),
    # what one does when he has done what he does
    (
        MOTORWAY,
        "the car overtakes, then it cuts in",
        "once it is past, the car cuts in | having overtaken ego, the car should cut in | "
        "when the overtaking is done the car cuts in | as soon as the car has passed us it cuts in",
    ),
    # from both sides
    (
        STREET,
        "add a pedestrian who crosses from the left",
        "two pedestrians, one from each side | pedestrians from both sides | "
        "let one more pedestrian cross from the other side | a second pedestrian comes from the opposite side",
    ),
    # whom something new hides
    (
        STREET,
        "add a parked van on the right that hides the pedestrian",
        "ego must not see him at first, so put a parked van on the right which covers him | "
        "put a parked van on the right, hiding the pedestrian from ego | "
        "add a van parked on the right which is hiding the pedestrian",
    ),
    # moments
    (
        STREET,
        "the car should brake after 5 s",
        "it takes 5 seconds until the car brakes | wait 5 s before the car brakes | the car brakes at second 5",
    ),
    (
        STREET,
        "the pedestrian should cross when the car brakes",
        "the braking of the car should trigger the crossing | the crossing should start together with the braking "
        "of the car | ped crosses once the car brakes",
    ),
    (
        STREET,
        "the car should brake when the pedestrian crosses",
        "it is strange that the car brakes before he crosses, it should brake when the pedestrian crosses | "
        "the pedestrian's crossing makes the car brake | the pedestrian crosses first and the car brakes only then",
    ),
    (
        STREET,
        "the pedestrian should start when ego is 20 m away",
        "the pedestrian must start crossing no earlier than 20 m before ego | the ped starts at 20m dist | "
        "please make the pedestrian wait at the kerb until ego is only 20 m away and then cross",
    ),
    (
        STREET,
        "the pedestrian should start when the ttc is 2 s",
        "2 s TTC for the pedestrian | the pedestrian starts crossing when ego would hit her in 2 s",
    ),
    # how long one stops
    (
        STREET,
        "the pedestrian stops on the road for 3 s",
        "the pedestrian should make a 3 second stop on the road | "
        "the pedestrian pauses in the middle of the road for 3 s | "
        "halfway across, the pedestrian stops for 3 seconds",
    ),
    # reasons, and what is wrong
    (
        MOTORWAY,
        "the van is a truck",
        "the van has to be a truck since a van is too small | the van must actually become a truck because vans brake "
        "too well | it would be better if the van were a truck | use truck not van",
    ),
    (
        MOTORWAY,
        "the van is 20 m ahead",
        "30 m to the van is too much, 20 m please | since our stopping distance is 25 m, the van should be 20 m ahead",
    ),
    (
        LIGHTS,
        "remove the motorcycle. the truck at 50 km/h",
        "the motorcycle can go, and while you are at it make the "
        "truck drive 50 km/h | I would like to remove the motorcycle and to have the truck at 50 km/h",
    ),
    (
        ROW,
        "the bus is a truck",
        "a truck comes the other way, not a bus | it's a truck that comes the other way, not a bus",
    ),
    # lights and signs
    (
        LIGHTS,
        "ego's light is red",
        "when ego arrives, the light should be red | our signal should be red | signal red "
        "for us | let the light be red when we come",
    ),
    (LIGHTS, "no traffic lights", "traffic lights are off | the lights don't work | nobody controls the intersection"),
    (
        LIGHTS,
        "the junction has stop signs",
        "the traffic lights should be stop signs | the junction should be stop controlled",
    ),
    # who follows, who comes into the lane, who goes first
    (MOTORWAY, "let a vehicle follow ego", "someone follows ego | somebody should follow us"),
    (MOTORWAY, "add a car that follows ego", "ego is followed by another car | let another car follow ego"),
    (
        ROW,
        "the oncoming bus drifts into ego's lane",
        "the bus in the oncoming lane gets into our lane | the oncoming bus is on our side of the road",
    ),
    (LIGHTS, "ego yields to the truck", "the truck has priority | truck first | ego stops and lets the truck pass"),
    # the road
    (STREET, "speed limit 30 km/h", "30 km/h zone | here only 30 km/h are allowed | the allowed speed is 30 km/h"),
    (MOTORWAY, "on a country road", "we are on a country road"),
    (MOTORWAY, "make it four lanes", "add a lane | one more lane | three lanes are not enough, make it four"),
    (STREET, "less rain", "the rain should be light | the rain is too heavy | reduce the rain"),
    (ROW, "no oncoming traffic", "clear the oncoming lane | remove everything in the oncoming lane"),
    (ROW, "remove the parked cars", "remove the row | the roadside should be free of cars | clear the parked cars"),
    # what is supposed
    (
        ROW,
        "the child should start when ego is 15 m away",
        "what if the child ran out at 15 m? | what if the child started when ego was 15 m away? | "
        "have the child run only when ego is 15 m away",
    ),
    (STREET, "the car comes to a stop", "it would be better if the car stopped | what would happen if the car stopped"),
    (
        ROW,
        "the child should start when the ttc is 1.5 s",
        "the child should start a little later, at a TTC of 1.5 s instead of immediately | to really test the brakes "
        "we need the child to start only when the time to collision has dropped to 1.5 s, everything else can stay | "
        "the child must not start earlier than at a time to collision of 1.5 s",
    ),
    # who stands, who is parked, where he is
    (MOTORWAY, "the van stands still", "make the van a broken-down vehicle | the van has broken down"),
    (STREET, "the car is parked on the right", "park the car on the right | put the car on the right, parked"),
    (MOTORWAY, "swap the van and the car", "van <-> car | switch van with car"),
    (MOTORWAY, "the van is 100 m ahead", "van @ 100m | van from 30 to 100 m | van at 100 m"),
    (
        LIGHTS,
        "the motorcycle is 20 m behind ego",
        "the motorcycle follows ego at 20 m | keep the motorcycle 20 m behind us",
    ),
    # what follows for ego
    (
        ROW,
        "the child crosses, then it stops. ego brakes hard",
        "the child runs into the road and then stops there, so ego has to do an emergency brake | the child crosses, "
        "then it gets scared and stops there, and because of this ego must brake hard",
    ),
    # ego does nothing
    (
        MOTORWAY,
        "ego does not react",
        "ego stays passive | ego does not notice the van | ego keeps its speed no matter what happens | "
        "disable the braking of ego",
    ),
]


@pytest.mark.parametrize(("scene", "plain", "wordings"), CELLS, ids=[c[1] for c in CELLS])
def test_a_demand_is_the_same_in_other_words(read, scene: str, plain: str, wordings: str) -> None:
    assert_same(read(scene), plain, wordings)


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("redo what i have just undone", "redo"),
        ("bring back what I took back", "redo"),
        ("repeat what was undone", "redo"),
        ("undo what i have just changed", "undo"),
        ("please revert what was changed last", "undo"),
        ("make that change undone", "undo"),
    ],
)
def test_back_and_forth(read, text: str, kind: str) -> None:
    assert route(text, read(STREET)).kind == kind


@pytest.mark.parametrize(
    "text",
    ["the bus should brake harder", "the pedestrian should wait 3 s", "the ambulance brakes with 5 m/s2"],
)
def test_nobody_else_changes_for_one_who_is_not_there(read, text: str) -> None:
    assert not route(text, read(MOTORWAY)).edits
