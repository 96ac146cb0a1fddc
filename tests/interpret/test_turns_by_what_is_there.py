"""Turns that only what is there makes plain: an old value, a way, who does an act, several speeds in one sentence."""

import pytest

from c2s_engine.interpret.turn import route
from tests.interpret.demanded import LIGHTS, MOTORWAY, ROW, assert_same, changed

STREET = "In heavy rain ego follows a car at 50 km/h. The car brakes hard and a pedestrian crosses from the right."


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
    
    
    
    (STREET, "ego at 30 km/h", "why is ego so fast? make it 30 | why so fast? 30 please | let ego be at 30"),
    # a way alone
    
    
    # another does what one does who is there
    
    (LIGHTS, "replace the truck by a bus", "an oncoming bus, not a truck | oncoming bus instead of the truck"),
    # a distance by a share of it
    
    
    
    
    # who is not there, and who alone is
    
    
    
    # the light
    
    
    # how ego reacts
    (ROW, "ego evades", "ego swerves | ego doesn't brake but swerves | instead of braking, ego swerves"),
    
    
    
    # one who comes the other way
    
    
    # who steps out, and when
    (
        ROW,
        "the boy should start after 3 s",
        "the boy runs out after 3 seconds | 3 s later the boy runs out | the boy steps out after 3 s",
    ),
    # more room
    
    # how hard, and when
    
    
    
    (STREET, "the car should not brake", "the car never brakes | the lead car never brakes"),
    # what is beside the lanes
    (STREET, "add a sidewalk", "with a pavement | there is a footpath | the road has a sidewalk on the right"),
    (STREET, "add a shoulder", "with a hard shoulder | there should be a shoulder | with a shoulder"),
    
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
        "the car is in the right lane. the car should overtake ego on the right",
        "let the car overtake on the right | the car overtakes us on the right side",
    ),
    # who is behind at a distance
    
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


def test_a_follower_at_a_distance_is_new(read) -> None:
    turn = route("a car follows ego at 10 m", read(ROW))
    assert [e.spec.placement.gap for e in turn.edits if hasattr(e, "spec")] == [10.0]
