"""Turns that only what is there makes plain: an old value, a way, who does an act, several speeds in one sentence."""

import pytest

from c2s_engine.interpret.turn import route
from tests.interpret.demanded import LIGHTS, MOTORWAY, ROW, after, assert_same, changed

STREET = "In heavy rain ego follows a car at 50 km/h. The car brakes hard and a pedestrian crosses from the right."
TRUCK = "Ego drives at 60 km/h on a straight road. A stationary truck stands in its lane 80 m ahead."
COUNTRY = "On a country road ego drives at 80 km/h. A tractor comes the other way at 30 km/h."


CELLS = [
    # how fast each of several is
    (
        STREET,
        "ego at 60 km/h. the car at 60 km/h",
        "ego and the car should drive 60 | ego as well as the car in front at 60 km/h | the two cars go 60 km/h | "
        "60 km/h for ego and the lead | let ego and the car both do 60",
    ),
    (
        STREET,
        "ego at 60 km/h. the car at 40 km/h",
        "ego 60 lead 40 | the car drives 40 km/h whereas ego goes 60 | 40 for the lead, 60 for ego | "
        "make ego faster (60) and the car ahead slower (40) | ego does 60 but the other car just 40",
    ),
    (MOTORWAY, "the van at 70 km/h. the car at 150 km/h", "van 70, car 150 | car @150 and van @70 | van: 70, car: 150"),
    # a new value for an old one
    (STREET, "ego at 40 km/h", "40 instead of 50 | 50 is too fast, 40 would do | not 50 but 40 | from 50 to 40"),
    (MOTORWAY, "the gap to the van is 45 m", "45 instead of 30 m | 30 m is way too near, 45 please | not 30 m, 45 m"),
    (TRUCK, "the gap to the truck is 50 m", "80 m is too far, 50 | 50 m rather than 80 m | from 80 m to 50 m"),
    (STREET, "ego at 30 km/h", "why is ego so fast? make it 30 | why so fast? 30 please | let ego be at 30"),
    # a way alone
    (
        LIGHTS,
        "ego should turn right",
        "right turn instead of left | not left but right | change ego's turn from left to right | it should be a "
        "right turn | I meant right, not left | let's turn right instead of left",
    ),
    (LIGHTS, "ego should go straight on", "straight instead of left | not left, straight | straight on, please"),
    # another does what one does who is there
    (
        MOTORWAY,
        "replace the car by a motorcycle",
        "let a motorcycle overtake instead | it's a motorcycle that overtakes | a motorcycle overtakes instead of the "
        "car | a motorcycle overtakes ego, not the car",
    ),
    (LIGHTS, "replace the truck by a bus", "an oncoming bus, not a truck | oncoming bus instead of the truck"),
    # a distance by a share of it
    (MOTORWAY, "the gap to the van is 33 m", "increase the gap by 10 % | 10 % more distance to the van"),
    (MOTORWAY, "the gap to the van is 15 m", "the van twice as close | reduce the gap by half | take 15 m off the gap"),
    (MOTORWAY, "the gap to the van is 60 m", "two times the distance | increase the distance by 100 %"),
    (MOTORWAY, "the gap to the van is 40 m", "add 10 m to the gap | let there be 40 m between ego and the van"),
    # who is not there, and who alone is
    (LIGHTS, "remove the motorcycle", "nobody follows ego | no one is behind us | just the truck"),
    (MOTORWAY, "remove the van", "nothing ahead of ego | no vehicle in front | there is no one ahead of us"),
    (ROW, "only one parked car", "just one car is parked | a single parked car | there's just one car parked there"),
    # the light
    (LIGHTS, "ego's light is red", "ego gets red | our light's red | light: red | the signal's red | red for ego"),
    (LIGHTS, "remove the traffic lights", "without lights | no traffic lights"),
    # how ego reacts
    (ROW, "ego evades", "ego swerves | ego doesn't brake but swerves | instead of braking, ego swerves"),
    (ROW, "ego brakes hard", "the AEB kicks in | our AEB should trigger | AEB stop"),
    (ROW, "ego does not react", "ego's brakes fail | the brakes of ego don't work"),
    (LIGHTS, "ego becomes a van", "I want to drive a van | put me in a van | we want to ride in a van"),
    # one who comes the other way
    (
        COUNTRY,
        "the oncoming tractor drifts into ego's lane",
        "the tractor strays into our lane | the tractor comes over into our lane",
    ),
    (COUNTRY, "the tractor at 50 km/h", "oncoming traffic at 50 km/h | oncoming traffic does 50 km/h"),
    # who steps out, and when
    (
        ROW,
        "the boy should start after 3 s",
        "the boy runs out after 3 seconds | 3 s later the boy runs out | the boy steps out after 3 s",
    ),
    # more room
    (
        MOTORWAY,
        "the van further away",
        "more space to the van | keep more distance to the van | give the van more room | leave more room to the van",
    ),
    # how hard, and when
    (STREET, "braking with 8 m/s2", "set the braking rate to 8 | make the brake rate 8"),
    (STREET, "the car should brake after 5 s", "5 s until the car brakes | 5 seconds before the car brakes"),
    (
        STREET,
        "the pedestrian should cross when ego is 25 m away",
        "cross at 25 m | as ego comes within 25 metres the pedestrian begins to cross | cross only at 25 m",
    ),
    (STREET, "the car should not brake", "the car never brakes | the lead car never brakes"),
    # what is beside the lanes
    (STREET, "add a sidewalk", "with a pavement | there is a footpath | the road has a sidewalk on the right"),
    (STREET, "add a shoulder", "with a hard shoulder | there should be a shoulder | with a shoulder"),
    (STREET, "speed limit 50 km/h", "max speed 50 | the maximum speed is 50 km/h | top speed: 50 km/h"),
    # whom something new hides
    (
        STREET,
        "add a truck parked on the right that hides the pedestrian",
        "add a truck parked on the right so that the pedestrian is not visible | "
        "let there be a truck parked on the right such that the pedestrian is hardly visible for ego",
    ),
    # against a sign, and for it
    (
        LIGHTS,
        "the truck runs the red light at 50 km/h. ego's light is green",
        "the truck runs the red light at 50 km/h while the light for ego is green | "
        "the truck runs the red light at 50 km/h, the signal for ego is green",
    ),
    # several things in one breath
    (
        MOTORWAY,
        "ego at 90 km/h. at night in the rain",
        "ego does 90 at night in the rain | night + rain + ego 90 | ego at 90 km/h in the rain at night",
    ),
    (MOTORWAY, "ego should evade. in the rain", "ego evades, and please make it rain | ego evades, please let it rain"),
    (MOTORWAY, "ego at 90 km/h. in the rain", "ego at 90 km/h, please make it rain | ego 90, and please let it rain"),
    (
        MOTORWAY,
        "the car is in the right lane. the car should overtake ego on the right",
        "let the car overtake on the right | the car overtakes us on the right side",
    ),
    # who is behind at a distance
    (LIGHTS, "the gap to the motorcycle is 10 m", "motorcycle at a distance of 10 m | motorcycle with a gap of 10 m"),
]  # fmt: skip


@pytest.mark.parametrize(("scene", "plain", "wordings"), CELLS, ids=[c[1] for c in CELLS])
def test_a_demand_is_the_same_in_other_words(read, scene: str, plain: str, wordings: str) -> None:
    assert_same(read(scene), plain, wordings)


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("go one step back, the version before was better", "undo"),
        ("undo that, it was wrong", "undo"),
        ("nah, take it back please because it was better before", "undo"),
        ("redo it. I pressed undo by mistake, sorry.", "redo"),
        ("redo, it was fine after all", "redo"),
        ("go back to dry weather, it was better", "edit"),
    ],
)
def test_with_a_reason(read, text: str, kind: str) -> None:
    assert route(text, read(STREET)).kind == kind


def test_a_wet_road_stays_wet_without_rain(read) -> None:
    wet = changed(read(MOTORWAY), "the road is wet, but without rain")
    assert wet.settings.spec.weather == ("wet",)


def test_who_runs_a_sign_reacts_as_before(read) -> None:
    stop = read("At a four-way stop a police car comes from the right while ego goes straight on at 30 km/h.")
    assert after(stop, "ego ignores the stop sign")["E"].reaction == stop.ego.spec.reaction


def test_a_follower_at_a_distance_is_new(read) -> None:
    turn = route("a car follows ego at 10 m", read(ROW))
    assert [e.spec.placement.gap for e in turn.edits if hasattr(e, "spec")] == [10.0]
