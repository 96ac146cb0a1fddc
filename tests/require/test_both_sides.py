"""Each class of requirement from both sides: a run that shows it, and one that just does not."""

import json
import time
from typing import Any

import pytest
from roads import Actor, Scene, event, ramp, swap

from c2s_engine.require import evaluate, majority, require, whole, without_reaction
from c2s_engine.require.deriving import PARTS
from c2s_engine.structure.components import Assumption, Component, Structure
from c2s_engine.structure.facts import ContactFact, Mark, Stay
from c2s_engine.structure.measures import collisions
from c2s_engine.structure.requirements import Run, failures, tally
from c2s_engine.structure.specs import (
    EgoSpec,
    Limit,
    ObjectSpec,
    Phase,
    Placement,
    PlaceSpec,
    RestrictionsSpec,
    Trigger,
)

LINE = Mark(kind="line", start=60.0, end=60.0, name="1/1", control="signal")
HIT = ContactFact(time=4.0, one="ego", other="other", part_one="front", part_other="rear")
LEFT_LANE = (Stay(time=0.0, lane=2, to_ego="left"),)


def s(*objects: ObjectSpec, ego: EgoSpec | None = None, place: PlaceSpec | None = None, **more: Any) -> Structure:
    """S with those objects; its components count as written from S."""
    made = tuple(Component(id=f"O{i}", spec=o) for i, o in enumerate(objects, 1))
    return Structure(
        ego=Component(id="E", spec=ego or EgoSpec()), place=Component(id="R", spec=place or PlaceSpec()), objects=made,
        **more,
    )  # fmt: skip


def t(*limits: Limit) -> Component:
    return Component(id="T", spec=RestrictionsSpec(limits=limits))


def ego(**values: Any) -> Actor:
    return Actor("ego", "E", **values)


def other(**values: Any) -> Actor:
    return Actor("other", "O1", **{"y": 25.0, **values})


def brakes(**values: Any) -> ObjectSpec:
    return ObjectSpec(phases=(Phase(action="brake", **values),))


BRAKING = ramp((0, 10), (4, 10), (5, 4), (12, 4))
STOPS = ramp((0, 10), (4, 10), (7, 0), (12, 0))
INTO_JUNCTION = (Stay(time=0, lane=1), Stay(time=4, lane=3, kind="junction", to_ego="crossing"))
SLOWER = ramp((0, 10), (4, 10), (5, 8.6), (12, 8.6))
CUT_IN = ObjectSpec(
    placement=Placement(position="left_lane", along="ahead"), phases=(Phase(action="cut_in", side="right"),)
)
CUTS_IN = {
    "x": ramp((0, -3.5), (4, -3.5), (6, 0), (12, 0)),
    "events": (event("cut_in", 5.0, "ego"),),
    "lanes": ("left", "adjacent"),
    "relations": ("ahead", "left", "ahead_left"),
    "stays": LEFT_LANE,
}
RED = PlaceSpec(kind="intersection", control="signal")
STOP_AT = ramp((0, 10), (2, 10), (6, 0), (12, 0))
CRASH = ObjectSpec(phases=(Phase(action="collide"),), placement=Placement(position="behind"))
STRUCK = ContactFact(time=4.0, one="ego", other="other", part_one="rear", part_other="front")
BEHIND = {"y": -25.0, "relations": ("behind",)}
AT_CORNERS = ContactFact(time=4.0, one="ego", other="other", part_one="front", part_other="right", at_one=(2.2, 0.6),
                         at_other=(-1.2, -0.9))  # fmt: skip
AIMS_AT_A_CORNER = EgoSpec(phases=(Phase(action="collide", target="O1", part="front_left", target_part="rear_right"),))
AIMED = ramp((0, 10), (2, 10), (3.9, 16), (12, 16))
STROLL = ObjectSpec(type="pedestrian", placement=Placement(position="sidewalk", side="right"),
                    phases=(Phase(action="cross_road"),))  # fmt: skip
WALKS = {"kind": "pedestrian", "across": True, "x": 6.0, "y": 40.0, "events": (event("cross_road", 4.0, "ego"),),
         "lanes": ("sidewalk",), "relations": ("ahead", "right", "ahead_right"),
         "stays": (Stay(time=0.0, kind="sidewalk"),)}  # fmt: skip
STANDS = {"kind": "pedestrian", "y": 40.0, "speed": 0.0}
SECOND = Phase(action="accelerate", speed=12.0)
TWICE = ramp((0, 10), (3, 10), (4, 6), (6, 6), (8, 12), (12, 12))
BACKWARDS = ramp((0, 10), (3, 10), (5, 14), (7, 14), (9, 8), (12, 8))

AFTER_IT = Phase(action="brake", trigger=Trigger(kind="action", of="O1", action="brake"))
OVERTAKES = EgoSpec(phases=(Phase(action="overtake", target="O1"), Phase(action="keep_lane")))
HITS_AS_IT_OVERTAKES = EgoSpec(phases=(Phase(action="overtake", target="O1"), Phase(action="collide", target="O1")))
PUSHED = ContactFact(time=4.5, one="other", other="next", part_one="front", part_other="rear")
PASSED = {"events": (event("overtake", 5.0, "other"),)}
OUT = (Stay(time=0.0, lane=1, to_ego="own"), Stay(time=3.0, lane=2, to_ego="left"))
BRAKES_LATER = Phase(action="brake", trigger=Trigger(kind="action", of="O1", action="brake", delay=2.0))

FIRST = ObjectSpec(type="pedestrian", placement=Placement(position="roadside", side="right"),
                   phases=(Phase(action="cross_road"),))  # fmt: skip
NEXT = ObjectSpec(
    type="pedestrian", placement=Placement(position="roadside", side="right", of="O1", along="ahead"),
    phases=(Phase(action="enter_road", trigger=Trigger(kind="action", of="O1", action="cross_road")),),
)  # fmt: skip
FIRST_WALKS = Actor("first", "O1", **{**WALKS, "speed": ramp((0, 0), (2.9, 0), (3, 1.4), (12, 1.4)),
                                      "events": (event("cross_road", 6.0, "ego"),)})  # fmt: skip


def next_walks(at: float, y: float = 42.0) -> Actor:
    """Somebody beside the first, who sets out `at` s."""
    speed = ramp((0, 0), (at - 0.1, 0), (at, 1.4), (12, 1.4))
    more = {"speed": speed, "y": y, "events": (event("enter_road", at + 1.0),), "relations": ("behind",), "of": "first"}
    return Actor("next", "O2", **{**WALKS, **more})


RING = PlaceSpec(kind="roundabout")
ENTERS = ObjectSpec(placement=Placement(position="crossing_right"))
YIELDS = EgoSpec(phases=(Phase(action="yield", target="O1"),))
SLOWS_AT_LINE = {"speed": ramp((0, 10), (2, 10), (8, 0), (9, 0), (11, 8), (12, 8)), "marks": (LINE,)}
IN_JUNCTION = (Stay(time=0.0, lane=2, kind="junction", to_ego="crossing"),)
CROSSES = s(ObjectSpec(placement=Placement(position="crossing_left")), ego=YIELDS, place=PlaceSpec(kind="intersection"))
STANDS_AT_LINE = {"speed": ramp((0, 10), (1, 10), (3, 0), (9.5, 0), (10.5, 8), (12, 8)), "y": 28.0}


def comes_by(x: float) -> Actor:
    """Somebody from the left over ego's junction, so far (m) before ego's lane at first."""
    return other(x=x, y=65.0, across=True, stays=IN_JUNCTION)


CRASHES_ANYWAY = s(ObjectSpec(placement=Placement(position="crossing_left"), phases=(Phase(action="collide"),)),
                   ego=EgoSpec(reaction="brake", react_to="O1"))  # fmt: skip
STOPS_AFTER_IT = EgoSpec(phases=(Phase(action="collide", target="O1"), Phase(action="stop")))
MERGE = (Mark(kind="merge", start=20.0, end=80.0, name="1"),)
AT_END = EgoSpec(phases=(Phase(action="brake", speed=2.0, trigger=Trigger(kind="place", place="merge_end")),))
ROUND = EgoSpec(phases=(Phase(action="go_straight"), Phase(action="stop")))
STOPS_LATE = {"speed": ramp((0, 10), (10.9, 10), (12, 0)), "events": (event("go_straight", 2.0),)}


def cuts_in(**values: Any) -> ObjectSpec:
    return CUT_IN.model_copy(update={"phases": (Phase(action="cut_in", side="right", **values),)})


CASES = [
    # what, the requirement, S, a run that shows it, one that just does not
    (
        "sets out once the other has",
        "O2.phases.0.awaits",
        s(FIRST, NEXT),
        Scene([ego(), FIRST_WALKS, next_walks(3.2)]),
        Scene([ego(), FIRST_WALKS, next_walks(2.2)]),
    ),
    (
        "further along the road than one who looks across",
        "O2.placement.along",
        s(FIRST, NEXT),
        Scene([ego(), FIRST_WALKS, next_walks(3.2, y=42.0)]),
        Scene([ego(), FIRST_WALKS, next_walks(3.2, y=38.0)]),
    ),
    (
        "comes in by another arm of a roundabout",
        "O1.placement.position",
        s(ENTERS, place=RING),
        Scene([ego(), other(lanes=("oncoming",))]),
        Scene([ego(), other(lanes=("right", "adjacent"))]),
    ),
    (
        "waits for one who turns off",
        "E.phases.0.yield",
        s(ObjectSpec(placement=Placement(position="circulating")), ego=YIELDS, place=RING),
        Scene([ego(**SLOWS_AT_LINE), other(x=-40.0, y=65.0, speed=3.0, across=True, stays=IN_JUNCTION)]),
        Scene([ego(**SLOWS_AT_LINE), other(x=5.0, y=65.0, speed=3.0, across=True, stays=IN_JUNCTION)]),
    ),
    (
        "stands for one that is near then",
        "E.gives_way.O1",
        CROSSES,
        Scene([ego(**STANDS_AT_LINE), comes_by(-90.0)]),
        Scene([ego(**STANDS_AT_LINE), comes_by(-104.0)]),
    ),
    (
        "stands for one that has not gone by",
        "E.gives_way.O1",
        CROSSES,
        Scene([ego(**STANDS_AT_LINE), comes_by(-30.0)]),
        Scene([ego(**STANDS_AT_LINE), comes_by(-20.0)]),
    ),
    (
        "brakes before it is struck",
        "E.reaction.O1.before",
        CRASHES_ANYWAY,
        Scene([ego(speed=ramp((0, 10), (3, 10), (4, 8.5), (12, 8.5))), other()], contacts=(HIT,)),
        Scene([ego(speed=ramp((0, 10), (3.6, 10), (4, 9.4), (12, 0))), other()], contacts=(HIT,)),
    ),
    (
        "rolls out and stands after a contact",
        "E.phases.1.stop",
        s(ObjectSpec(), ego=STOPS_AFTER_IT),
        Scene([ego(speed=ramp((0, 10), (4, 8), (6, 0), (12, 0))), other()], contacts=(HIT,)),
        Scene([ego(speed=ramp((0, 10), (4, 8), (12, 3))), other()], contacts=(HIT,)),
    ),
    (
        "brakes up to the end of the acceleration lane",
        "E.phases.0.trigger",
        s(ego=AT_END, place=PlaceSpec(kind="on_ramp")),
        Scene([ego(speed=ramp((0, 10), (6, 10), (9, 2), (12, 2)), marks=MERGE)]),
        Scene([ego(speed=ramp((0, 10), (4, 10), (7, 2), (12, 2)), marks=MERGE)]),
    ),
    (
        "drives round meanwhile",
        "T.pace.dead",
        s(ego=ROUND),
        Scene([ego(heading=ramp((0, 0), (12, 2.5)), **STOPS_LATE)]),
        Scene([ego(heading=ramp((0, 0), (12, 0.5)), **STOPS_LATE)]),
    ),
    (
        "brakes",
        "O1.phases.0.brake",
        s(brakes()),
        Scene([ego(), other(speed=BRAKING)]),
        Scene([ego(), other(speed=SLOWER)]),
    ),
    (
        "cuts in",
        "O1.phases.0.cut_in",
        s(CUT_IN),
        Scene([ego(), other(**CUTS_IN)]),
        Scene([ego(), other(**{**CUTS_IN, "events": (event("lane_change", 5.0),)})]),
    ),
    (
        "to the side",
        "O1.phases.0.side",
        s(CUT_IN),
        Scene([ego(), other(**CUTS_IN)]),
        Scene([ego(), other(**{**CUTS_IN, "x": ramp((0, 3.5), (4, 3.5), (6, 0), (12, 0))})]),
    ),
    (
        "starts in the lane",
        "O1.placement.position",
        s(CUT_IN),
        Scene([ego(), other(**CUTS_IN)]),
        Scene([ego(), other(**{**CUTS_IN, "lanes": ("right", "adjacent")})]),
    ),
    (
        "starts on the side",
        "O1.placement.side",
        s(CUT_IN),
        Scene([ego(), other(**CUTS_IN)]),
        Scene([ego(), other(**{**CUTS_IN, "relations": ("ahead", "right", "ahead_right")})]),
    ),
    (
        "starts ahead",
        "O1.placement.along",
        s(CUT_IN),
        Scene([ego(), other(**CUTS_IN)]),
        Scene([ego(), other(**{**CUTS_IN, "relations": ("behind", "left", "behind_left")})]),
    ),
    (
        "the gap",
        "O1.placement.gap",
        s(ObjectSpec(placement=Placement(gap=20.0))),
        Scene([ego(), other(gap=22.9)]),
        Scene([ego(), other(gap=23.1)]),
    ),
    (
        "hidden",
        "O1.placement.hidden_by",
        s(STROLL.model_copy(update={"placement": Placement(hidden_by="O2")}), ObjectSpec()),
        Scene([ego(), other(**WALKS, hidden_behind=("bus",)), Actor("bus", "O2")]),
        Scene([ego(), other(**WALKS), Actor("bus", "O2")]),
    ),
    (
        "room across the road",
        "O1.placement.lateral",
        s(ObjectSpec(placement=Placement(position="roadside", side="right", lateral=1.0))),
        Scene([ego(), other(x=3.15, speed=0.0)]),
        Scene([ego(), other(x=3.25, speed=0.0)]),
    ),
    (
        "arrives with ego's front",
        "O1.placement.arrives",
        s(STROLL.model_copy(update={"placement": Placement(position="roadside", side="right", arrives=0.0)})),
        Scene([ego(), other(**STANDS, x=ramp((0, 6), (2, 6), (4.0, 0), (6, -6), (12, -6)))]),
        Scene([ego(), other(**STANDS, x=ramp((0, 6), (2, 6), (4.2, 0), (6, -6), (12, -6)))]),
    ),
    (
        "a crossing that is broken off",
        "O1.phases.0.cross_road",
        s(STROLL.model_copy(update={"phases": (Phase(action="cross_road"), Phase(action="stop"))})),
        Scene([ego(), other(**{**WALKS, "events": (event("enter_road", 4.0),)})]),
        Scene([ego(), other(**{**WALKS, "events": (event("walk_along", 4.0),)})]),
    ),
    (
        "in order",
        "O1.phases.1.order",
        s(ObjectSpec(phases=(Phase(action="brake"), SECOND))),
        Scene([ego(), other(speed=TWICE)]),
        Scene([ego(), other(speed=BACKWARDS)]),
    ),
    (
        "after what it waits for",
        "E.phases.0.awaits",
        s(
            brakes(),
            ego=EgoSpec(phases=(Phase(action="brake", trigger=Trigger(kind="action", of="O1", action="brake")),)),
        ),
        Scene([ego(speed=ramp((0, 10), (5, 10), (6, 4), (12, 4))), other(speed=BRAKING)]),
        Scene([ego(speed=ramp((0, 10), (2, 10), (3, 4), (12, 4))), other(speed=BRAKING)]),
    ),
    (
        "after what it waits for, whatever it did before",
        "E.phases.0.awaits",
        s(brakes(), ego=EgoSpec(phases=(AFTER_IT,))),
        Scene([ego(speed=ramp((0, 10), (1, 10), (2, 7), (5, 7), (6, 3), (12, 3))), other(speed=BRAKING)]),
        Scene([ego(speed=ramp((0, 10), (1, 10), (2, 7), (5, 7), (6, 6.5), (12, 6.5))), other(speed=BRAKING)]),
    ),
    (
        "in the junction",
        "O1.phases.0.place",
        s(ObjectSpec(phases=(Phase(action="turn_left"),)), place=PlaceSpec(kind="intersection")),
        Scene(
            [
                ego(),
                other(
                    events=(event("turn_left", 4.0),),
                    stays=(Stay(time=0, lane=1), Stay(time=4, lane=3, kind="junction", to_ego="crossing")),
                ),
            ]
        ),
        Scene(
            [
                ego(),
                other(
                    events=(event("turn_left", 4.0),),
                    stays=(Stay(time=0, lane=1), Stay(time=4, lane=9, kind="junction", to_ego="other")),
                ),
            ]
        ),
    ),
    (
        "a turn that a stop ends",
        "O1.phases.0.turn_left",
        s(ObjectSpec(phases=(Phase(action="turn_left"), Phase(action="stop"))), place=PlaceSpec(kind="intersection")),
        Scene([ego(), other(speed=STOPS, heading=ramp((0, 0), (4, 0), (6, 0.6), (12, 0.6)), stays=INTO_JUNCTION)]),
        Scene([ego(), other(speed=STOPS, stays=INTO_JUNCTION)]),
    ),
    (
        "contact",
        "O1.phases.0.contact",
        s(CRASH),
        Scene([ego(), other(**BEHIND)], contacts=(STRUCK,)),
        Scene([ego(), other(**BEHIND)]),
    ),
    (
        "with its front",
        "O1.phases.0.part",
        s(CRASH),
        Scene([ego(), other(**BEHIND)], contacts=(STRUCK,)),
        Scene([ego(), other(**BEHIND)], contacts=(STRUCK.model_copy(update={"part_other": "left"}),)),
    ),
    (
        "at the rear",
        "O1.phases.0.struck_part",
        s(CRASH),
        Scene([ego(), other(**BEHIND)], contacts=(STRUCK,)),
        Scene([ego(), other(**BEHIND)], contacts=(STRUCK.model_copy(update={"part_one": "right"}),)),
    ),
    (
        "with the corner that is said",
        "E.phases.0.part",
        s(ObjectSpec(), ego=AIMS_AT_A_CORNER),
        Scene([ego(), other()], contacts=(AT_CORNERS,)),
        Scene([ego(), other()], contacts=(AT_CORNERS.model_copy(update={"at_one": (2.2, -0.6)}),)),
    ),
    (
        "at the quarter that is said",
        "E.phases.0.struck_part",
        s(ObjectSpec(), ego=AIMS_AT_A_CORNER),
        Scene([ego(), other()], contacts=(AT_CORNERS,)),
        Scene([ego(), other()], contacts=(AT_CORNERS.model_copy(update={"at_other": (0.2, -0.9)}),)),
    ),
    (
        "nobody touches",
        "T.no_other_contact",
        s(ObjectSpec()),
        Scene([ego(), other()]),
        Scene([ego(), other()], contacts=(HIT,)),
    ),
    (
        "brakes with no more than T allows",
        "T.limits.0",
        s(brakes(), restrictions=t(Limit(kind="deceleration", subject="O1", maximum=6.0))),
        Scene([ego(), other(speed=ramp((0, 10), (4, 10), (5, 4.2), (12, 4.2)))]),
        Scene([ego(), other(speed=ramp((0, 10), (4, 10), (5, 3.4), (12, 3.4)))]),
    ),
    (
        "keeps the distance that T asks for",
        "T.limits.0",
        s(ObjectSpec(), restrictions=t(Limit(kind="gap", other="O1", minimum=20.0))),
        Scene([ego(), other()]),
        Scene([ego(), other(y=23.0)]),
    ),
    (
        "goes no faster than T allows",
        "T.limits.0",
        s(ObjectSpec(), restrictions=t(Limit(kind="speed", maximum=10.0))),
        Scene([ego(), other()]),
        Scene([ego(speed=ramp((0, 10), (5, 11), (12, 11))), other(y=60.0)]),
    ),
    (
        "does not touch whom T names",
        "T.limits.0",
        s(ObjectSpec(), restrictions=t(Limit(kind="collision", other="O1"))),
        Scene([ego(), other()]),
        Scene([ego(), other()], contacts=(HIT,)),
    ),
    (
        "no speeding into whom it hits",
        "O1.no_aiming",
        s(CRASH),
        Scene([ego(), other(**BEHIND)], contacts=(STRUCK,)),
        Scene([ego(), other(speed=AIMED, **BEHIND)], contacts=(STRUCK,)),
    ),
    (
        "no steering at whom it hits",
        "O1.no_aiming",
        s(CRASH),
        Scene([ego(), other(x=ramp((0, 0), (2, 0), (4, 0.6), (12, 0.6)), **BEHIND)], contacts=(STRUCK,)),
        Scene([ego(), other(x=ramp((0, 0), (2, 0), (4, 0.9), (12, 0.9)), **BEHIND)], contacts=(STRUCK,)),
    ),
    (
        "acceleration of a truck",
        "O1.dynamics",
        s(ObjectSpec(type="truck", phases=(SECOND,))),
        Scene([ego(), other(kind="truck", speed=ramp((0, 5), (3, 5), (5, 9.6), (12, 9.6)))]),
        Scene([ego(), other(kind="truck", speed=ramp((0, 5), (3, 5), (5, 10.6), (12, 10.6)))]),
    ),
    (
        "lateral acceleration",
        "O1.dynamics",
        s(ObjectSpec()),
        Scene([ego(), other(heading=ramp((0, 0), (4, 0), (6, 1.1), (12, 1.1)))]),
        Scene([ego(), other(heading=ramp((0, 0), (4, 0), (6, 1.3), (12, 1.3)))]),
    ),
    (
        "a walking pace",
        "O1.usual_speed",
        s(STROLL),
        Scene([ego(), other(speed=1.4, **WALKS)]),
        Scene([ego(), other(speed=2.6, **WALKS)]),
    ),
    (
        "a stated speed",
        "O1.speed",
        s(ObjectSpec(speed=10.0)),
        Scene([ego(), other(speed=10.9)]),
        Scene([ego(), other(speed=11.1)]),
    ),
    (
        "stands at first",
        "O1.speed",
        s(ObjectSpec(speed=0.0)),
        Scene([ego(), other(speed=0.0)]),
        Scene([ego(), other(speed=0.5)]),
    ),
    (
        "no surge to meet",
        "O1.steady",
        s(ObjectSpec(phases=(Phase(action="keep_lane"),))),
        Scene([ego(), other(y=80.0, speed=ramp((0, 8), (4, 8), (6, 9.9), (12, 9.9)))]),
        Scene([ego(), other(y=80.0, speed=ramp((0, 8), (4, 8), (6, 10.2), (12, 10.2)))]),
    ),
    (
        "no surge before it is said to brake",
        "O1.steady",
        s(brakes()),
        Scene([ego(), other(y=80.0, speed=ramp((0, 8), (2, 8), (4, 9.9), (6, 9.9), (7, 4), (12, 4)))]),
        Scene([ego(), other(y=80.0, speed=ramp((0, 8), (2, 8), (4, 10.2), (6, 10.2), (7, 4), (12, 4)))]),
    ),
    (
        "a stated speed of a phase",
        "O1.phases.0.speed",
        s(brakes(speed=5.0)),
        Scene([ego(), other(speed=ramp((0, 10), (4, 10), (6, 5.6), (12, 5.6)))]),
        Scene([ego(), other(speed=ramp((0, 10), (4, 10), (6, 5.8), (12, 5.8)))]),
    ),
    (
        "at the line",
        "E.at_line",
        s(place=RED),
        Scene([ego(speed=STOP_AT, y=14.0, marks=(LINE,))]),
        Scene([ego(speed=STOP_AT, y=10.0, marks=(LINE,))]),
    ),
    (
        "no stand without a reason",
        "O1.stands_for",
        s(ObjectSpec()),
        Scene([ego(), other(y=-80.0, speed=ramp((0, 10), (4, 10), (6, 1), (12, 1)))]),
        Scene([ego(), other(y=-80.0, speed=ramp((0, 10), (4, 10), (6, 0), (12, 0)))]),
    ),
    (
        "no red",
        "O1.obeys_light",
        s(ObjectSpec()),
        Scene([ego(), other()]),
        Scene([ego(), other(events=(event("run_red", 3.0),))]),
    ),
    (
        "its own side",
        "O1.own_side",
        s(ObjectSpec()),
        Scene([ego(), other(stays=(Stay(time=0, lane=1), Stay(time=3, lane=4, against=True), Stay(time=3.9, lane=1)))]),
        Scene([ego(), other(stays=(Stay(time=0, lane=1), Stay(time=3, lane=4, against=True), Stay(time=4.2, lane=1)))]),
    ),
    (
        "first event in time",
        "T.pace.first",
        s(brakes()),
        Scene([ego(), other(speed=BRAKING)]),
        Scene([ego(), other(speed=ramp((0, 10), (1, 10), (2, 4), (12, 4)))]),
    ),
    (
        "over soon after",
        "T.pace.over",
        s(brakes()),
        Scene([ego(), other(speed=BRAKING)], seconds=7.5),
        Scene([ego(), other(speed=BRAKING)], seconds=8.5),
    ),
    (
        "over soon after it has gained its speed",
        "T.pace.over",
        s(ObjectSpec(phases=(Phase(action="accelerate", speed=20.0),))),
        Scene([ego(), other(speed=ramp((0, 10), (2, 10), (7, 20), (12, 20)))], seconds=10.5),
        Scene([ego(), other(speed=ramp((0, 10), (2, 10), (6, 20), (12, 20)))], seconds=10.5),
    ),
    (
        "no dead time",
        "T.pace.dead",
        s(ObjectSpec(phases=(Phase(action="brake"), Phase(action="stop")))),
        Scene([ego(), other(speed=ramp((0, 10), (2.5, 10), (3.5, 4), (9, 4), (10, 0), (12, 0)))]),
        Scene([ego(), other(speed=ramp((0, 10), (1.5, 10), (2.5, 4), (11.2, 4), (11.8, 0), (12, 0)))]),
    ),
    ("kind", "O1.type", s(ObjectSpec(type="truck")), Scene([ego(), other(kind="truck")]), Scene([ego(), other()])),
    (
        "the light",
        "G.light",
        s(settings=Component(id="G", spec={"component": "G", "light": "red"})),
        Scene([ego()], facts={"light": "red"}),
        Scene([ego()], facts={"light": "green"}),
    ),
    (
        "a junction",
        "R.kind",
        s(place=PlaceSpec(kind="intersection")),
        Scene([ego()], facts={"road": {"intersection": "4way"}}),
        Scene([ego()]),
    ),
    (
        "a crosswalk",
        "R.crosswalk",
        s(place=PlaceSpec(kind="crosswalk")),
        Scene([ego()], facts={"infrastructure": ("crosswalk",)}),
        Scene([ego()]),
    ),
    (
        "the gap as it comes over the line",
        "O1.phases.0.gap",
        s(cuts_in(gap=20.0)),
        Scene([ego(), other(**{**CUTS_IN, "y": 25.0})]),
        Scene([ego(), other(**{**CUTS_IN, "y": 28.0})]),
    ),
    (
        "the gap as it begins to brake",
        "O1.phases.0.gap",
        s(brakes(gap=20.0)),
        Scene([ego(), other(speed=BRAKING, y=26.0)]),
        Scene([ego(), other(speed=BRAKING, y=28.0)]),
    ),
    (
        "the gap all along",
        "O1.phases.0.gap",
        s(ObjectSpec(placement=Placement(position="behind"), phases=(Phase(action="follow", target="ego", gap=20.0),))),
        Scene([ego(), other(y=-24.5, events=(event("follow", 0.0, "ego"),))]),
        Scene([ego(), other(y=-24.5, speed=ramp((0, 10), (12, 10.8)), events=(event("follow", 0.0, "ego"),))]),
    ),
    (
        "how fast it moves sideways",
        "O1.phases.0.lateral_speed",
        s(cuts_in(lateral_speed=1.6)),
        Scene([ego(), other(**CUTS_IN)]),
        Scene([ego(), other(**{**CUTS_IN, "x": ramp((0, -3.5), (4, -3.5), (5.3, 0), (12, 0))})]),
    ),
    (
        "so long after another's action",
        "E.phases.0.delay",
        s(brakes(), ego=EgoSpec(phases=(BRAKES_LATER,))),
        Scene([ego(speed=ramp((0, 10), (6, 10), (7, 4), (12, 4))), other(speed=BRAKING)]),
        Scene([ego(speed=ramp((0, 10), (7.2, 10), (8.2, 4), (12, 4))), other(speed=BRAKING)]),
    ),
    (
        "broken off",
        "O1.phases.0.cut_in",
        s(cuts_in(abandoned=True)),
        Scene([ego(), other(**{**CUTS_IN, "x": ramp((0, -3.5), (4, -3.5), (5, -2.3), (7, -3.5), (12, -3.5))})]),
        Scene([ego(), other(**{**CUTS_IN, "x": ramp((0, -3.5), (4, -3.5), (5, -2.3), (7, -2.5), (12, -2.5))})]),
    ),
    (
        "near the end of the acceleration lane",
        "O1.phases.0.trigger",
        s(cuts_in(trigger=Trigger(kind="place", place="merge_end", value=40.0))),
        Scene([ego(), other(**CUTS_IN, marks=(Mark(kind="merge", start=20.0, end=108.0),))]),
        Scene([ego(), other(**CUTS_IN, marks=(Mark(kind="merge", start=20.0, end=118.0),))]),
    ),
    (
        "keeps the lane it came to",
        "O1.phases.1.keep_lane",
        s(CUT_IN.model_copy(update={"phases": (*CUT_IN.phases, Phase(action="keep_lane"))})),
        Scene([ego(), other(**{**CUTS_IN, "stays": (*LEFT_LANE, Stay(time=5.0, lane=1, to_ego="own"))})]),
        Scene([ego(), other(**{**CUTS_IN, "stays": (*LEFT_LANE, Stay(time=5.0, lane=1, to_ego="own"),
                                                    Stay(time=9.0, lane=3, to_ego="right"))})]),
    ),
    (
        "keeps its lane once it is back from overtaking",
        "E.phases.1.keep_lane",
        s(ObjectSpec(), ego=OVERTAKES),
        Scene([ego(**PASSED, stays=(*OUT, Stay(time=8.0, lane=1, to_ego="own"))), other()], seconds=16.0),
        Scene([ego(**PASSED, stays=(*OUT, Stay(time=8.0, lane=1, to_ego="own"), Stay(time=14.0, lane=2))), other()],
              seconds=16.0),
    ),
    (
        "gets past what is no vehicle",
        "E.phases.0.overtake",
        s(ObjectSpec(type="container", speed=0, phases=(Phase(action="stationary"),)), ego=OVERTAKES),
        Scene([ego(), other(kind="obstacle", speed=0.0)]),
        Scene([ego(speed=ramp((0, 10), (1, 10), (3, 0), (12, 0))), other(kind="obstacle", speed=0.0)]),
    ),
    (
        "has pulled out to overtake as it hits the other",
        "E.phases.0.overtake",
        s(ObjectSpec(), ego=HITS_AS_IT_OVERTAKES),
        Scene([ego(x=ramp((0, 0), (2, 0), (4, -2), (12, -2))), other()], contacts=(HIT,)),
        Scene([ego(), other()], contacts=(HIT,)),
    ),
    (
        "turns right on red after a stop",
        "E.obeys_light",
        s(ego=EgoSpec(phases=(Phase(action="turn_right"), Phase(action="stop"))), place=RED),
        Scene([ego()]),
        Scene([ego(events=(event("run_red", 5.0),))]),
    ),
    (
        "no collision but of one of a row that is struck",
        "T.no_other_contact",
        s(ObjectSpec(count=2), ego=EgoSpec(phases=(Phase(action="collide", target="O1"),))),
        Scene([ego(), other(), Actor("next", "O1", y=32.0)], contacts=(HIT, PUSHED)),
        Scene([ego(), other(), Actor("next", "O2", y=32.0)], contacts=(HIT, PUSHED)),
    ),
]


def verdict(
    structure: Structure, scene: Scene, requirement: str, mirrored: bool = False, blind: Run | None = None
) -> bool | None:
    run = scene.run(mirrored)
    results = evaluate(require(structure), run.facts, run.trajectories, blind)
    return {r.requirement: r.holds for r in results}[requirement]


def mirror(structure: Structure) -> Structure:
    """S with left and right exchanged."""
    return Structure.model_validate(json.loads(swap(structure.model_dump_json())))


@pytest.mark.parametrize(
    ("requirement", "structure", "shows", "misses"), [c[1:] for c in CASES], ids=[c[0] for c in CASES]
)
def test_a_run_that_shows_it_and_one_that_just_does_not(requirement, structure, shows, misses) -> None:
    assert verdict(structure, shows, requirement) is True
    assert verdict(structure, misses, requirement) is False


@pytest.mark.parametrize("case", CASES, ids=[c[0] for c in CASES])
def test_mirrored_scenes_give_mirrored_verdicts(case) -> None:
    for scene in case[3:]:
        run, mirrored = scene.run(), scene.run(mirrored=True)
        plain = evaluate(require(case[2]), run.facts, run.trajectories)
        other_way = evaluate(require(mirror(case[2])), mirrored.facts, mirrored.trajectories)
        assert [swap(r.requirement) for r in plain] == [r.requirement for r in other_way]
        assert [r.holds for r in plain] == [r.holds for r in other_way]
        assert [r.robustness for r in plain] == pytest.approx([r.robustness for r in other_way], abs=1e-3, nan_ok=True)


STOPS = s(ObjectSpec(phases=(Phase(action="stop"),)), ego=EgoSpec(reaction="brake"))
LEAD = other(speed=ramp((0, 10), (3, 10), (5, 0), (12, 0)), y=30.0)
BLIND = Scene([ego(), LEAD], contacts=(HIT.model_copy(update={"time": 5.5}),)).run()


@pytest.mark.parametrize(
    ("from_second", "holds"), [(4.0, True), (2.0, False), (6.5, False)], ids=["in time", "before", "late"]
)
def test_ego_reacts_after_its_cause_and_in_time(from_second, holds) -> None:
    scene = Scene([ego(speed=ramp((0, 10), (from_second, 10), (from_second + 2, 0), (12, 0))), LEAD])
    assert verdict(STOPS, scene, "E.reaction.O1", blind=BLIND) is holds


@pytest.mark.parametrize(("y", "holds"), [(30.0, True), (70.0, False)], ids=["for it", "for another"])
def test_of_several_threats_ego_reacts_to_that_one(y, holds) -> None:
    """It comes as near as a gentle stop from 10 m/s needs, and 3 m: 28 m; not so where it stops for another before."""
    structure = s(STOPS["O1"].spec, ObjectSpec(placement=Placement(position="roadside")), ego=STOPS.ego.spec)
    slows = ego(speed=ramp((0, 10), (4, 10), (6, 0), (12, 0)))
    walker = Actor("walker", "O2", kind="pedestrian", x=6.0, y=20.0)
    lead = other(speed=LEAD.speed, y=y)
    blind = Scene([ego(), lead, walker], contacts=(HIT.model_copy(update={"time": 5.5}),)).run()
    found = Scene([slows, lead, walker]).run()
    results = {r.requirement: r for r in evaluate(require(structure), found.facts, found.trajectories, blind)}
    assert ("reacts to another" not in results["E.reaction.O1"].seen) is holds


def test_who_turns_across_egos_way_threatens_where_ego_brakes_hard() -> None:
    turns = ObjectSpec(placement=Placement(position="opposite_approach"), phases=(Phase(action="turn_left"),))
    for hard in (True, False):
        found = {r.id for r in require(s(turns, ego=EgoSpec(reaction="brake", hard=hard)))}
        assert ("O1.threat" in found) is hard


def test_ego_must_not_react_to_what_it_cannot_see() -> None:
    unseen = Actor("other", "O1", speed=LEAD.speed, y=30.0, sight=((0.0, False), (4.8, True)))
    scene = Scene([ego(speed=ramp((0, 10), (4, 10), (6, 0), (12, 0))), unseen])
    assert verdict(STOPS, scene, "E.reaction.O1", blind=BLIND) is False


@pytest.mark.parametrize(("y", "holds"), [(45.0, True), (100.0, False)], ids=["run into", "far away"])
def test_a_threat_is_one_without_the_reaction(y, holds) -> None:
    far = other(speed=ramp((0, 10), (3, 10), (5, 0), (12, 0)), y=y)
    blind = Scene([ego(speed=ramp((0, 10), (8, 10), (9, 9), (12, 9))), far], seconds=7.0).run()
    scene = Scene([ego(), far])
    assert verdict(STOPS, scene, "O1.threat", blind=blind) is holds


@pytest.mark.parametrize(("x", "holds"), [(1.9, True), (2.3, False)], ids=["close by", "with room"])
def test_who_drives_on_close_by_somebody_beside_its_way_threatens(x, holds) -> None:
    """A walker is 0.5 m wide and ego 1.9 m: 0.7 m and 1.1 m are between them."""
    along = (Phase(action="move_along"),)
    walker = ObjectSpec(type="pedestrian", placement=Placement(position="roadside"), phases=along)
    walks = other(kind="pedestrian", x=x, y=60.0, speed=1.4)
    structure = s(walker, ego=EgoSpec(reaction="evade", react_to="O1"))
    assert verdict(structure, Scene([ego(), walks]), "O1.threat", blind=Scene([ego(), walks]).run()) is holds


def test_whom_ego_follows_and_overtakes_of_its_own_accord_need_not_threaten_it() -> None:
    structure = s(ObjectSpec(), ego=EgoSpec(reaction="follow", react_to="O1", phases=OVERTAKES.phases))
    assert "O1.threat" not in {r.id for r in require(structure)}
    follows = s(ObjectSpec(), ego=EgoSpec(reaction="follow", react_to="O1"))
    assert "O1.threat" in {r.id for r in require(follows)}


@pytest.mark.parametrize(("action", "goes"), [("stationary", False), ("move_along", True)])
def test_who_only_stands_has_no_usual_speed(action, goes) -> None:
    spec = ObjectSpec(type="child", placement=Placement(position="sidewalk"), phases=(Phase(action=action),))
    assert ("O1.usual_speed" in {r.id for r in require(s(spec))}) is goes


def waits_for_overtaking(target: str | None) -> Structure:
    """S whose second object waits for the first to overtake ego, or another."""
    pulls_out = Phase(action="enter_road", trigger=Trigger(kind="action", of="O1", action="overtake"))
    second = ObjectSpec(placement=Placement(position="roadside"), phases=(pulls_out,))
    return s(ObjectSpec(phases=(Phase(action="overtake", target=target),)), second, ObjectSpec())


@pytest.mark.parametrize(("target", "check"), [("O2", "alongside"), ("O3", "awaited")])
def test_who_waits_for_an_overtaking_is_beside_it_only_where_it_is_overtaken(target, check) -> None:
    found = {r.id: r.check for r in require(waits_for_overtaking(target))}
    assert found["O2.phases.0.awaits"] == check


@pytest.mark.parametrize(("target", "threatens"), [("ego", True), ("O2", False)])
def test_what_another_does_about_others_is_no_threat_to_ego(target, threatens) -> None:
    comes = ObjectSpec(phases=(Phase(action="enter_road", target=target),), placement=Placement(position="roadside"))
    structure = s(comes, ObjectSpec(), ego=EgoSpec(reaction="brake", react_to="O1"))
    assert ("O1.threat" in {r.id for r in require(structure)}) is threatens


@pytest.mark.parametrize(("side", "kept"), [("right", True), ("left", False)])
def test_who_comes_from_the_far_side_crosses_it(side, kept) -> None:
    at = Placement(position="roadside", side=side)
    structure = s(ObjectSpec(phases=(Phase(action="enter_road"),), placement=at))
    assert ("O1.own_side" in {r.id for r in require(structure)}) is kept


@pytest.mark.parametrize(("reaction", "kept"), [("brake", True), ("evade", False)])
def test_who_gets_out_of_the_way_keeps_no_lane(reaction, kept) -> None:
    structure = s(ObjectSpec(), ego=EgoSpec(reaction=reaction, phases=(Phase(action="keep_lane"),)))
    assert ("E.phases.0.keep_lane" in {r.id for r in require(structure)}) is kept


def test_without_the_other_run_a_conflict_cannot_be_judged() -> None:
    run = Scene([ego(), LEAD]).run()
    found = {r.requirement: r for r in evaluate(require(STOPS), run.facts, run.trajectories)}
    assert found["O1.threat"].holds is None and "switched off" in found["O1.threat"].why


def test_the_reaction_is_switched_off_in_a_copy_of_s() -> None:
    changed = without_reaction(STOPS)
    assert changed is not None and changed.ego.spec.reaction == "none" and changed.objects == STOPS.objects
    assert without_reaction(s(ObjectSpec(), ego=EgoSpec(reaction="brake"))) is None


def test_after_a_run_broke_off_the_rest_is_not_reached() -> None:
    scene = Scene([ego(), other(speed=TWICE[:71])], seconds=7.0, ended_by="error", reason="at 7.0 s: KeyError")
    structure = s(ObjectSpec(phases=(Phase(action="brake"), Phase(action="stop"))))
    run = scene.run()
    found = {r.requirement: r for r in evaluate(require(structure), run.facts, run.trajectories)}
    assert found["O1.phases.0.brake"].holds is True
    assert found["O1.phases.1.stop"].holds is None and "stopped early" in found["O1.phases.1.stop"].why
    assert not whole(tuple(found.values()))


def test_of_imported_components_only_what_was_recognised_is_required() -> None:
    spec = ObjectSpec(name="lead", phases=(Phase(action="brake"),))
    plain = Structure(objects=(Component(id="O1", spec=spec, origin="imported"),))
    ids = {r.id for r in require(plain)}
    assert "O1.there" in ids and "O1.phases.0.brake" in ids
    assert not ids & {"O1.placement.position", "O1.type", "O1.dynamics", "O1.steady", "R.nobody_else"}
    kept = Structure.model_validate(plain.model_dump(mode="json"))  # as sessions and the check server hand it on
    assert {r.id for r in require(kept)} == ids


def test_of_code_by_hand_what_rests_on_the_run_alone_is_required_where_a_text_told_of_it() -> None:
    spec = ObjectSpec(name="lead", phases=(Phase(action="brake"),))
    plain = Structure(objects=(Component(id="O1", spec=spec, origin="by_hand"),))
    told = plain.model_copy(update={"text": "A car brakes ahead of ego."})
    more = {r.id for r in require(told)} - {r.id for r in require(plain)}
    assert more == {"O1.dynamics", "T.no_other_contact"}
    run = Scene([ego(), other()], contacts=(HIT,)).run().facts
    assert [c.said for c in collisions(run, require(told))] == [False]


@pytest.mark.parametrize(("speed", "holds"), [(10.0, None), (ramp((0, 10), (4, 10), (5, 7), (12, 7)), True)])
def test_a_bound_on_braking_is_not_tried_by_who_never_brakes(speed, holds) -> None:
    bound = s(ObjectSpec(), restrictions=t(Limit(kind="deceleration", maximum=5.0)))
    run = Scene([ego(speed=speed), other()]).run()
    found = {r.requirement: r for r in evaluate(require(bound), run.facts, run.trajectories)}["T.limits.0"]
    assert found.holds is holds and ("not judged" in found.why) is (holds is None)


def test_most_runs_decide_and_failures_are_told_in_a_line() -> None:
    shows, misses = Scene([ego(), other(speed=BRAKING)]).run(), Scene([ego(), other(speed=SLOWER)]).run()
    required = require(s(brakes()))
    of = [evaluate(required, r.facts, r.trajectories) for r in (shows, misses, misses)]
    found = majority(of)
    assert {r.requirement: r.holds for r in found}["O1.phases.0.brake"] is False
    assert {r.requirement: r.holds for r in majority([of[0], of[0], of[1]])}["O1.phases.0.brake"] is True
    lines = failures(required, found)
    assert len(lines) == tally(found)[1] - tally(found)[0] and any(
        line.startswith("O1 (actor): brake.") for line in lines
    )


def test_who_is_said_to_stand_somewhere_is_not_asked_to_stand_at_a_line() -> None:
    standing = ObjectSpec(phases=(Phase(action="stationary"),)), ObjectSpec(speed=0.0)
    ids = {r.id for r in require(s(*standing, ObjectSpec()))}
    assert {"O1.at_line", "O2.at_line", "O3.at_line"} & ids == {"O3.at_line"}


def test_an_unregulated_approach_may_lead_to_a_light_further_on() -> None:
    (rule,) = [r for r in require(s(place=PlaceSpec(kind="intersection", control="none"))) if r.id == "R.control"]
    assert (rule.check, rule.values["fact"], rule.values["value"]) == ("road_fact", "signalized", False)


def test_no_two_rules_share_a_name() -> None:
    names = [name for part in PARTS for name in part.CHECKS]
    assert len(names) == len(set(names)), sorted(names)


def test_ids_are_there_once_and_every_rule_is_known() -> None:
    from c2s_engine.require.judging import CHECKS

    for _, _, structure, *_ in CASES:
        required = require(structure)
        assert len({r.id for r in required}) == len(required)
        assert {r.check for r in required} <= set(CHECKS)


def test_bounds_have_sources() -> None:
    from c2s_engine.require.scene import bounds

    def leaves(table: Any) -> list[Any]:
        return [table] if "value" in table else [x for v in table.values() for x in leaves(v)]

    assert all(leaf["source"] for leaf in leaves(bounds()))


@pytest.mark.parametrize(("origin", "y", "holds"), [("rendered", 29.5, True), ("rendered", 45.0, False),
                                                    ("imported", 25.0, True), ("imported", 34.0, False)])  # fmt: skip
def test_a_distance_is_from_bumper_to_bumper_and_of_programs_from_centre_to_centre(origin, y, holds) -> None:
    acts = Phase(action="brake", trigger=Trigger(kind="distance", value=25.0))
    scene = s(ObjectSpec(name="car", type="car", placement=Placement(position="ahead"), speed=10.0, phases=(acts,)))
    scene = scene.with_component(scene["O1"].model_copy(update={"origin": origin}))
    run = Scene([ego(), other(y=y, speed=ramp((0, 10), (1, 10), (3, 2)))]).run()
    asked = [r for r in require(scene) if r.kind in ("phase", "place") and r.actor == "O1"]
    result = {r.requirement: r for r in evaluate(asked, run.facts, run.trajectories)}["O1.phases.0.trigger"]
    assert (result.holds, result.seen.split(", ")[1]) == (
        holds, "bumper to bumper" if origin == "rendered" else "centre to centre")  # fmt: skip


def test_deriving_and_judging_cost_little() -> None:
    """The median of processor time, which other load does not change: at most 30 ms a run."""
    scene = Scene([ego(), other(**CUTS_IN)]).run()
    structure = s(cuts_in(gap=8.0), ego=EgoSpec(speed=10.0, reaction="brake"),
                  restrictions=t(Limit(kind="deceleration", maximum=6.0),
                                 Limit(kind="ttc", other="O1", minimum=1.0)))  # fmt: skip
    times = []
    for _ in range(5):
        began = time.process_time()
        results = evaluate(require(structure), scene.facts, scene.trajectories)
        times.append(time.process_time() - began)
    assert len(results) > 15 and sorted(times)[2] < 0.03


def test_a_phase_that_does_not_occur_names_the_line_at_which_its_behavior_ended() -> None:
    structure = s(brakes())
    run = Scene([ego(), other()]).run()
    objects = tuple(o.model_copy(update={"line": 12 if o.component == "O1" else None}) for o in run.facts.objects)
    facts = run.facts.model_copy(update={"objects": objects})
    seen = {r.requirement: r.seen for r in evaluate(require(structure), facts, run.trajectories)}
    assert seen["O1.phases.0.brake"].endswith("; its behavior ended at line 12 of the program")


def test_ego_may_turn_right_on_red_only_after_a_stop_that_s_says() -> None:
    stop, turn = Phase(action="stop"), Phase(action="turn_right")
    ids = [{r.id for r in require(s(ego=EgoSpec(phases=p), place=RED))} for p in ((stop, turn), (turn, stop), (turn,))]
    assert ["E.obeys_light" in found for found in ids] == [False, True, True]


def test_who_follows_one_that_runs_the_light_may_pass_it_too() -> None:
    follows = tuple(ObjectSpec(phases=(Phase(action="follow", target=t),)) for t in ("O1", "O2"))
    ids = {r.id for r in require(s(ObjectSpec(phases=(Phase(action="run_red"),)), *follows, place=RED))}
    assert "O2.obeys_light" not in ids and "O3.obeys_light" in ids


def test_an_assumed_reaction_is_not_required_but_the_threat_is_judged_without_it() -> None:
    made = s(CUT_IN, ego=EgoSpec(reaction="brake"))
    note = Assumption(field="reaction", value="brake", reason="as usual")
    assumed = made.with_component(made.ego.model_copy(update={"assumed": (note,)}))
    for structure, reaction in ((made, True), (assumed, False)):
        found = {r.id: r for r in require(structure)}
        assert ("E.reaction.O1" in found) is reaction and found["O1.threat"].values["reaction"] is True
